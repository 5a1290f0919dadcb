// Smoke as optical thickness, computed on the CPU as in shaders/resolve.frag. Pure functions, any thread.
#pragma once

#include <algorithm>
#include <glm/glm.hpp>

namespace lapfx::smoke {

/// All layers of smoke along one ray, in any order.
struct SmokeSum {
    glm::vec3 light{0.0f};   ///< light and tint, weighted by thickness
    float thickness = 0.0f;  ///< at unit extinction

    void add(glm::vec3 layer_light, float layer_thickness) {
        light += layer_light * layer_thickness;
        thickness += layer_thickness;
    }
};

/// The frame behind smoke: `reach` is the share of the thickness in front of what is visible; colours linear.
inline glm::vec3 lay_over(glm::vec3 frame, const SmokeSum& sum, glm::vec3 color, glm::vec3 extinction, float reach) {
    const glm::vec3 transmission = glm::exp(-sum.thickness * reach * extinction);
    return frame * transmission + color * sum.light / std::max(sum.thickness, 1e-6f) * (1.0f - transmission);
}

}  // namespace lapfx::smoke
