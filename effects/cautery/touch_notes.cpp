// touch_notes(): what of a scene's events touches nothing.
#include "lapfx/authoring/touch_notes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "cautery/heat.h"
#include "organ/surface.h"
#include "tool/usable_contact.h"

namespace lapfx {

namespace {

/// Of the tip from the surface, mm, where it comes nearest, at steps of a millimetre or less.
double nearest(const Surface& surface, const ToolContact& contact) {
    const int steps = static_cast<int>(std::ceil(glm::distance(contact.position, contact.to)));
    double least = surface.closest_point(contact.position).distance;
    for (int i = 1; i <= steps && least > cautery::farthest_touch; ++i) {
        const glm::dvec3 tip = glm::mix(contact.position, contact.to, static_cast<double>(i) / steps);
        least = std::min(least, surface.closest_point(tip).distance);
    }
    return least;
}

}  // namespace

std::vector<std::string> touch_notes(const Organ& organ, std::span<const ToolContact> events) {
    constexpr std::size_t told = 5;
    std::vector<std::string> notes;
    const Surface surface(organ);
    if (surface.triangles.empty()) return notes;
    std::size_t more = 0;
    for (std::size_t i = 0; i < events.size(); ++i) {
        const auto contact = tool::usable(events[i]);
        if (!contact || row_of(contact->action).clears != nullptr) continue;
        const double distance = nearest(surface, *contact);
        if (distance <= cautery::farthest_touch) continue;
        if (notes.size() == told) {
            ++more;
            continue;
        }
        std::array<char, 120> text{};
        std::snprintf(text.data(), text.size(),
                      "/events/%zu: touches nothing: its tip is %.1f mm from the organ, %.0f mm at most", i, distance,
                      cautery::farthest_touch);
        notes.emplace_back(text.data());
    }
    if (more > 0) notes.push_back("and " + std::to_string(more) + " events more touch nothing");
    return notes;
}

}  // namespace lapfx
