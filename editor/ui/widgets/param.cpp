#include "ui/widgets/param.h"

#include <cmath>

#include "ui/widgets/param_parts.h"

namespace lapfx::ui {

namespace {

constexpr float inner = 0.45F;  // em between a field's edge and its text

struct ParamLook {
    LabelLook label;
    NumberText text;
    float share;     ///< of the label's column; 0: the label is inside the field
    float from, to;  ///< the bar, 0 to 1 of the field
    bool dragging;
    const EntryLook* entry;
};

/// The bar from the range's begin, or from 0 where that lies within, to the value.
void draw_bar(Painter& painter, const Rect& field, const ParamLook& look, bool lit) {
    const Theme& t = painter.theme();
    const float from = std::round(field.w * std::min(look.from, look.to));
    const float to = std::round(field.w * std::max(look.from, look.to));
    const float edge = 2 * painter.hairline(), place = std::round(field.w * look.to);
    const Color mark = lit ? t.accent_hover : t.accent;
    if (to > from) {
        painter.push_clip({field.x + from, field.y, to - from, field.h});
        painter.fill(field, t.accent_ground, painter.em(t.radius));
        painter.pop_clip();
    }
    painter.push_clip(
        {field.x + std::clamp(place - edge / 2, 0.0F, std::max(0.0F, field.w - edge)), field.y, edge, field.h});
    painter.fill(field, mark, painter.em(t.radius));
    painter.pop_clip();
}

void draw_param(Painter& painter, const Node& node, const ParamLook& look) {
    const Theme& t = painter.theme();
    const bool disabled = look.label.disabled, lit = !disabled && (has(node.is, Is::hovered) || look.dragging);
    const Rect field = param_field_of(node.rect(), look.share);
    if (look.share > 0) {
        Rect column = node.rect();
        draw_param_label(painter, column.cut_left(field.x - column.x), look.label);
    }
    if (look.entry != nullptr) return draw_entry(painter, field, *look.entry);
    painter.fill(field, lit ? t.field_hover : t.field, painter.em(t.radius));
    if (!disabled) draw_bar(painter, field, look, lit);
    if (look.dragging) painter.frame(field, t.accent, painter.hairline(), painter.em(t.radius));
    Rect inside = field.inset(painter.em(inner), 0);
    if (look.share == 0) {
        const TextStyle style = painter.text_style();
        inside.cut_left(painter.text(inside, look.label.text, style, disabled ? t.text_disabled : t.text_dim));
        inside.cut_left(painter.em(0.3F));
    }
    draw_number(painter, inside, look.text, Align::end, disabled);
}

bool elided(Ui& ui, const Node& node, float share) {
    const float column = std::round(ui.rect_before(node.id).w * share) - ui.em(1);
    return share > 0 && column > 0 && ui.text_width(node.shown) > column;
}

/// One number, with its label beside it or inside.
Edit put_param(Ui& ui, std::string_view label, double& value, const ParamOptions& o, float share,
               ParamActions* actions) {
    Node& node = ui.leaf(Role::slider, label, number_sense);
    const Id id = node.id;
    const Rect field = param_field_of(ui.rect_before(id), share);
    NumberState* const state = number_state(ui, id);
    Response r;
    Edit edit;
    if (state != nullptr) {
        r = ui.respond(node);
        edit = NumberGesture(ui, id, o, value, field, field.w).take(*state, r);
    }
    const double shown = value * o.display;
    const NumberText text = number_text(ui, o, shown);
    node.size[0] = o.width;
    node.size[1] = px(ui.row_height());
    node.minimum[0] = ui.em(share > 0 ? 9 : 4);
    const bool whole_label = (has(node.is, Is::hovered) || has(node.is, Is::ringed)) && elided(ui, node, share);
    describe_number(ui, node, state, o, shown, text);
    if (whole_label && !has(node.is, Is::invalid))
        node.tip = node.tip.empty() ? node.shown : ui.join({node.shown, "\n", node.tip});
    const bool typing = state != nullptr && state->typing == id;
    const bool around_zero = o.minimum < 0 && o.maximum > 0;
    ui.draw_with<draw_param>(
        node, ParamLook{.label = {node.shown, has(node.is, Is::changed), o.locked, has(node.is, Is::disabled)},
                        .text = text,
                        .share = share,
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
    char buffer[32];
    const std::string_view number = std::isnan(shown) ? "no number" : format_param(buffer, o, shown);
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
    if (state->entry.valid()) return;
    node.is |= Is::invalid;
    node.tip = ui.copy(state->entry.reason());
}

void draw_param_label(Painter& painter, Rect column, const LabelLook& look) {
    const Theme& t = painter.theme();
    Rect mark = column.cut_right(painter.em(0.9F));
    if (look.changed)
        painter.icon(mark.inset(painter.em(0.1F), 0), Icon::dot, look.disabled ? t.text_disabled : t.accent);
    if (look.locked)
        painter.icon(column.cut_right(painter.em(1)).inset(painter.em(0.05F), 0), Icon::lock,
                     look.disabled ? t.text_disabled : t.text_dim);
    painter.text(column, look.text, painter.text_style(), look.disabled ? t.text_disabled : t.text);
}

void draw_number(Painter& painter, Rect inside, const NumberText& text, Align align, bool disabled) {
    const Theme& t = painter.theme();
    const TextStyle style = painter.text_style(), digits = painter.number_style();
    const bool close = text.whole.size() == text.number.size() + text.unit.size();
    const float gap = close ? 0 : painter.em(0.25F);
    if (align == Align::end) {
        if (!text.unit.empty()) {
            inside.cut_right(
                painter.text(inside, text.unit, style, disabled ? t.text_disabled : t.text_dim, Align::end));
            inside.cut_right(gap);
        }
        painter.text(inside, text.number, digits, disabled ? t.text_disabled : t.text, Align::end);
        return;
    }
    inside.cut_left(painter.text(inside, text.number, digits, disabled ? t.text_disabled : t.text));
    inside.cut_left(gap);
    painter.text(inside, text.unit, style, disabled ? t.text_disabled : t.text_dim);
}

Edit param(Ui& ui, std::string_view label, double& value, const ParamOptions& options, ParamActions* actions) {
    return put_param(ui, label, value, options, param_label_share, actions);
}

Edit param(Ui& ui, std::string_view label, float& value, const ParamOptions& options, ParamActions* actions) {
    ParamOptions single = options;
    single.single = true;
    double v = static_cast<double>(value);
    const Edit edit = put_param(ui, label, v, single, param_label_share, actions);
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
    const Edit edit = put_param(ui, label, v, whole, param_label_share, actions);
    if (edit) value = static_cast<int>(std::lround(v));
    return edit;
}

Edit number_field(Ui& ui, std::string_view label, double& value, const ParamOptions& options) {
    return put_param(ui, label, value, options, 0, nullptr);
}

}  // namespace lapfx::ui
