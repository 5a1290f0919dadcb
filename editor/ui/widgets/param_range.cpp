// Several numbers in one row.
#include <cmath>

#include "ui/core/node.h"
#include "ui/widgets/param_parts.h"

namespace lapfx::ui {

namespace {

constexpr float least_zone = 0.15F;   // each handle has at least this part of the field
constexpr float beside_value = 1.6F;  // em: a letter, the gap to the number, and both ends of the field
constexpr float least_field = 3.8F;   // em: a letter and a number of three digits

struct RangeLook {
    LabelLook label;
    NumberText text[2] = {};
    float place[2] = {};
    bool lit[2] = {};
    const EntryLook* entry[2] = {};
};

void draw_range(Painter& painter, const Node& node, const RangeLook& look) {
    const Theme& t = painter.theme();
    const bool disabled = look.label.disabled;
    Rect row = node.rect();
    const Rect field = field_part(row, true);
    draw_param_label(painter, row.cut_left(field.x - row.x), look.label);
    draw_field(painter, field, look.label.disabled ? Is::disabled : Is::nothing);
    const Rect bar = field.inset(painter.hairline());
    const float x[2] = {std::round(bar.w * look.place[0]), std::round(bar.w * look.place[1])};
    if (!disabled && x[1] > x[0])
        painter.fill({bar.x + x[0], bar.y, x[1] - x[0], bar.h}, t.accent_ground, painter.em(t.radius));
    for (int i = 0; i < 2 && !disabled; ++i)
        draw_param_mark(painter, bar, x[i], 3 * painter.hairline(), look.lit[i] ? t.text : t.accent);
    for (int i = 0; i < 2; ++i) {
        Rect half = field;
        i == 0 ? half = half.cut_left(field.w / 2) : half.cut_left(field.w / 2);
        if (look.entry[i] != nullptr) {
            draw_entry(painter, half, *look.entry[i]);
        } else {
            draw_number(painter, half.inset(painter.em(param_inner), 0), look.text[i],
                        i == 0 ? Align::start : Align::end, disabled);
        }
    }
}

void draw_row_label(Painter& painter, const Node& node, const LabelLook& look) {
    Rect row = node.rect();
    draw_param_label(painter, row.cut_left(std::round(row.w * caption_share)), look);
}

/// The label of several numbers: a double click on it sets all of them to their standards.
bool put_name(Ui& ui, const ParamOptions& o) {
    Node& node = ui.leaf(Role::label, "##name", Sense::hover | Sense::press);
    node.tip = ui.copy(o.tip);
    node.size[0] = fraction(caption_share);
    node.size[1] = grow();
    const Response r = ui.respond(node);
    return r.pressed && r.clicks == 2;
}

/// Opens the row. Returns its rectangle in the last build.
Rect open_row(Ui& ui, Role role, std::string_view label, const ParamOptions& o) {
    Node& node = ui.open(role, label, Axis::x, Sense::hover);
    node.size[0] = o.width;
    node.size[1] = px(ui.row_height());
    node.minimum[0] = ui.em(9);
    node.tip = ui.copy(o.tip);
    ui.respond(node);
    return ui.rect_before(node.id);
}

/// What happened to a handle in this build.
struct Handle {
    Id id = 0;
    NumberState* state = nullptr;
    Response response = {};
    Edit edit = {};
    bool typing() const { return state != nullptr && state->typing == id; }
};

Handle put_handle(Ui& ui, int index, float way, double& value, const ParamOptions& o, RangeLook& look) {
    Node& node = ui.leaf(Role::handle, index == 0 ? "Low" : "High", number_sense);
    Handle handle{.id = node.id, .state = number_state(ui, node.id)};
    if (handle.state != nullptr) {
        handle.response = ui.respond(node);
        const Rect zone = ui.rect_before(node.id);
        handle.edit = NumberGesture(ui, node.id, o, value, zone, way).take(*handle.state, handle.response);
    }
    const double shown = value * o.display;
    look.text[index] = number_text(ui, o, shown);
    describe_number(ui, node, handle.state, o, shown, look.text[index]);
    look.label.changed |= has(node.is, Is::changed);
    look.lit[index] = has(node.is, Is::hovered) || has(node.is, Is::held) || has(node.is, Is::focused);
    look.place[index] = place_of_param(o, shown);
    look.entry[index] = handle.typing() ? ui.arena().make(handle.state->entry.look(ui)) : nullptr;
    return handle;
}

/// Puts a handle over from..to, the part of the field that is nearer to it than to the other handle.
void place_handle(Ui& ui, Node& node, float from, float to) {
    const float field = 1 - caption_share;
    node.placed = true;
    node.placement = ui.arena().make(Placement{.fraction = {caption_share + field * from, 0}});
    node.size[0] = fraction(field * (to - from));
    node.size[1] = fraction(1);
}

ParamOptions with_standard(ParamOptions o, std::span<const double> standards, std::size_t i) {
    if (i < standards.size()) o.standard = standards[i];
    if (i < o.initials.size()) o.initial = o.initials[i];
    return o;
}

Edit reset(double& value, const ParamOptions& o) {
    if (!o.standard || is_standard(o, value * o.display)) return {};
    value = *o.standard / o.display;
    return Edit::once();
}

/// px that a letter and the longest of these numbers take, without decimals: those are left out where there is no room.
float widest_value(Ui& ui, std::span<const double> values, const ParamOptions& o) {
    float width = ui.em(least_field);
    for (const double value : values) {
        char buffer[64];
        width = std::max(width, ui.text_width(format_number(buffer, value * o.display, 0)) + ui.em(beside_value));
    }
    return width;
}

}  // namespace

Edit range_param(Ui& ui, std::string_view label, double& low, double& high, const ParamOptions& options,
                 std::span<const double> standards) {
    const ParamOptions o = sound(options);
    const Rect row = open_row(ui, Role::range, label, o);
    const bool to_standard = put_name(ui, o);
    ParamOptions of_low = with_standard(o, standards, 0), of_high = with_standard(o, standards, 1);
    Edit edit;
    if (to_standard && !ui.disabled()) edit |= reset(low, of_low), edit |= reset(high, of_high);
    of_low.hard_maximum = std::min(o.hard_maximum, high * o.display);
    RangeLook look{.label = {.locked = o.locked, .disabled = ui.disabled()}};
    const float way = field_part(row, true).w;
    Handle handles[2];
    handles[0] = put_handle(ui, 0, way, low, of_low, look);
    of_high.hard_minimum = std::max(o.hard_minimum, low * o.display);
    handles[1] = put_handle(ui, 1, way, high, of_high, look);
    const bool typing = handles[0].typing() || handles[1].typing();
    const float between = typing ? 0.5F : std::clamp((look.place[0] + look.place[1]) / 2, least_zone, 1 - least_zone);
    Node* const newest = &ui.last();
    place_handle(ui, newest[-1], 0, between);
    place_handle(ui, newest[0], between, 1);
    Node& node = ui.parent();
    look.label.text = node.shown;
    node.text = ui.join({look.text[0].number, " \u2013 ", look.text[1].whole});
    node.is |= when(look.label.changed, Is::changed) | when(o.locked, Is::locked);
    ui.draw_with<draw_range>(node, look);
    edit |= handles[0].edit, edit |= handles[1].edit;
    for (int i = 0; i < 2; ++i) {
        Handle& h = handles[i];
        if (h.state == nullptr || h.typing()) continue;
        edit |= param_menu(ui, *h.state, h.id, h.response, i == 0 ? "Low" : "High", i == 0 ? low : high,
                           i == 0 ? of_low : of_high, nullptr);
    }
    ui.close();
    return edit;
}

Edit vector_param(Ui& ui, std::string_view label, std::span<double> values, const ParamOptions& options,
                  std::span<const double> standards, std::string_view letters) {
    const Rect row = open_row(ui, Role::group, label, options);
    const std::size_t count = std::min(values.size(), letters.size());
    // In a narrow panel the numbers would have no room side by side, so they are one below the other.
    const float each = row.w * (1 - caption_share) / static_cast<float>(std::max<std::size_t>(count, 1));
    const bool stacked = row.w > 0 && each < widest_value(ui, values.first(count), options);
    if (stacked) ui.parent().size[1] = fit();
    ui.follow_size(ui.parent());
    const bool to_standard = put_name(ui, options);
    // Gaps are only between the numbers, so that the first begins at the same place as in other rows.
    Node& fields = ui.open(Role::none, {}, stacked ? Axis::y : Axis::x);
    fields.size[0] = grow();
    fields.gap = ui.em(0.2F);
    LabelLook look{.locked = options.locked, .disabled = ui.disabled()};
    Edit edit;
    for (std::size_t i = 0; i < count; ++i) {
        const ParamOptions one = with_standard(options, standards, i);
        if (to_standard && !ui.disabled()) edit |= reset(values[i], one);
        edit |= number_field(ui, letters.substr(i, 1), values[i], one);
        look.changed |= !is_standard(one, values[i] * one.display);
    }
    ui.close();
    Node& node = ui.parent();
    look.text = node.shown;
    node.is |= when(look.changed, Is::changed) | when(options.locked, Is::locked);
    ui.draw_with<draw_row_label>(node, look);
    ui.close();
    return edit;
}

}  // namespace lapfx::ui
