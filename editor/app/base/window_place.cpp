#include "app/base/window_place.h"

#include <cstdint>

namespace lapfx::app {

namespace {

std::int64_t common_area(const ScreenArea& a, const ScreenArea& b) {
    const glm::ivec2 size = glm::min(a.at + a.size, b.at + b.size) - glm::max(a.at, b.at);
    return size.x <= 0 || size.y <= 0 ? 0 : std::int64_t{size.x} * size.y;
}

}  // namespace

WindowPlace fitted(WindowPlace place, std::span<const ScreenArea> monitors) {
    if (!place || monitors.empty()) return place;
    const ScreenArea* best = &monitors.front();
    for (const ScreenArea& monitor : monitors)
        if (common_area(monitor, place.area) > common_area(*best, place.area)) best = &monitor;
    ScreenArea& area = place.area;
    area.size = glm::min(glm::max(area.size, least_window), best->size);
    area.at = glm::clamp(area.at, best->at, best->at + best->size - area.size);
    return place;
}

}  // namespace lapfx::app
