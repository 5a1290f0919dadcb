// Bleed values and blood parameters of the model `spread` on the GPU: the vertex buffer (attribute 5 of
// shaders/organ.vert) and the uniform block LapfxBleeding of shaders/bleeding_block.glsl. Render thread, context
// current.
#pragma once

#include "bleeding/bleeding_gpu.h"

namespace lapfx::bleeding {

class BleedGpu final : public BleedingGpu {
  public:
    explicit BleedGpu(std::size_t vertices);

    Model model() const override { return Model::spread; }
    std::span<const Attribute> attributes() const override { return {&attribute_, 1}; }
    void set(const BleedingParameters& parameters, const glm::dvec3& down, std::uint32_t seed) const noexcept override;
    std::size_t send(const Bleeding& blood, std::span<const VertexRun> changed) const noexcept override;
    /// The runs of `values`, which are per organ vertex: bleed value in mm, clot 0..1.
    std::size_t send(std::span<const glm::vec2> values, std::span<const VertexRun> changed) const noexcept;
    void bind() const noexcept override;  ///< the uniform block, binding 1
    std::size_t memory() const override { return values_.size(); }

  private:
    gl::Buffer values_;
    gl::Buffer block_;
    Attribute attribute_{5, &values_, 2};
};

}  // namespace lapfx::bleeding
