// Bleed values and blood parameters on the GPU: the vertex buffer (attribute 5 of shaders/organ.vert) and the
// uniform block LapfxBleeding of shaders/bleeding_block.glsl. Render thread, context current.
#pragma once

#include <cstdint>
#include <span>

#include "gl/objects.h"
#include "lapfx/bleeding_parameters.h"
#include "organ/changed_vertices.h"

namespace lapfx::bleeding {

class BleedGpu {
  public:
    /// `down`: unit, organ space: the direction in which rivulets run.
    BleedGpu(std::size_t vertex_count, std::uint32_t seed, glm::dvec3 down);

    void set(const BleedingParameters& parameters) const noexcept;
    /// They take effect with the next set().
    void set_down(glm::dvec3 down) { down_ = down; }
    void set_seed(std::uint32_t seed) { seed_ = seed; }
    /// Sends the runs of `values` (per organ vertex: bleed value in mm, clot 0..1) that have changed;
    /// bytes sent.
    std::size_t send(std::span<const glm::vec2> values, std::span<const VertexRun> changed) const noexcept;
    void bind() const noexcept;  ///< the uniform block, binding 1

    const gl::Buffer& values() const { return values_; }

  private:
    gl::Buffer values_;
    gl::Buffer block_;
    std::uint32_t seed_;
    glm::dvec3 down_;
};

}  // namespace lapfx::bleeding
