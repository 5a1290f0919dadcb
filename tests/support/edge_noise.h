// The noise that moves the edge of blood, on the CPU.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "lapfx/bleeding_parameters.h"
#include "smoke/noise.h"

namespace lapfx::test {

/// lapfx_blood_noise of shaders/bleeding.glsl: octaves compressed along gravity, with longer runs on steep tissue.
inline float edge_noise(const BleedingParameters& b, const glm::dvec3& down, std::uint32_t seed, glm::vec3 position,
                        glm::vec3 normal) {
    const glm::vec3 g(down);
    const auto rivulets = static_cast<float>(b.rivulets);
    float sum = 0.0f, amplitude = 1.0f, total = 0.0f;
    for (int i = 0; i < b.noise_octaves; ++i) {
        const float press = (i == 0 ? 0.6f : 0.8f) * rivulets;
        const glm::vec3 place =
            (position - press * glm::dot(position, g) * g) / (static_cast<float>(b.noise_scale) * amplitude);
        sum += amplitude * smoke::perlin(place, (seed & 0xffffu) + static_cast<std::uint32_t>(i));
        total += amplitude;
        amplitude *= 0.5f;
    }
    const float steep = rivulets * glm::smoothstep(0.3f, 0.9f, glm::length(glm::cross(normal, g)));
    const float x = glm::clamp(sum / total * (1.0f + steep), -1.5f, 1.5f);
    return glm::clamp(x - steep * x * x * x / 6.75f, -1.0f, 1.0f);
}

}  // namespace lapfx::test
