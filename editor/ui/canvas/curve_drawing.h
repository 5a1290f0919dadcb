// How the curve editor is drawn; of curve_editor.cpp only.
#pragma once

#include "ui/canvas/curve_editor.h"

namespace lapfx::ui::curve_drawing {

struct Frame {
    Rect graph, x_labels, y_labels;
    Axis1 x, y;
    float left, top, right, bottom;  ///< px around the graph
};
template <typename Em>
Frame frame_of(const Em& measure, Rect rect, const CurveEditorOptions& o) {
    Frame f;
    f.left = measure.em(3), f.right = measure.em(0.9F), f.bottom = measure.em(1.6F);
    f.top = measure.em(o.y_name.empty() ? 0.9F : 2.2F);
    f.graph = {rect.x + f.left, rect.y + f.top, std::max(0.0F, rect.w - f.left - f.right),
               std::max(0.0F, rect.h - f.top - f.bottom)};
    f.x_labels = {f.graph.x, f.graph.bottom(), f.graph.w + f.right, f.bottom};
    f.y_labels = {rect.x, f.graph.y, f.left, f.graph.h};
    f.x = {o.x, f.graph.x, f.graph.right()};
    f.y = {o.y, f.graph.bottom(), f.graph.y};
    return f;
}
inline glm::vec2 place_of(const Frame& f, const CurvePoint& p) {
    const Span &x = f.x.span, &y = f.y.span;  // what lies outside is shown at the edge, where it can be grabbed
    return {f.x.px_of(std::clamp(p.x, x.low, x.high)), f.y.px_of(std::clamp(p.y, y.low, y.high))};
}
struct Look {
    const Curve* curve;
    CurveEditorOptions options;
    Rect box;
    std::size_t entering;
    std::string_view entry;
    bool invalid;
};

void draw_ground(Painter& p, const Node& node, const Look& look);
/// Above the points: what is typed.
void draw_entry(Painter& p, const Node& node, const void* arg);
void draw_point(Painter& p, const Node& node, const bool&);

}  // namespace lapfx::ui::curve_drawing
