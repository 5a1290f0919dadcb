#include "tool/usable_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lapfx::tool {

namespace {

// Comparisons are false for NaN.
bool within(double value, double low, double high) {
    return value >= low && value <= high;
}
bool within(glm::dvec3 place, double limit) {
    return within(place.x, -limit, limit) && within(place.y, -limit, limit) && within(place.z, -limit, limit);
}

}  // namespace

std::optional<ToolContact> usable(const ToolContact& given) noexcept {
    const bool sound = within(given.time, -1e7, 1e7) && within(given.duration, 0.0, 1e9) &&
                       std::isfinite(given.power) && within(given.strength, 0.0, std::numeric_limits<double>::max()) &&
                       within(given.position, 1e5) && within(given.to, 1e5) &&
                       glm::distance(given.position, given.to) <= 1000.0;
    if (!sound) return std::nullopt;
    ToolContact contact = given;
    contact.power = std::clamp(contact.power, 0.0, 1.0);
    contact.strength = std::min(contact.strength, 1000.0);
    if (contact.duration > longest_stay) {
        contact.to = contact.tip(contact.time + longest_stay);
        contact.duration = longest_stay;
    }
    return contact;
}

}  // namespace lapfx::tool
