#include "ui/widgets/param.h"

#include <charconv>
#include <cmath>

#include "ui/core/node.h"
#include "ui/widgets/param_parts.h"

namespace lapfx::ui {

namespace {

struct ParamLook {
    LabelLook label;
    NumberText text;
    bool caption;    ///< the label is next to the field, else inside
    float from, to;  ///< the bar, 0 to 1 of the field
    bool dragging;
    const EntryLook* entry;
    friend bool operator==(const ParamLook&, const ParamLook&) = default;
};

/// Draws the bar from the beginning of the range, or from 0 if that is inside, to the value. It uses no clips, because
/// a batch has room for only a few.
void draw_bar(Painter& painter, const Rect& field, const ParamLook& look, bool lit) {
    const Theme& t = painter.theme();
    const float from = whole(field.w * std::min(look.from, look.to));
    const float to = whole(field.w * std::max(look.from, look.to)), place = whole(field.w * look.to);
    if (to > from) painter.fill({field.x + from, field.y, to - from, field.h}, t.accent_ground, painter.em(t.radius));
    draw_param_mark(painter, field, place, 2 * painter.hairline(), lit ? t.accent_hover : t.accent);
}

void draw_param(Painter& painter, const Node& node, const ParamLook& look) {
    const Theme& t = painter.theme();
    const bool disabled = look.label.disabled, lit = !disabled && (has(node.is, Is::hovered) || look.dragging);
    const Rect field = field_part(node.rect(), look.caption);
    if (look.caption) {
        Rect column = node.rect();
        draw_param_label(painter, column.cut_left(field.x - column.x), look.label);
    }
    if (look.entry != nullptr) return draw_entry(painter, field, *look.entry);
    draw_field(painter, field, node.is);
    if (look.dragging) painter.frame(field, t.accent, painter.hairline(), painter.em(t.radius));
    const bool room = look.caption || field.w >= painter.em(7);  // otherwise only the number fits
    if (!disabled && room) draw_bar(painter, field.inset(painter.hairline()), look, lit);
    Rect inside = field.inset(painter.em(look.caption ? param_inner : 0.35F), 0);
    if (!look.caption) {
        const float number = painter.fonts().run(look.text.number, painter.number_style()).width;
        // A label of one letter stays: it says which of several numbers this is, which matters more than last digits.
        const bool letter = look.label.text.size() == 1;
        const float least =
            letter ? std::ceil(painter.fonts().run(look.label.text, painter.text_style()).width) + painter.em(0.3F) : 0;
        Rect prefix = inside.cut_left(std::max(least, inside.w - std::ceil(number) - painter.em(0.3F)));
        const float width =
            painter.text(prefix, look.label.text, painter.text_style(), disabled ? t.text_disabled : t.text_dim);
        prefix.cut_left(width + painter.em(0.3F));
        inside = {prefix.x, inside.y, inside.right() - prefix.x, inside.h};
    }
    draw_number(painter, inside, look.text, Align::end, disabled);
}

bool elided(Ui& ui, const Node& node) {
    const float column = whole(ui.rect_before(node.id).w * caption_share) - ui.em(caption_inset) - ui.em(0.9F);
    return column > 0 && ui.text_width(node.shown) > column;
}

/// One number, with its label next to it or inside.
Edit put_param(Ui& ui, std::string_view label, double& value, const ParamOptions& options, bool caption,
               ParamActions* actions) {
    const ParamOptions o = sound(options);
    Node& node = ui.leaf(Role::slider, label, number_sense);
    const Id id = node.id;
    NumberState* const state = number_state(ui, id);
    Response r;
    Edit edit;
    if (state != nullptr) {
        r = ui.respond(node);
        const Rect field = field_part(ui.rect_before(id), caption);
        edit = NumberGesture(ui, id, o, value, field, field.w).take(*state, r);
    }
    const double shown = value * o.display;
    const NumberText text = number_text(ui, o, shown);
    node.size[0] = o.width;
    node.size[1] = px(ui.row_height());
    node.minimum[0] = ui.em(caption ? 9.0F : 2.5F);
    const bool whole_label = (has(node.is, Is::hovered) || has(node.is, Is::ringed)) && caption && elided(ui, node);
    describe_number(ui, node, state, o, shown, text);
    if (whole_label && !has(node.is, Is::invalid))
        node.tip = node.tip.empty() ? node.shown : ui.join({node.shown, "\n", node.tip});
    const bool typing = state != nullptr && state->typing == id;
    const bool around_zero = o.minimum < 0 && o.maximum > 0;
    ui.draw_with<draw_param>(
        node, ParamLook{.label = {node.shown, has(node.is, Is::changed), o.locked, has(node.is, Is::disabled)},
                        .text = text,
                        .caption = caption,
                        .from = around_zero ? place_of_param(o, 0) : 0,
                        .to = place_of_param(o, shown),
                        .dragging = state != nullptr && state->held == id && state->dragging,
                        .entry = typing ? ui.arena().make(state->entry.look(ui)) : nullptr});
    if (state != nullptr && !typing) edit |= param_menu(ui, *state, id, r, label, value, o, actions);
    return edit;
}

}  // namespace

float place_of_param(const ParamOptions& o, double shown) {
    const double place = ValueRange{o.minimum, o.maximum, o.scale, o.smallest}.place_of(shown);
    return std::isfinite(place) ? static_cast<float>(std::clamp(place, 0.0, 1.0)) : 0.0F;
}

NumberText number_text(Ui& ui, const ParamOptions& o, double shown) {
    if (shown == 0 && !o.zero.empty()) {
        const std::string_view zero = ui.copy(o.zero);
        return {zero, zero.substr(zero.size()), zero};
    }
    char buffer[32];
    const std::string_view number = std::isnan(shown) ? "not a number" : format_param(buffer, o, shown);
    std::string_view unit = o.unit;
    if (unit == "deg") unit = "\u00B0";
    const bool close = unit == "\u00B0" || unit == "%";
    const std::string_view whole = ui.join({number, unit.empty() || close ? "" : " ", unit});
    return {whole.substr(0, number.size()), whole.substr(whole.size() - unit.size()), whole};
}

void describe_number(Ui& ui, Node& node, const NumberState* state, const ParamOptions& o, double shown,
                     const NumberText& text) {
    const bool typing = state != nullptr && state->typing == node.id;
    node.number = ui.number(shown, o.minimum, o.maximum, o.step);
    node.text = text.whole;
    node.tip = ui.copy(o.tip);
    node.is |= when(!is_standard(o, shown), Is::changed) | when(o.locked, Is::locked);
    if (!typing) return;
    node.sense = has(node.is, Is::disabled) ? node.sense : entry_sense;
    node.text = ui.copy(state->entry.text());
    if (state->entry.valid()) {
        if (state->entry.modified())
            if (const std::string told = beyond_limits(o, state->entry.value()); !told.empty())
                ui.explain(node.id, told);
        return;
    }
    node.is |= Is::invalid;
    node.tip = ui.copy(state->entry.reason());
    ui.explain(node.id, state->entry.reason());
}

void draw_param_label(Painter& painter, Rect column, const LabelLook& look) {
    const Theme& t = painter.theme();
    column.cut_left(painter.em(caption_inset));
    const Rect dot = column.cut_right(painter.em(0.9F)).inset(painter.em(0.1F), 0);
    if (look.changed) painter.icon(dot, Icon::dot, look.disabled ? t.text_disabled : t.accent);
    if (look.locked)
        painter.icon(column.cut_right(painter.em(0.9F)), Icon::lock, look.disabled ? t.text_disabled : t.text_dim);
    // Of "Group: Name" the name stays where there is no room for both; the tooltip has all of it.
    std::string_view text = look.text;
    if (const std::size_t group = text.find(": ");
        group != std::string_view::npos && painter.fonts().run(text, painter.text_style()).width > column.w)
        text.remove_prefix(group + 2);
    painter.text(column, text, painter.text_style(), look.disabled ? t.text_disabled : t.text);
}

void draw_param_mark(Painter& painter, const Rect& field, float place, float width, Color color) {
    const float x = std::clamp(place - std::floor(width / 2), 0.0F, std::max(0.0F, field.w - width));
    const float height = std::floor(field.h / 2 - painter.em(0.43F));  // below the digits
    painter.fill({field.x + x, field.bottom() - height, width, height}, color);
}

/// Rounded to so many decimals as there is room for: a number without its end would be another one.
std::string_view fitted(Painter& painter, std::string_view number, const TextStyle& style, float room,
                        std::span<char> buffer) {
    const std::size_t point = number.find('.');
    if (point == number.npos || painter.fonts().run(number, style).width <= room + 0.5F) return number;
    double value = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (error != std::errc() || end != number.data() + number.size()) return number;
    for (int decimals = static_cast<int>(number.size() - point) - 2; decimals >= 0; --decimals) {
        const std::string_view shorter = format_number(buffer, value, decimals);
        if (value != 0 && shorter.find_first_of("123456789") == shorter.npos) break;  // 0.04 is not 0
        if (painter.fonts().run(shorter, style).width <= room + 0.5F) return shorter;
    }
    return number;
}

/// Draws the number and its unit. Where there is no room for both, the unit is left out.
void draw_number(Painter& painter, Rect inside, const NumberText& text, Align align, bool disabled) {
    const Theme& t = painter.theme();
    const Color ink = disabled ? t.text_disabled : t.text, quiet = disabled ? t.text_disabled : t.text_dim;
    const TextStyle style = painter.text_style(), digits = painter.number_style();
    const bool close = text.whole.size() == text.number.size() + text.unit.size();
    char buffer[64];
    const std::string_view written = fitted(painter, text.number, digits, inside.w, buffer);
    const Run& number = painter.fonts().run(written, digits);
    const Run* unit = text.unit.empty() ? nullptr : &painter.fonts().run(text.unit, style);
    const float gap = close ? 0 : painter.em(0.25F), unit_width = unit != nullptr ? std::ceil(unit->width) + gap : 0;
    const bool both = unit != nullptr && std::ceil(number.width) + unit_width <= inside.w;
    if (align == Align::end) {
        if (both) painter.text(inside.cut_right(unit_width), text.unit, *unit, style, quiet, Align::end);
        painter.text(inside, written, number, digits, ink, Align::end);
    } else {
        painter.text(both ? inside.cut_left(std::ceil(number.width)) : inside, written, number, digits, ink);
        inside.cut_left(gap);
        if (both) painter.text(inside, text.unit, *unit, style, quiet);
    }
}

Edit param(Ui& ui, std::string_view label, double& value, const ParamOptions& options, ParamActions* actions) {
    return put_param(ui, label, value, options, true, actions);
}

Edit param(Ui& ui, std::string_view label, float& value, const ParamOptions& options, ParamActions* actions) {
    ParamOptions single = options;
    single.single = true;
    double v = static_cast<double>(value);
    const Edit edit = put_param(ui, label, v, single, true, actions);
    if (edit) value = static_cast<float>(v);
    return edit;
}

Edit param(Ui& ui, std::string_view label, int& value, const ParamOptions& options, ParamActions* actions) {
    using Limits = std::numeric_limits<int>;
    ParamOptions whole = options;
    whole.integer = true;
    whole.hard_minimum = std::max<double>(options.hard_minimum, Limits::min());
    whole.hard_maximum = std::min<double>(options.hard_maximum, Limits::max());
    double v = value;
    const Edit edit = put_param(ui, label, v, whole, true, actions);
    if (edit) value = static_cast<int>(std::lround(v));
    return edit;
}

Edit number_field(Ui& ui, std::string_view label, double& value, const ParamOptions& options) {
    return put_param(ui, label, value, options, false, nullptr);
}

}  // namespace lapfx::ui
