// A colour that a picker wants is taken from the pictures of the view and of the reference panel.
#include "app/base/layouts.h"
#include "app/preview/pick_color.h"
#include "app/preview/preview_host.h"
#include "panels/edited.h"
#include "panels/parts.h"
#include "ui/canvas/pixels.h"
#include "ui/canvas/viewport.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

namespace {

/// The box beside the pointer, over the picture of the view.
struct Loupe {
    ui::Readout readout;
    glm::ivec2 size{1};  ///< px of the picture
};

void draw_loupe(ui::Painter& painter, const ui::Node& node, const Loupe& loupe) {
    const ui::Rect area = node.rect();
    const ui::View view{.area = area,
                        .size = loupe.size,
                        .zoom = static_cast<double>(area.w) / loupe.size.x,
                        .corner = glm::dvec2(area.at())};
    ui::draw_readout(painter, view, loupe.readout);
}

constexpr std::string_view hint_name = "Pick a colour";

void put_loupe(ui::Ui& ui, const app::PreviewHost& preview, ui::Color picked, glm::ivec2 at, glm::ivec2 view,
               const ui::Rect& keep_off) {
    Loupe loupe{.readout = {.image = preview.picture(),
                            .size = preview.size(),
                            .at = at,
                            .side = app::picked_side,
                            .keep_off = keep_off},
                .size = preview.size()};
    loupe.readout.lines[0] = ui::picked_text(ui, picked, at);
    loupe.readout.line_count = 1;
    loupe.readout.swatch = picked;
    ui::Node& node = ui.leaf(ui::Role::status, "Loupe");
    node.text = loupe.readout.lines[0];
    node.placed = true;
    node.placement = ui.arena().make(ui::Placement{});
    node.size[0] = ui::px(static_cast<float>(view.x)), node.size[1] = ui::px(static_cast<float>(view.y));
    ui.draw_with<draw_loupe>(node, loupe);
}

}  // namespace

ui::Rect pick_hint_rect(ui::Ui& ui, const ui::Eyedropper& eyedropper) {
    return eyedropper.wanted_by == 0 ? ui::Rect{} : ui.rect_before(ui.id_of(hint_name));
}

void pick_hint(ui::Ui& ui, ui::Eyedropper& eyedropper) {
    if (eyedropper.wanted_by == 0) return;
    const ui::Panel panel(ui, hint_name, {.width = ui::fit(), .height = ui::fit(), .padding = 0.5F});
    ui.parent().placed = true;
    ui.parent().placement =
        ui.arena().make(ui::Placement{.fraction = {0.5F, 1}, .offset = {0, -ui.em(0.8F)}, .pivot = {0.5F, 1}});
    const ui::Row row(ui, {.cross = ui::ChildAlign::center});
    ui::label(ui, "Click the colour that you want, here or in another picture");
    if (ui::button(ui, "Leave", {.tip = "Leave without picking a colour (Esc)", .quiet = true})) eyedropper = {};
}

void pick_in_view(ui::Ui& ui, const ui::ViewportResult& view, const Edited& edited, app::PreviewHost& preview) {
    if (view.hovered) ui.set_cursor(ui::Cursor::crosshair);
    bool enter = false;
    for (const ui::ViewportKey& key : view.keys) {
        enter |= key.key == ui::Key::enter;
        if (key.key != ui::Key::enter && key.key != ui::Key::escape) ui.press_shortcut(key.key, key.mods);
    }
    const bool left = view.clicked && view.button == ui::Button::left;
    if (preview.picture() == 0 || view.size.x < 1 || view.size.y < 1 || (!left && !enter && !view.hovered)) return;
    const glm::ivec2 drawn = preview.size();
    const glm::dvec2 place = enter && !left ? glm::dvec2(0.5) : glm::dvec2(view.pointer) / glm::dvec2(view.size);
    const glm::ivec2 at = glm::clamp(glm::ivec2(place * glm::dvec2(drawn)), glm::ivec2(0), drawn - 1);
    const Image& image = preview.pixels();
    const ui::Color color = app::color_around(app::ImagePixels(image), drawn, at);
    if (!left && !enter) return put_loupe(ui, preview, color, at, view.size, pick_hint_rect(ui, edited.eyedropper));
    edited.seen.clicked({.shot = preview.shown(), .size = drawn, .place = place});
    edited.eyedropper.picked = color;
    ui.build_again();
}

void follow_eyedropper(ui::Ui& ui, ui::Eyedropper& eyedropper, app::Layouts& layouts) {
    if (eyedropper.wanted_by == 0) return;
    if (ui.key_down(ui::Key::escape)) {
        eyedropper = {};
        return;
    }
    if (!layouts.seen("View") && !layouts.seen("Reference")) layouts.bring_to_front("View");
}

}  // namespace lapfx::panels
