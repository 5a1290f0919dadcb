#include "smoke/layer_gpu.h"

#include <cmath>

#include "gl/srgb.h"
#include "smoke/keying.h"

namespace lapfx::smoke {

LayerBlock layer_block(const Layer& layer, const Medium& medium, double extra) {
    const KeyingParameters& k = *layer.keying;
    const PictureFormat& format = layer.frame.format;
    LayerBlock block{};
    const Keying key = keying_of(k, layer.polarity);
    block.luma_chroma = glm::vec4(key.luma_low, key.luma_high, key.chroma_low, key.chroma_high);
    block.key = glm::vec4(key.key_chroma, key.spill, key.dark);
    block.vary =
        glm::vec4(glm::vec3(glm::dvec3(k.noise_strength, k.choke, k.feather)), static_cast<float>(layer.frame.layer));
    block.color = glm::vec4(gl::to_linear(glm::vec3(medium.color)), static_cast<float>(layer.density));
    block.extinction = glm::vec4(glm::vec3(medium.extinction), static_cast<float>(extra));
    const glm::vec2 size(format.size);
    // An odd size has half a chroma sample too many at its end.
    block.size = glm::vec4(size, 0.5f * size / glm::vec2(format.chroma_size()));
    block.turn = glm::vec4(layer.mirrored ? -1.0f : 1.0f, 0.0f, 0.0f, 1.0f);
    if (layer.frame.matrix != nullptr) {
        const ColorMatrix& m = *layer.frame.matrix;
        const glm::mat3 rows = glm::transpose(m.matrix);
        const glm::vec3 added = -(m.matrix * m.offset);
        for (int i = 0; i < 3; ++i) block.code_rows[i] = glm::vec4(rows[i], added[i]);
    }
    return block;
}

void turn_block(LayerBlock& block, const Layer& layer, float view_aspect) {
    const float c = std::cos(layer.angle), s = std::sin(layer.angle);
    const float mirror = layer.mirrored ? -1.0f : 1.0f;
    // mirror * to_unit * rotation * to_square, by columns
    block.turn = glm::vec4(mirror * c, s * view_aspect, mirror * -s / view_aspect, c);
}

}  // namespace lapfx::smoke
