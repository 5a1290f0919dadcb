#include "ui/canvas/timeline_drawing.h"

#include "ui/core/node.h"

namespace lapfx::ui::timeline_drawing {

namespace {

/// s between two labels of the ruler, at least `least` apart.
double ruler_step(double least, double rate, TimeUnit unit) {
    if (unit == TimeUnit::frames) {
        const double frames = std::max(1.0, least * rate), power = std::pow(10, std::floor(std::log10(frames)));
        for (const double digit : {1.0, 2.0, 5.0, 10.0}) {
            if (digit * power >= frames - 1e-9) return digit * power / rate;
        }
    }
    constexpr double parts[] = {0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5};
    constexpr double wholes[] = {1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14400, 43200};
    if (unit == TimeUnit::timecode) {
        for (const double frames : {1.0, 2.0, 5.0, 10.0}) {
            if (frames / rate >= least && frames < rate) return frames / rate;
        }
    } else {
        for (const double step : parts) {
            if (step >= least) return step;
        }
    }
    // A second of timecode is a whole number of frames, which may be a little more than a second.
    const double second = unit == TimeUnit::timecode ? std::round(rate) / rate : 1.0;
    for (const double step : wholes) {
        if (step * second >= least) return step * second;
    }
    return std::ceil(least / 86400) * 86400;
}

/// Whether a label from `left` to `right` would be written over the brackets of the range.
bool meets_bracket(const Painter& p, const Frame& f, const TimelineState& state, float left, float right) {
    if (!state.has_range) return false;
    const float in = f.x.px_of(state.range.low), out = f.x.px_of(state.range.high), foot = p.em(0.4F);
    return (right > in - p.hairline() && left < in + foot) || (right > out - foot && left < out + p.hairline());
}

void draw_ruler(Painter& p, const Frame& f, const Look& look) {
    const Theme& t = p.theme();
    const TimelineOptions& o = look.options;
    const double step = ruler_step(p.em(o.unit == TimeUnit::timecode ? 7.5F : 5) / f.x.scale(), o.rate, o.unit);
    const int parts =
        o.unit != TimeUnit::seconds && step * o.rate < 4.5 ? static_cast<int>(std::lround(step * o.rate)) : 5;
    p.ground(f.ruler, t.header);
    p.push_clip(f.ruler);
    char buffer[32];
    const double first = std::max(0.0, std::floor(look.state.view.low / step));
    for (double k = first; k * step <= std::min(look.state.view.high, o.length + 1e-9); ++k) {
        const float x = whole(f.x.px_of(k * step));
        p.fill({x, f.ruler.y + f.ruler.h * 0.35F, p.hairline(), f.ruler.h}, t.text_disabled);
        for (int i = 1; i < parts; ++i) {
            const float minor = whole(f.x.px_of(k * step + step * i / parts));
            p.fill({minor, f.ruler.bottom() - f.ruler.h * 0.25F, p.hairline(), f.ruler.h}, t.border);
        }
        const Rect place{x + p.em(0.3F), f.ruler.y, p.em(8), f.ruler.h * 0.85F};
        const std::string_view text = format_position(buffer, k * step, o.rate, o.unit);
        const float end = place.x + p.fonts().run(text, p.number_style()).width;
        // A time without its end would be another one.
        if (end <= f.ruler.right() && !meets_bracket(p, f, look.state, place.x, end))
            p.text(place, text, p.number_style(), t.text_dim);
    }
    p.pop_clip();
}

void draw_lanes(Painter& p, const Frame& f, const Look& look) {
    const Theme& t = p.theme();
    p.ground(f.lanes, t.well);
    for (std::size_t i = 0; i < look.tracks.size(); ++i) {
        const float y = f.lanes.y + f.lane * static_cast<float>(i);
        const Rect name{f.corner.x + p.em(0.6F), y, f.corner.w - p.em(1), f.lane};
        p.text(name, look.tracks[i].name, p.text_style(), t.text);
        const float line = y + f.lane - p.hairline();
        p.fill({f.corner.x, line, f.corner.w, p.hairline()}, t.grid);
        p.fill({f.lanes.x, line, f.lanes.w, p.hairline()}, on_well(t, grid_ink));
    }
}

}  // namespace

void draw_ground(Painter& p, const Node& node, const Look& look) {
    const Theme& t = p.theme();
    const Frame f = frame_of(p, node.rect(), look.state.view);
    p.ground(node.rect(), t.panel);
    draw_ruler(p, f, look);
    draw_lanes(p, f, look);
    char buffer[32];
    Rect corner = f.corner;
    corner.cut_right(p.em(0.4F));
    p.text(corner, format_position(buffer, look.state.time, look.options.rate, look.options.unit), p.number_style(),
           has(node.is, Is::disabled) ? t.text_disabled : t.text, Align::end);
}

void draw_front(Painter& p, const Node& node, const void* arg) {
    const Look& look = *static_cast<const Look*>(arg);
    const Theme& t = p.theme();
    const Frame f = frame_of(p, node.rect(), look.state.view);
    const Rect body{f.ruler.x, f.ruler.y, f.ruler.w, node.rect().bottom() - f.ruler.y};
    p.push_clip(body);
    const auto shade = [&](double low, double high, float alpha) {
        const float left = std::max(body.x, f.x.px_of(low)), right = std::min(body.right(), f.x.px_of(high));
        const float strength = 2 * alpha * static_cast<float>(t.shadow.a) / 255;  // as strong as the theme's shadows
        if (right > left) p.fill({left, body.y, right - left, body.h}, with_alpha(t.shadow, strength));
    };
    const Span& view = look.state.view;
    shade(view.low, 0, 0.7F);
    shade(look.options.length, view.high, 0.7F);
    if (look.state.has_range) {
        const Span& range = look.state.range;
        shade(std::max(0.0, view.low), range.low, 0.45F);
        shade(range.high, std::min(look.options.length, view.high), 0.45F);
        const float left = f.x.px_of(range.low), right = f.x.px_of(range.high);
        p.fill({left, f.ruler.bottom() - p.em(0.2F), right - left, p.em(0.2F)}, look.state.loop ? t.good : t.text_dim);
    }
    const float x = whole(f.x.px_of(look.state.time));
    const float width = 2 * p.hairline();
    p.fill({x - width / 2, body.y, width, body.h}, t.accent_hover);
    p.fill({x - p.em(0.4F), body.y, 2 * p.em(0.4F), p.em(0.6F)}, t.accent_hover, p.em(0.2F));
    p.pop_clip();
}

void draw_item(Painter& p, const Node& node, const ItemLook& look) {
    const Theme& t = p.theme();
    const bool selected = has(node.is, Is::selected), hovered = has(node.is, Is::hovered);
    Rect rect = node.rect();
    if (look.mark) {
        const glm::vec2 at = rect.center();
        if (look.ghost) {  // a ring on a line of dots
            for (float y = rect.y; y < rect.bottom(); y += p.em(0.35F))
                p.fill({whole(at.x), y, p.hairline(), std::min(p.em(0.15F), rect.bottom() - y)}, look.color);
            p.line(at, at, p.em(hovered ? 0.85F : 0.7F), look.color);
            p.line(at, at, p.em(hovered ? 0.6F : 0.5F), hovered ? mix(t.well, look.color, 0.4F) : t.well);
            return;
        }
        p.fill({whole(at.x), rect.y, p.hairline(), rect.h}, look.color);
        p.line(at, at, p.em(selected || hovered ? 0.85F : 0.7F), selected ? on_well(t, point_ink) : look.color);
        return;
    }
    rect = rect.inset(0, p.em(rect.h < p.em(1.2F) ? 0.03F : 0.12F));  // a low row needs its height for the name
    p.fill(rect, mix(t.well, look.color, selected ? 0.6F : hovered ? 0.48F : 0.38F), p.em(t.radius));
    p.frame(rect, selected ? on_well(t, 1) : look.color, p.hairline() * (selected ? 2.0F : 1.0F), p.em(t.radius));
    // The name is put into the visible part, so that the name of a long clip stays visible.
    const Rect seen = intersect(rect, node.clip).inset(p.em(0.5F), 0);
    const bool room = rect.h >= p.em(0.7F);  // the lowest have their name in the tooltip
    if (seen.w > p.em(1) && room) p.text(seen, node.shown, p.text_style(), on_well(t, 1));
}

void draw_range_end(Painter& p, const Node& node, const bool& in) {
    const Theme& t = p.theme();
    const Rect rect = node.rect();
    const Color color = has(node.is, Is::hovered) || has(node.is, Is::held) ? t.text : t.text_dim;
    const float x = whole(rect.center().x), width = 2 * p.hairline(), foot = p.em(0.4F);
    p.fill({x - width / 2, rect.y, width, rect.h}, color);
    for (const float y : {rect.y, rect.bottom() - width}) p.fill({in ? x : x - foot, y, foot, width}, color);
}

}  // namespace lapfx::ui::timeline_drawing
