#include "smoke/layer_gpu.h"

#include <algorithm>
#include <cmath>

#include "gl/srgb.h"
#include "lapfx/authoring/clip_roles.h"
#include "smoke/keying.h"
#include "smoke/window.h"

namespace lapfx::smoke {

namespace {

/// Rows that give luma, Cb and Cr around 0 (BT.601, as keying.h) out of what textures give, 0..1. Codes outside R'G'B'
/// are not clamped: beyond black and white the ramps of keying are flat anyway.
void set_code_rows(LayerBlock& block, const media::ColorMatrix* matrix) {
    glm::mat3 to_rgb(1.0f);
    glm::vec3 offset(0.0f);
    if (matrix != nullptr) {
        to_rgb = matrix->matrix;
        offset = matrix->offset;
    }
    for (glm::length_t column = 0; column < 3; ++column) {
        const glm::vec3 code = to_rgb[column] * 255.0f;
        const glm::vec3 row_values(luma(code), chroma(code));
        for (glm::length_t row = 0; row < 3; ++row) block.code_rows[row][column] = row_values[row];
    }
    const glm::vec3 start = -(to_rgb * offset);
    const glm::vec3 added(luma(start), chroma(start));
    for (glm::length_t row = 0; row < 3; ++row) block.code_rows[row].w = added[row];
}

void set_window(LayerBlock& block, const Layer& layer, glm::ivec2 size) {
    const Window window = window_of(layer.clip != nullptr ? *layer.clip : SmokeClip{}, size);
    block.window = glm::vec4(window.low, window.high);
    block.fades = window.fades;
    block.mask_count = glm::vec4(static_cast<float>(window.masks), window.softness, layer.source);
    std::copy(window.mask.begin(), window.mask.end(), block.masks);
    const glm::vec2 low = window.low / glm::vec2(size), high = window.high / glm::vec2(size);
    if (window.fills_view)
        block.part = glm::vec4(low, high - low);
    else
        block.part = layer.mirrored ? glm::vec4(1.0f - high.x, low.y, 1.0f - low.x, high.y) : glm::vec4(low, high);
}

}  // namespace

LayerBlock layer_block(const Layer& layer, const SmokeMedium& medium, double extra) {
    const KeyingParameters& k = *layer.keying;
    const media::PictureFormat& format = layer.frame.format;
    const Keying key = keying_of(k, layer.polarity);
    const glm::vec2 size(format.size);
    LayerBlock block{};
    set_code_rows(block, format.layout == media::Layout::planar ? layer.frame.matrix : nullptr);
    block.luma_chroma = glm::vec4(key.luma_low, key.luma_high, key.chroma_low, key.chroma_high);
    block.key = glm::vec4(key.key_chroma, key.spill, key.dark);
    block.vary =
        glm::vec4(glm::vec3(glm::dvec3(k.noise_strength, k.choke, k.feather)), static_cast<float>(layer.frame.layer));
    block.amount = glm::vec4(static_cast<float>(layer.density), static_cast<float>(extra), size);
    block.turn = glm::vec4(layer.mirrored ? -1.0f : 1.0f, 0.0f, 0.0f, 1.0f);
    // An odd size has half a chroma sample too many at its end.
    block.chroma_scale =
        glm::vec4(0.5f * size / glm::vec2(format.chroma_size()), static_cast<float>(layer.below), layer.widening);
    block.color = glm::vec4(gl::to_linear(glm::vec3(medium.color)), 0.0f);
    block.extinction = glm::vec4(glm::vec3(medium.extinction), 0.0f);
    set_window(block, layer, format.size);
    return block;
}

void turn_block(LayerBlock& block, const Layer& layer, float view_aspect) {
    const float c = std::cos(layer.angle), s = std::sin(layer.angle);
    const float mirror = layer.mirrored ? -1.0f : 1.0f;
    // mirror * to_unit * rotation * to_square, by columns
    block.turn = glm::vec4(mirror * c, s * view_aspect, mirror * -s / view_aspect, c);
}

}  // namespace lapfx::smoke
