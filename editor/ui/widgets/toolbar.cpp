#include "ui/widgets/toolbar.h"

#include <cmath>

#include "ui/core/node.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/field.h"

namespace lapfx::ui {

namespace {

constexpr std::string_view more = "More...";

/// Which tools are in the menu: all with a rank above `most`, and those with rank `most` from index `last` on.
struct Cut {
    int most;
    std::size_t last;
    bool shows(std::span<const ToolItem> items, std::size_t item) const {
        return items[item].width > 0 && (items[item].rank < most || (items[item].rank == most && item < last));
    }
};

float width_of(const Ui& ui, std::span<const ToolItem> items, const Cut& cut) {
    float width = 0;
    for (std::size_t i = 0; i < items.size(); ++i)
        if (cut.shows(items, i)) width += items[i].width + ui.em(ui.theme().gap);
    return width;
}

/// Moves one tool after the other from the row into the menu until the row fits.
Cut cut_for(Ui& ui, std::span<const ToolItem> items, float room) {
    Cut cut{0, items.size()};
    for (const ToolItem& item : items) cut.most = std::max(cut.most, item.rank);
    if (room <= 0 || width_of(ui, items, cut) <= room) return cut;
    room -= tool_width(ui, more);
    while (width_of(ui, items, cut) > room && cut.most >= 0) {
        if (cut.last > 0)
            --cut.last;
        else
            --cut.most, cut.last = items.size();
    }
    return cut;
}

/// Whether `node`, just built, is a button that was pressed. A button in the menu closes it; other widgets leave it
/// open.
bool chosen(Ui& ui, const Node& node) {
    if (node.role != Role::button) return false;
    bool pressed = false;
    ui.events_of(node.id, [&](const Event& event) {
        pressed |= event.kind == EventKind::release && event.button == Button::left &&
                   ui.rect_before(node.id).contains(event.at);
        pressed |= event.kind == EventKind::key && (event.key == Key::enter || event.key == Key::space);
    });
    return pressed;
}

}  // namespace

float tool_width(Ui& ui, std::string_view text, bool icon) {
    return std::ceil(ui.text_width(split_label(text).shown)) + (icon ? ui.em(1.4F) : 0.0F) + 2 * ui.em(0.7F);
}

void toolbar(Ui& ui, std::string_view label, float room, std::span<const ToolItem> items,
             const FunctionRef<void(std::size_t)>& build) {
    const Cut cut = cut_for(ui, items, room);
    const std::string_view name = ui.join({"tools of ", label});
    bool hidden = false, at_end = false;
    Id anchor = 0;
    {
        const Row row(ui, {.width = grow(), .cross = ChildAlign::center});
        for (std::size_t i = 0; i < items.size(); ++i) {
            if (items[i].end && !at_end) spacer(ui), at_end = true;
            if (cut.shows(items, i)) build(i);
            hidden |= items[i].width > 0 && !cut.shows(items, i);
        }
        if (hidden) {
            const bool opens = button(ui, more, {.tip = "The tools that do not fit here"});
            anchor = ui.last().id;
            if (opens) ui.open_overlay(name, OverlayKind::popup, {.side = Placement::Side::below, .anchor = anchor});
        }
    }
    if (!hidden) return;
    Node* const menu = ui.open_overlay_node(name, Role::group, label, Axis::y);
    if (menu == nullptr) return;
    menu->gap = ui.em(ui.theme().gap);
    menu->cross = ChildAlign::start;
    for (std::uint8_t& pad : menu->padding)
        pad = static_cast<std::uint8_t>(std::min(ui.em(ui.theme().padding), 255.0F));
    ui.draw_with<draw_popup>(*menu, true);
    bool done = false;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (items[i].width <= 0 || cut.shows(items, i)) continue;
        build(i);
        done |= chosen(ui, ui.last());
    }
    ui.close_overlay_node();
    if (done && ui.overlay_on_top(name)) ui.close_overlay(name);  // an overlay that the button has opened stays
}

}  // namespace lapfx::ui
