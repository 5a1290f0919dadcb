#include "app/preview/tool_hold.h"

#include <algorithm>
#include <cmath>

#include "app/base/notices.h"
#include "app/preview/events.h"
#include "app/preview/preview_host.h"
#include "app/preview/timeline.h"

namespace lapfx::app {

void ToolHold::begin(const ToolInHand& tool, const glm::dvec3& place) {
    if (on_ || !tool.action || !preview_.ready()) return;
    if (timeline_.time >= last_event_time) return;
    document_.commit();
    const double strength = tool.strength * strength_here(*tool.action, preview_.preview()->tissue(place));
    preview_.put_tool(*tool.action, row_of(*tool.action).hot ? tool.power : 1.0, divides(*tool.action) ? strength : 1.0,
                      timeline_.time, place);
    on_ = preview_.tool_on();
    began_ = timeline_.time;
    speed_before_ = timeline_.speed;
    until_ = 0;
    place_ = place;
    if (on_) timeline_.speed = 1;
}

void ToolHold::begin_for(const ToolInHand& tool, const glm::dvec3& place, double seconds) {
    begin(tool, place);
    if (on_) until_ = began_ + seconds;
}

void ToolHold::move(const glm::dvec3& place) {
    if (on_) place_ = place;
    if (on_) preview_.move_tool(timeline_.time, place);
}

void ToolHold::stop() {
    on_ = false;
    timeline_.speed = speed_before_;
}

void ToolHold::end() {
    if (!on_) return;
    if (until_ > 0) timeline_.time = std::min(timeline_.time, until_);
    const std::vector<ToolContact> made = simplified(preview_.take_tool_off(timeline_.time));
    stop();
    if (made.empty()) return;
    const std::size_t there = document_.scene().events.size();
    if (there + made.size() > most_events) {
        notices_.add({.kind = ui::ToastKind::error,
                      .text = "Not recorded: a scene has at most 4096 events; delete some on the timeline"});
        return;
    }
    document_.change(std::string(row_of(made.front().action).title), [&](document::Content& c) {
        c.scene.events.insert(c.scene.events.end(), made.begin(), made.end());
        const double last = std::min(std::ceil(made.back().end() * 10) / 10, last_event_time);
        c.scene.duration = std::max(c.scene.duration, last);
    });
    selected_.clear();
    for (std::size_t i = 0; i < made.size(); ++i) selected_.push_back(there + i);
}

void ToolHold::cancel() {
    if (!on_) return;
    preview_.take_tool_off(timeline_.time);
    stop();
    timeline_.seek(began_);
}

void ToolHold::update(bool held) {
    if (!on_) return;
    if (until_ > 0 ? timeline_.time >= until_ : !held) return end();
    preview_.move_tool(timeline_.time, place_);
}

}  // namespace lapfx::app
