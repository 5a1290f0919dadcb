// The CPU mirror of shaders/noise.glsl: the same lattice, the same constants, float arithmetic in the same
// order. tests/parity/noise_test.cpp compares the two. Pure functions, any thread.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

namespace lapfx::gl {

inline std::uint32_t noise_hash(glm::ivec3 cell, std::uint32_t seed) {
    const glm::uvec3 c(cell);
    std::uint32_t h = (c.x * 0x8da6b343u) ^ (c.y * 0xd8163841u) ^ (c.z * 0xcb1ab31fu) ^ (seed * 0x9e3779b9u);
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    h *= 0x297a2d39u;
    return h ^ (h >> 15);
}

inline glm::vec3 noise_gradient(glm::ivec3 cell, std::uint32_t seed) {
    const std::uint32_t h = noise_hash(cell, seed) & 15u;
    const float u = (h & 1u) == 0u ? 1.0f : -1.0f;
    const float v = (h & 2u) == 0u ? 1.0f : -1.0f;
    if (h < 4u) return {u, v, 0.0f};
    if (h < 8u) return {u, 0.0f, v};
    if (h < 12u) return {0.0f, u, v};
    return (h & 1u) == 0u ? glm::vec3(v, 1.0f, 0.0f) : glm::vec3(0.0f, -1.0f, v);
}

/// Improved Perlin noise: about -1..1, mean 0, one lobe per unit of p. `from`: whole lobes added to p; they wrap
/// around.
inline float perlin_from(glm::uvec3 from, glm::vec3 p, std::uint32_t seed) {
    const glm::vec3 base = glm::floor(p);
    const glm::ivec3 cell(from + glm::uvec3(glm::ivec3(base)));
    const glm::vec3 f = p - base;
    const glm::vec3 s = f * f * f * (f * (f * 6.0f - 15.0f) + 10.0f);
    float plane[2];
    for (int z = 0; z < 2; ++z) {
        float row[2];
        for (int y = 0; y < 2; ++y) {
            float corner[2];
            for (int x = 0; x < 2; ++x) {
                const glm::ivec3 offset(x, y, z);
                corner[x] = glm::dot(noise_gradient(glm::ivec3(glm::uvec3(cell) + glm::uvec3(offset)), seed),
                                     f - glm::vec3(offset));
            }
            row[y] = glm::mix(corner[0], corner[1], s.x);
        }
        plane[z] = glm::mix(row[0], row[1], s.y);
    }
    return glm::mix(plane[0], plane[1], s.z);
}

inline float perlin(glm::vec3 p, std::uint32_t seed) {
    return perlin_from(glm::uvec3(0), p, seed);
}

/// Octaves, each half as large and half as strong, scaled to stay in about -1..1.
inline float fractal_noise(glm::vec3 p, int octaves, std::uint32_t seed) {
    float sum = 0.0f, amplitude = 1.0f, frequency = 1.0f, total = 0.0f;
    for (int i = 0; i < octaves; ++i) {
        sum += amplitude * perlin(p * frequency, seed + static_cast<std::uint32_t>(i));
        total += amplitude;
        amplitude *= 0.5f;
        frequency *= 2.0f;
    }
    return octaves > 0 ? sum / total : 0.0f;
}

}  // namespace lapfx::gl
