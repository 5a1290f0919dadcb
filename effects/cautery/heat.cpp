#include "cautery/heat.h"

#include <algorithm>
#include <cmath>

namespace lapfx::cautery {

double wound_strength(const ToolContact& contact, const glm::dvec3& place, const StrengthAt& strength_at) {
    const double vessels = strength_at ? strength_at(place) : 1.0;
    const double tool = row_of(contact.action).strength * contact.strength;
    return std::isfinite(vessels) ? tool * vessels : 0.0;
}

std::optional<Interval> passes(const ToolContact& contact, glm::dvec3 place, double radius) noexcept {
    const glm::dvec3 path = contact.to - contact.position, offset = contact.position - place;
    // |offset + share * path| = radius
    const double a = glm::dot(path, path), b = glm::dot(offset, path);
    const double c = glm::dot(offset, offset) - radius * radius;
    double from = 0.0, to = 1.0;
    if (a > 0.0) {
        const double root = b * b - a * c;
        if (root < 0.0) return std::nullopt;
        from = std::max(0.0, (-b - std::sqrt(root)) / a);
        to = std::min(1.0, (-b + std::sqrt(root)) / a);
    } else if (c > 0.0) {
        return std::nullopt;
    }
    if (from > to) return std::nullopt;
    return Interval{contact.time + from * contact.duration, contact.time + to * contact.duration};
}

double char_of(double peak, const CauteryParameters& c) noexcept {
    if (peak <= body_temperature) return 0.0;
    // Tissue blanches when it coagulates, browns at the char temperature and is black 150 degrees above it.
    const double cooked = glm::smoothstep(c.coagulation_temperature, c.char_temperature, peak);
    const double burnt = glm::smoothstep(c.char_temperature, c.char_temperature + 150.0, peak);
    return browned * cooked + (1.0 - browned) * burnt;
}

double divided_at(double distance, ToolAction action, const CauteryParameters& c) noexcept {
    constexpr double frayed_width = 2.0, frayed_depth = 0.6;
    const bool frays = row_of(action).frays;
    const double width = (frays ? frayed_width : 1.0) * c.tip_radius;
    return (frays ? frayed_depth : 1.0) * (1.0 - glm::smoothstep(0.25 * width, 0.75 * width, distance));
}

}  // namespace lapfx::cautery
