#include <array>

#include "gallery/gallery.h"
#include "gallery/parts.h"
#include "ui/core/node.h"

namespace lapfx::gallery {

namespace {

struct IconLook {
    ui::Icon icon;
};

/// Draws an icon at three sizes, in three tones.
void draw_icon(ui::Painter& painter, const ui::Node& node, const IconLook& look) {
    const ui::Theme& t = painter.theme();
    ui::Rect rect = node.rect();
    const std::array<std::pair<float, ui::Color>, 3> sizes = {
        {{1.0F, t.text_dim}, {1.5F, t.text}, {2.5F, t.text_link}}};
    for (const auto& [size, color] : sizes) {
        const float side = painter.em(size);
        painter.icon(rect.cut_left(side), look.icon, color);
        rect.cut_left(painter.em(0.5F));
    }
}

}  // namespace

void icons_page(ui::Ui& ui, State&) {
    constexpr std::size_t columns = 4;
    const Part part(ui, "Icons");
    for (std::size_t first = 1; first < ui::icon_count; first += columns) {  // the first is none
        const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
        for (std::size_t i = first; i < std::min(first + columns, ui::icon_count); ++i) {
            const auto icon = static_cast<ui::Icon>(i);
            const ui::Row cell(ui, {.width = ui::px(ui.em(13)), .cross = ui::ChildAlign::center});
            ui::Node& node = ui.leaf(ui::Role::image, name_of(icon), ui::Sense::hover);
            node.size[0] = ui::px(ui.em(6.2F));
            node.size[1] = ui::px(ui.em(2.7F));
            node.tip = name_of(icon);
            ui.respond(node);
            ui.draw_with<draw_icon>(node, IconLook{icon});
            ui::label(ui, name_of(icon), {.tone = ui::Tone::dim});
        }
    }
}

}  // namespace lapfx::gallery
