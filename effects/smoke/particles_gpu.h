// Draws specks of fat (particles_cpu.h gives their places) as quads that face the camera. The fragment shader shapes
// them, and whatever is in front hides them. Render thread, context current.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "gl/gl.h"
#include "gl/objects.h"
#include "gl/program.h"

namespace lapfx::smoke {

constexpr std::size_t most_specks = 256;  ///< one draw has no more

/// The uniform block LapfxSpecks of shaders/particles.vert, std140.
struct SpeckBlock {
    struct Speck {
        glm::vec4 place;  ///< xyz mm, organ space; diameter, mm
        glm::vec4 look;   ///< opacity, glow, random shape (0..1), unused
    };
    std::array<Speck, most_specks> specks;
};

class ParticlesGpu {
  public:
    /// Compiles shaders: throws Error (runtime).
    ParticlesGpu();

    gl::Program& program() noexcept { return program_; }  ///< for gl::rebuild()
    /// To be filled before draw(); memory of this object.
    SpeckBlock& specks() { return specks_; }

    /// Over the bound framebuffer, the first `count` of specks(). `color`: sRGB. `scene_depth`: depth texture of the
    /// frame, the size of the viewport. The view block is bound at 0. Leaves blending on with its own settings, its
    /// block at 2, the depth texture at unit 1.
    void draw(std::size_t count, glm::vec3 color, GLuint scene_depth) const noexcept;

  private:
    SpeckBlock specks_{};
    gl::Program program_;
    gl::Buffer block_;
    gl::VertexArray no_attributes_;
};

}  // namespace lapfx::smoke
