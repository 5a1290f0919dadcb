// The CPU reference of shaders/keying.glsl, window.glsl and edges.glsl, line for line.
// tests/parity/keying_test.cpp compares them. Pure functions, any thread. Code values 0..255.
#pragma once

#include <algorithm>
#include <glm/glm.hpp>

#include "smoke/keying.h"
#include "smoke/window.h"

namespace lapfx::smoke {

/// `x` clamped to 0..1; NaN, from a pixel that has one, counts as 0.
inline float unit(float x) {
    return x > 0.0f ? std::min(x, 1.0f) : 0.0f;
}

inline float ramp(float value, float low, float high) {
    return unit((value - low) / std::max(high - low, 1e-3f));
}

/// Opacity of the smoke in one pixel is the product of these two.
inline float key_luma(float y, const Keying& key) {
    return ramp(key.dark > 0.5f ? 255.0f - y : y, key.luma_low, key.luma_high);
}

inline float key_chroma(glm::vec2 value, const Keying& key) {
    return key.chroma_high > 0.0f ? ramp(glm::distance(value, key.key_chroma), key.chroma_low, key.chroma_high) : 1.0f;
}

inline float key_alpha(glm::vec3 code, const Keying& key) {
    return key_luma(luma(code), key) * key_chroma(chroma(code), key);
}

/// Chroma without its part in the direction of the background's chroma.
inline glm::vec2 despill(glm::vec2 value, const Keying& key) {
    const float strength = glm::dot(key.key_chroma, key.key_chroma);
    const float lean = strength > 1.0f ? std::max(glm::dot(value, key.key_chroma) / strength, 0.0f) : 0.0f;
    return value - key.spill * lean * key.key_chroma;
}

/// The smoke's own tint, 1 where it is grey; `value` is its chroma without spill.
inline glm::vec3 tint(float y, glm::vec2 value) {
    const glm::vec2 share = value / std::max(y, 64.0f);
    return glm::clamp(1.0f + glm::vec3(1.402f * share.y, -0.344f * share.x - 0.714f * share.y, 1.772f * share.x), 0.0f,
                      2.0f);
}

/// How brightly smoke is lit, 1 from middle grey on, where its opacity `alpha` (0..1) comes from the clip itself; `y`:
/// luma, premultiplied.
inline float shade(float y, float alpha) {
    const float own = (std::max(y, 0.0f) / 128.0f + 0.05f) / (unit(alpha) + 0.05f);
    return std::clamp(own * own, 0.1f, 1.0f);
}

inline float vary_alpha(float alpha, float noise, float strength) {
    return unit(alpha * (1.0f + strength * noise));
}

inline float eased(float x) {
    const float t = unit(x);
    return t * t * (3.0f - 2.0f * t);
}

/// 1 where a place of the clip, in pixels, may be smoke, 0 where the crop or a mask removes it.
inline float window_at(const Window& window, glm::vec2 position) {
    const glm::vec2 before = position - window.low, behind = window.high - position;
    float share = eased(before.x / window.fades.x) * eased(before.y / window.fades.y) *
                  eased(behind.x / window.fades.z) * eased(behind.y / window.fades.w);
    for (int i = 0; i < window.masks; ++i) {
        const glm::vec4 mask = window.mask[static_cast<std::size_t>(i)];
        const glm::vec2 beyond =
            glm::max(glm::max(glm::vec2(mask) - position, position - glm::vec2(mask.z, mask.w)), 0.0f);
        share *= eased(glm::length(beyond) / window.softness);
    }
    return share;
}

inline constexpr glm::vec2 edge_directions[8] = {
    {1.0f, 0.0f},  {0.70710678f, 0.70710678f},   {0.0f, 1.0f},  {-0.70710678f, 0.70710678f},
    {-1.0f, 0.0f}, {-0.70710678f, -0.70710678f}, {0.0f, -1.0f}, {0.70710678f, -0.70710678f}};

/// The least opacity here and `choke` pixels away in eight directions: edges move inwards. `opacity_at`:
/// float(glm::vec2), the keyed opacity at a place of the clip, pixels.
template <typename OpacityAt>
float choked(const OpacityAt& opacity_at, glm::vec2 position, float choke) {
    float least = opacity_at(position);
    if (choke > 0.0f)
        for (const glm::vec2 direction : edge_directions)
            least = std::min(least, opacity_at(position + choke * direction));
    return least;
}

/// The mean of the choked opacity here and `feather` pixels away in eight directions.
template <typename OpacityAt>
float edged(const OpacityAt& opacity_at, glm::vec2 position, float choke, float feather) {
    const float here = choked(opacity_at, position, choke);
    if (!(feather > 0.0f)) return here;
    float sum = here;
    for (const glm::vec2 direction : edge_directions) sum += choked(opacity_at, position + feather * direction, choke);
    return sum / 9.0f;
}

}  // namespace lapfx::smoke
