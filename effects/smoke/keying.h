// The constants of keying, from a preset's parameters, for the shader (shaders/keying.glsl) and its CPU reference
// (smoke/keying_pixel.h). Pure functions, any thread. Code values 0..255.
#pragma once

#include <glm/glm.hpp>

#include "lapfx/authoring/keying.h"
#include "lapfx/smoke_parameters.h"

namespace lapfx::smoke {

/// The members of the shader's LapfxKeying.
struct Keying {
    float luma_low, luma_high;
    glm::vec2 key_chroma;
    float chroma_low, chroma_high;
    float spill;
    float dark;
};

using lapfx::luma;

/// BT.601 Cb and Cr around 0.
inline glm::vec2 chroma(glm::vec3 code) {
    const float y = luma(code);
    return {(code.b - y) / 1.772f, (code.r - y) / 1.402f};
}

inline Keying keying_of(const KeyingParameters& k, ClipPolarity polarity) {
    return {.luma_low = static_cast<float>(k.luma_low),
            .luma_high = static_cast<float>(k.luma_high),
            .key_chroma = chroma(glm::vec3(k.key_color) * 255.0f),
            .chroma_low = static_cast<float>(k.chroma_low),
            .chroma_high = static_cast<float>(k.chroma_high),
            .spill = static_cast<float>(k.spill),
            .dark = polarity == ClipPolarity::dark ? 1.0f : 0.0f};
}

}  // namespace lapfx::smoke
