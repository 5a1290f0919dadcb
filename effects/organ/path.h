// Straight paths of a tip or of a clip. Pure; any thread.
#pragma once

#include <glm/glm.hpp>

namespace lapfx::organ {

/// mm from `p` to the nearest place of the straight path from `a` to `b`.
inline double distance_to_path(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 path = b - a;
    const double squared = glm::dot(path, path);
    const double share = squared > 0.0 ? glm::clamp(glm::dot(p - a, path) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + share * path);
}

}  // namespace lapfx::organ
