// How the timeline is drawn; of timeline.cpp only.
#pragma once

#include "ui/canvas/timeline.h"

namespace lapfx::ui::timeline_drawing {

struct Frame {
    Rect corner, ruler, lanes;
    float lane = 0;  ///< px, its height
    Axis1 x;
};
template <typename Em>
Frame frame_of(const Em& measure, Rect rect, const Span& view) {
    Frame f;
    const Rect all = rect;
    rect.cut_left(measure.em(10.2F));
    f.ruler = rect.cut_top(measure.em(1.75F));
    f.corner = {all.x, all.y, f.ruler.x - all.x, f.ruler.h};
    f.lanes = rect;
    f.lane = measure.em(1.9F);
    f.x = {view, f.ruler.x, f.ruler.right()};
    return f;
}

struct Look {
    TimelineState state;
    TimelineOptions options;
    std::span<const TimelineTrack> tracks;
};
struct ItemLook {
    Color color;
    bool mark, ghost;
};

void draw_ground(Painter& p, const Node& node, const Look& look);
/// Above the clips: what is outside of time or of the range, and the playhead.
void draw_front(Painter& p, const Node& node, const void* arg);
void draw_item(Painter& p, const Node& node, const ItemLook& look);
void draw_range_end(Painter& p, const Node& node, const bool& in);

}  // namespace lapfx::ui::timeline_drawing
