// The CPU reference of shaders/keying.glsl, line for line. tests/parity/keying_test.cpp holds the two
// together. Pure functions, any thread. Code values 0..255.
#pragma once

#include <algorithm>
#include <glm/glm.hpp>

namespace lapfx::smoke {

/// What the shader's LapfxKeying holds.
struct Keying {
    float luma_low, luma_high;
    glm::vec2 key_chroma;
    float chroma_low, chroma_high;
    float spill;
    float dark;
};

/// BT.601 luma, full range.
inline float luma(glm::vec3 code) {
    return glm::dot(code, glm::vec3(0.299f, 0.587f, 0.114f));
}

/// BT.601 Cb and Cr around 0.
inline glm::vec2 chroma(glm::vec3 code) {
    const float y = luma(code);
    return {(code.b - y) / 1.772f, (code.r - y) / 1.402f};
}

/// `x` within 0..1; NaN, from a pixel that holds one, counts as nothing.
inline float unit(float x) {
    return x > 0.0f ? std::min(x, 1.0f) : 0.0f;
}

inline float ramp(float value, float low, float high) {
    return unit((value - low) / std::max(high - low, 1e-3f));
}

/// Opacity of the smoke in one pixel.
inline float key_alpha(glm::vec3 code, const Keying& key) {
    const float y = luma(code);
    const float luma_alpha = ramp(key.dark > 0.5f ? 255.0f - y : y, key.luma_low, key.luma_high);
    const float chroma_alpha = key.chroma_high > 0.0f
                                   ? ramp(glm::distance(chroma(code), key.key_chroma), key.chroma_low, key.chroma_high)
                                   : 1.0f;
    return luma_alpha * chroma_alpha;
}

/// Chroma without the part that leans towards the background's.
inline glm::vec2 despill(glm::vec2 value, const Keying& key) {
    const float strength = glm::dot(key.key_chroma, key.key_chroma);
    const float lean = strength > 1.0f ? std::max(glm::dot(value, key.key_chroma) / strength, 0.0f) : 0.0f;
    return value - key.spill * lean * key.key_chroma;
}

inline float vary_alpha(float alpha, float noise, float strength) {
    return unit(alpha * (1.0f + strength * noise));
}

}  // namespace lapfx::smoke
