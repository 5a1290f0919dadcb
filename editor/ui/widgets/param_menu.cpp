// The menu of a right click on a number, and the fields that set its range.
#include "ui/core/node.h"
#include "ui/widgets/menu.h"
#include "ui/widgets/param_parts.h"

namespace lapfx::ui {

namespace {

constexpr std::string_view menu_name = "param menu", range_name = "param range";

/// Opens the menu at the pointer, or below the number if it was opened with the Menu key.
void open_at(Ui& ui, Id id, const Response& r, bool by_key) {
    using Side = Placement::Side;
    open_menu(ui, menu_name,
              by_key ? Placement{.side = Side::below, .anchor = id}
                     : Placement{.side = Side::pointer, .rect = {r.pointer.x, r.pointer.y, 0, 0}});
}

Edit put(double& value, const ParamOptions& o, double shown) {
    const double before = value;
    shown = std::max(o.hard_minimum, std::min(o.hard_maximum, o.integer ? std::round(shown) : shown));
    if (std::isfinite(shown)) value = shown / o.display;
    return value == before ? Edit{} : Edit::once();
}

Edit value_items(Ui& ui, double& value, const ParamOptions& o) {
    const double shown = value * o.display;
    Edit edit;
    if (menu_item(ui, "Reset", {.icon = Icon::reset, .shortcut = "Backspace", .enabled = !is_standard(o, shown)}))
        edit = put(value, o, *o.standard);
    if (o.initial && menu_item(ui, "Default value", {.shortcut = "Shift+Backspace", .enabled = shown != *o.initial}))
        edit = put(value, o, *o.initial);
    if (menu_item(ui, "Copy", {.icon = Icon::copy, .shortcut = "Ctrl+C"})) copy_number(ui, o, shown);
    if (menu_item(ui, "Paste", {.shortcut = "Ctrl+V", .enabled = ui.clipboard() != nullptr})) {
        if (const auto pasted = number_to_paste(ui, o, shown)) edit = put(value, o, *pasted);
    }
    return edit;
}

void action_items(Ui& ui, NumberState& s, Id id, const ParamOptions& o, ParamActions& actions) {
    menu_separator(ui);
    actions.copy_path |= menu_item(ui, "Copy path");
    actions.toggle_lock |= menu_item(ui, "Lock", {.icon = Icon::lock, .checked = o.locked});
    actions.toggle_favourite |= menu_item(ui, "Favourite", {.icon = Icon::star, .checked = o.favourite});
    if (menu_item(ui, "Set range...")) {
        s.range_of = id;
        const double more = o.maximum - o.minimum;  // fixed now, because the fields must not change under the pointer
        s.range_shown = {o.minimum - more, o.maximum + more};
        ui.open_overlay(range_name, OverlayKind::popup, {.side = Placement::Side::below, .anchor = id});
    }
}

void range_box(Ui& ui, const NumberState& s, const ParamOptions& o, ParamActions& actions) {
    Node* box = ui.open_overlay_node(range_name, Role::dialog, "Range", Axis::y);
    if (box == nullptr) return;
    box->size[0] = px(ui.em(18));
    box->gap = ui.em(ui.theme().gap);
    for (std::uint8_t& pad : box->padding) pad = static_cast<std::uint8_t>(std::min(ui.em(ui.theme().padding), 255.0F));
    ui.draw_with<draw_popup>(*box, true);
    ParamLimits range{o.minimum, o.maximum};
    ParamOptions low{.minimum = s.range_shown.low, .maximum = s.range_shown.high, .step = o.step, .unit = o.unit};
    low.integer = o.integer, low.hard_minimum = o.hard_minimum, low.hard_maximum = o.hard_maximum;
    ParamOptions high = low;
    const double least = step_of(o, 0);  // so that the range is never empty
    low.hard_maximum = std::min(low.hard_maximum, range.high - least);
    high.hard_minimum = std::max(high.hard_minimum, range.low + least);
    Edit edit = param(ui, "From", range.low, low);
    edit |= param(ui, "To", range.high, high);
    if (edit) actions.range = range;
    ui.close_overlay_node();
}

}  // namespace

Edit param_menu(Ui& ui, NumberState& s, Id id, const Response& r, std::string_view label, double& value,
                const ParamOptions& o, ParamActions* actions) {
    if (r.context) {
        bool by_key = false;
        ui.events_of(id, [&](const Event& event) { by_key |= event.kind == EventKind::key; });
        s.menu_of = id;
        open_at(ui, id, r, by_key);
    }
    Edit edit;
    if (s.menu_of == id) {
        const std::string_view name = ui.join({split_label(label).name, " menu"});
        if (Menu menu(ui, menu_name, name); menu) {
            edit = value_items(ui, value, o);
            if (actions != nullptr) action_items(ui, s, id, o, *actions);
        }
    }
    if (s.range_of == id && actions != nullptr) range_box(ui, s, o, *actions);
    return edit;
}

}  // namespace lapfx::ui
