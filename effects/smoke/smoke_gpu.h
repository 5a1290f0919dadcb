// Draws plume and haze over a frame with dual-source blending. Render thread, context current, the view block
// bound at 0.
#pragma once

#include <cstdint>

#include "gl/objects.h"
#include "gl/program.h"
#include "lapfx/preset.h"

namespace lapfx::smoke {

/// One clip drawn once.
struct Layer {
    const gl::Texture* frame = nullptr;
    const SmokeClip* clip = nullptr;
    glm::dvec3 color{1.0};  ///< sRGB
    glm::dvec3 extinction{1.0};
    double density = 1.0;        ///< plume: multiplies the optical thickness; haze: E
    double time = 0.0;           ///< s, for the noise drift
    std::uint32_t seed = 0;      ///< noise and mirroring
    double soft_distance = 6.0;  ///< mm over which the smoke fades where it meets tissue
};

class SmokeGpu {
  public:
    /// Compiles shaders: throws Error (runtime).
    SmokeGpu();

    /// Sets blending for all layers that follow; `scene_depth` is the depth texture of what has been drawn.
    void begin(GLuint scene_depth) const noexcept;
    void plume(const Layer& layer, const KeyingParameters& keying, glm::vec3 anchor, float height,
               glm::vec2 up) const noexcept;
    void haze(const Layer& layer, const KeyingParameters& keying, float unevenness) const noexcept;

  private:
    void bind(const Layer& layer, const KeyingParameters& keying) const noexcept;

    gl::Program plume_;
    gl::Program haze_;
    gl::Buffer block_;
    gl::VertexArray no_attributes_;
};

}  // namespace lapfx::smoke
