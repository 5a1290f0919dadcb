// Bleed values and blood parameters on the GPU: the vertex buffer (attribute 5 of shaders/organ.vert) and the
// uniform block LapfxBleeding of shaders/bleeding.glsl. Render thread, context current.
#pragma once

#include <cstdint>
#include <span>

#include "gl/objects.h"
#include "lapfx/preset.h"

namespace lapfx::bleeding {

class BleedGpu {
  public:
    BleedGpu(std::size_t vertex_count, std::uint32_t seed);

    void set(const BleedingParameters& parameters) const noexcept;
    /// Sends values[begin, end) of all `values`; nothing when the range is empty.
    void send(std::span<const float> values, std::uint32_t begin, std::uint32_t end) const noexcept;
    void bind() const noexcept;  ///< the uniform block, binding 1

    const gl::Buffer& values() const { return values_; }

  private:
    gl::Buffer values_;
    gl::Buffer block_;
    std::uint32_t seed_;
};

}  // namespace lapfx::bleeding
