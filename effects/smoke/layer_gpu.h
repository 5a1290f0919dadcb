// One clip drawn once, and its data for the shaders. Render thread.
#pragma once

#include <array>
#include <cstdint>

#include "lapfx/authoring/clip_roles.h"
#include "lapfx/smoke_parameters.h"
#include "media/clip_frame.h"

namespace lapfx::smoke {

struct Layer {
    media::ClipFrame frame;
    const KeyingParameters* keying = nullptr;
    ClipPolarity polarity = ClipPolarity::light;
    const SmokeClip* clip = nullptr;  ///< its crop, fade and masks apply; null: the whole frame
    bool mirrored = false;            ///< left and right exchanged
    float angle = 0.0f;               ///< radians, haze only: a plume is turned by its corners
    double density = 1.0;          ///< plume: multiplies the optical thickness; haze: thickness at the focus distance
    double time = 0.0;             ///< s, for the noise drift
    double below = 1.0;            ///< plume: share of the clip's height below the start of its smoke, 0..1
    glm::vec2 source{0.5f, 1.0f};  ///< plume: where its smoke starts, drawn coordinates
    float widening = 1.0f;         ///< plume: PlumeState::widening
    std::uint32_t seed = 0;
};

/// One element of the uniform block LapfxSmokeLayers of shaders/smoke_layer.glsl, std140. Its size is the largest
/// alignment that the start of a bound range may need.
struct alignas(256) LayerBlock {
    glm::vec4 code_rows[3];
    glm::vec4 luma_chroma, key, vary, amount, turn, tile, chroma_scale;
    glm::vec4 corners[4];
    glm::vec4 color, extinction;
    glm::vec4 window, fades, part;
    glm::vec4 masks[most_masks];
    glm::vec4 mask_count;
};
static_assert(sizeof(LayerBlock) == 512 && most_masks == 12);

/// `extra`: unevenness of haze, softness of a plume, mm.
LayerBlock layer_block(const Layer& layer, const SmokeMedium& medium, double extra);
/// Turns a haze layer by its angle in a view of this aspect (width / height), so that nothing is sheared.
void turn_block(LayerBlock& block, const Layer& layer, float view_aspect);

}  // namespace lapfx::smoke
