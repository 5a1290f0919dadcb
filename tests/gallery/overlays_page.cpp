#include "gallery/gallery.h"
#include "gallery/parts.h"
#include "ui/core/node.h"

namespace lapfx::gallery {

namespace {

void draw_raised(ui::Painter& painter, const ui::Node& node, const ui::Color& ground) {
    const ui::Theme& t = painter.theme();
    painter.shadow(node.rect(), t.shadow, painter.em(1), painter.em(t.radius));
    painter.fill(node.rect(), ground, painter.em(t.radius));
    painter.frame(node.rect(), t.border, painter.hairline(), painter.em(t.radius));
}

/// The inside of an overlay that is open.
void fill_overlay(ui::Ui& ui, State& state, std::string_view name) {
    ui.draw_with<draw_raised>(ui.parent(), ui.theme().raised);
    const ui::Column column(ui, {.padding = 0.8F});
    ui::heading(ui, name);
    ui::label(ui, "Esc closes, and so does a press outside a popup.", {.tone = ui::Tone::dim});
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center, .main = ui::ChildAlign::end});
    ui::spacer(ui);
    if (ui::button(ui, "Count", {.width = ui::px(ui.em(6))})) ++state.answers;
    if (ui::button(ui, "Close", {.primary = true, .width = ui::px(ui.em(6))})) ui.close_overlay(name);
}

void opener(ui::Ui& ui, State& state, std::string_view name, ui::OverlayKind kind, ui::Placement placement) {
    const bool clicked = ui::button(ui, name);
    placement.anchor = ui.last().id;
    if (clicked) ui.open_overlay(name, kind, placement);
    if (ui.open_overlay_node(name, ui::Role::dialog, name, ui::Axis::y) == nullptr) return;
    fill_overlay(ui, state, name);
    ui.close_overlay_node();
}

}  // namespace

void overlays_page(ui::Ui& ui, State& state) {
    using Side = ui::Placement::Side;
    {
        const Part part(ui, "Popups and dialogs");
        {
            const Line line(ui, "popups");
            opener(ui, state, "Below", ui::OverlayKind::popup, {.side = Side::below});
            opener(ui, state, "Beside", ui::OverlayKind::popup, {.side = Side::right_of});
        }
        {
            const Line line(ui, "modal");
            opener(ui, state, "Dialog", ui::OverlayKind::modal, {.side = Side::center});
        }
        ui::label(ui, ui.join({"counted ", text_of(ui, state.answers)}), {.tone = ui::Tone::dim});
    }
    const Part part(ui, "Tooltips");
    const Line line(ui, "rest on them");
    ui::button(ui, "Short", {.tip = "A word"});
    ui::button(
        ui, "Long",
        {.tip = "A tooltip of several lines: it is wrapped, stays inside the window, and comes half a second after "
                "the pointer has come to rest or the keyboard has arrived."});
    ui::button(ui, "Lines", {.tip = "first line\nsecond line\nthird line"});
    ui.push_disabled(true);
    ui::button(ui, "Disabled", {.tip = "Says why it cannot be used"});
    ui.pop_disabled();
}

}  // namespace lapfx::gallery
