#include "app/preview/held_tool.h"

#include <algorithm>
#include <span>

namespace lapfx::app {

namespace {

constexpr double sample_time = 0.01;  // s between samples

}  // namespace

void HeldTool::push(Preview& preview, double time, glm::dvec3 place, bool touching) {
    last_.time = time;
    last_.position = place;
    last_.touching = touching;
    preview.tool_queue().push(last_);
}

void HeldTool::put(Preview& preview, const ToolSample& first) {
    // Samples go forwards in time. Setting the log allows time to start again.
    const std::vector<ToolContact> log(preview.contacts().begin(), preview.contacts().end());
    preview.set_contacts(log);
    contacts_before_ = log.size();
    last_ = first;
    on_ = true;
    push(preview, first.time, first.position, true);
}

void HeldTool::move(Preview& preview, double time, glm::dvec3 place) {
    const double begin = last_.time;
    const glm::dvec3 from = last_.position;
    while (last_.time + sample_time <= time) {
        const double next = last_.time + sample_time;
        push(preview, next, glm::mix(from, place, (next - begin) / (time - begin)), true);
    }
}

void HeldTool::take_off(Preview& preview, double time) {
    on_ = false;
    push(preview, std::max(time, last_.time + 1e-3), last_.position, false);
}

std::vector<ToolContact> HeldTool::done(const Preview& preview) const {
    const std::span<const ToolContact> all = preview.contacts();
    const std::size_t first = std::min(contacts_before_, all.size());
    return {all.begin() + static_cast<std::ptrdiff_t>(first), all.end()};
}

}  // namespace lapfx::app
