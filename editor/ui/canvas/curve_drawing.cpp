#include "ui/canvas/curve_drawing.h"

#include "ui/core/node.h"

namespace lapfx::ui::curve_drawing {

namespace {

void draw_curve(Painter& p, const Frame& f, const Curve& curve, float width, Color color) {
    const auto at = [&](double x, double y) { return glm::vec2(f.x.px_of(x), f.y.px_of(y)); };
    const CurvePoint &first = curve.point(0), &last = curve.point(curve.size() - 1);
    p.line(at(f.x.span.low, first.y), at(first.x, first.y), width, color);
    p.line(at(last.x, last.y), at(f.x.span.high, last.y), width, color);
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const CurvePoint &a = curve.point(i), &b = curve.point(i + 1);
        p.line(at(a.x, a.y), at(b.x, b.y), width, color);
    }
}

void draw_axes(Painter& p, const Frame& f, const CurveEditorOptions& o) {
    const Theme& t = p.theme();
    char buffer[32];
    const Ticks x = ticks(o.x.low, o.x.high, std::max(1, static_cast<int>(f.graph.w / p.em(4))));
    for (int i = 0; i < x.count; ++i) {
        const double value = x.first + x.step * i;
        const float at = whole(f.x.px_of(value));
        p.fill({at, f.graph.y, p.hairline(), f.graph.h}, on_well(t, grid_ink));
        const Rect place{at - p.em(2), f.x_labels.y, p.em(4), f.x_labels.h};
        p.text(place, format_number(buffer, value, x.decimals), p.number_style(), t.text_dim, Align::center);
    }
    const Ticks y = ticks(o.y.low, o.y.high, std::max(1, static_cast<int>(f.graph.h / p.em(2))));
    for (int i = 0; i < y.count; ++i) {
        const double value = y.first + y.step * i;
        const float at = whole(f.y.px_of(value));
        p.fill({f.graph.x, at, f.graph.w, p.hairline()}, on_well(t, grid_ink));
        const Rect place{f.y_labels.x, at - p.em(0.7F), f.y_labels.w - p.em(0.4F), p.em(1.4F)};
        p.text(place, format_number(buffer, value, y.decimals), p.number_style(), t.text_dim, Align::end);
    }
    const auto named = [](std::string_view what, std::string_view unit) {
        ShortText text;
        text.add(what);
        return unit.empty() ? text : text.add(" (").add(unit).add(")");
    };
    const ShortText x_name = named(o.x_name, o.x_unit), y_name = named(o.y_name, o.y_unit);
    p.text(f.graph.inset(p.em(0.4F), p.em(0.2F)).cut_bottom(p.em(1.4F)), x_name.view(), p.text_style(),
           on_well(t, label_ink), Align::end);
    p.text(f.graph.inset(p.em(0.4F), p.em(0.2F)).cut_top(p.em(1.4F)), y_name.view(), p.text_style(),
           on_well(t, label_ink));
}

}  // namespace

void draw_ground(Painter& p, const Node& node, const Look& look) {
    const Theme& t = p.theme();
    const CurveEditorOptions& o = look.options;
    const Frame f = frame_of(p, node.rect(), o);
    p.ground(node.rect(), t.panel);
    p.ground(f.graph, t.well);
    draw_axes(p, f, o);
    p.frame(f.graph, t.border, p.hairline());
    p.push_clip(f.graph.inset(-p.em(0.2F)));
    const bool disabled = has(node.is, Is::disabled);
    if (o.standard != nullptr) draw_curve(p, f, *o.standard, 1.5F * p.hairline(), on_well(t, quiet_ink));
    draw_curve(p, f, *look.curve, 2 * p.hairline(), disabled ? on_well(t, quiet_ink) : t.series[0]);
    if (!std::isnan(o.live)) {
        const glm::vec2 at{f.x.px_of(o.live), f.y.px_of(look.curve->evaluate(o.live))};
        p.fill({whole(at.x), f.graph.y, p.hairline(), f.graph.h}, with_alpha(t.series[2], 0.5F));
        p.line(at, at, p.em(0.55F), t.series[2]);
    }
    p.pop_clip();
    if (!look.box.empty()) {
        p.fill(look.box, with_alpha(t.focus, 0.15F));
        p.frame(look.box, t.focus, p.hairline());
    }
}

void draw_entry(Painter& p, const Node& node, const void* arg) {
    const Look& look = *static_cast<const Look*>(arg);
    if (look.entering >= look.curve->size()) return;
    const Theme& t = p.theme();
    const Frame f = frame_of(p, node.rect(), look.options);
    const glm::vec2 at = place_of(f, look.curve->point(look.entering));
    const TextStyle style = p.number_style();
    const float typed = std::ceil(p.fonts().run(look.entry, style).width);
    Rect box{at.x + p.em(1), at.y - p.em(2.4F), std::max(p.em(6), typed + p.em(1.4F)), p.em(1.75F)};
    if (box.right() > node.rect().right()) box.x = at.x - p.em(1) - box.w;
    box.y = std::max(node.rect().y, box.y);
    p.fill(box, t.field, p.em(t.radius));
    p.frame(box, look.invalid ? t.error : t.focus, p.hairline(), p.em(t.radius));
    const Rect inside = box.inset(p.em(0.5F), 0);
    if (look.entry.empty()) p.text(inside, "y, or x; y", p.text_style(), t.text_disabled);
    p.text(inside, look.entry, style, t.text);
    p.fill({inside.x + typed, box.y + p.em(0.35F), p.hairline(), box.h - p.em(0.7F)}, t.text);
}

void draw_point(Painter& p, const Node& node, const bool&) {
    const Theme& t = p.theme();
    const glm::vec2 at = node.rect().center();
    const bool disabled = has(node.is, Is::disabled), selected = has(node.is, Is::selected);
    const bool hovered = (has(node.is, Is::hovered) || has(node.is, Is::held)) && !disabled;
    const float size = p.em(hovered ? 0.8F : 0.65F);
    const Color color = disabled ? on_well(t, quiet_ink) : selected ? t.accent : on_well(t, point_ink);
    const Rect square{whole(at.x - size / 2), whole(at.y - size / 2), size, size};
    p.fill(square.inset(-p.hairline()), t.well);
    p.fill(square, color);
}

}  // namespace lapfx::ui::curve_drawing
