#include "bleeding/bleed_gpu.h"

#include <vector>

#include "gl/srgb.h"

namespace lapfx::bleeding {

namespace {

/// LapfxBleeding, std140.
struct Block {
    glm::vec4 edge, thin, deep, surface, down;
};

constexpr GLuint block_binding = 1;

}  // namespace

BleedGpu::BleedGpu(std::size_t vertices)
    : values_(std::span<const glm::vec2>(std::vector<glm::vec2>(vertices, glm::vec2(0.0f)))), block_(sizeof(Block)) {}

void BleedGpu::set(const BleedingParameters& b, const glm::dvec3& down, std::uint32_t seed) const noexcept {
    const Block block{
        .edge = glm::vec4(glm::dvec4(b.threshold, b.noise_scale, b.noise_strength, b.noise_octaves)),
        .thin = glm::vec4(gl::to_linear(glm::vec3(b.color_thin)), static_cast<float>(b.deep_at)),
        .deep = glm::vec4(gl::to_linear(glm::vec3(b.color_deep)), static_cast<float>(b.opacity)),
        // The shader's seed is a float, which must represent it exactly.
        .surface = glm::vec4(glm::dvec4(b.thickness, b.gloss, seed & 0xffffu, b.rivulets)),
        .down = glm::vec4(glm::dvec4(down, b.clot_darkening)),
    };
    block_.update(0, sizeof block, &block);
}

std::size_t BleedGpu::send(const Bleeding& blood, std::span<const VertexRun> changed) const noexcept {
    const DrawnArray& values = blood.drawn().front();
    return send({static_cast<const glm::vec2*>(values.data), values.count}, changed);
}

std::size_t BleedGpu::send(std::span<const glm::vec2> values, std::span<const VertexRun> changed) const noexcept {
    std::size_t bytes = 0;
    for (const VertexRun& run : changed) bytes += values_.update(values, run.begin, run.end);
    return bytes;
}

void BleedGpu::bind() const noexcept {
    glBindBufferBase(GL_UNIFORM_BUFFER, block_binding, block_.name());
}

}  // namespace lapfx::bleeding
