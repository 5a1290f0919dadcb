// The off-screen frame: scene in linear light with multisampling, smoke over the resolved picture, then the camera's
// response into an 8-bit sRGB picture. One frame path for the editor, `lapfx render` and hosts that use Preview.
#pragma once

#include "gl/objects.h"
#include "gl/program.h"
#include "lapfx/camera.h"

namespace lapfx::render {

/// How a plate is shown.
struct PlateShown {
    bool there = false;      ///< the frame is over a plate: where the camera has a shoulder, light has been through it
    GLuint picture = 0;      ///< in the middle, sRGB code values; alpha: what is drawn, the rest stays as it is
    glm::vec2 extent{0.0f};  ///< share of the frame that the picture covers, black around it; 0: none is shown
};

class Frame {
  public:
    /// Throws Error (runtime) when a shader does not compile.
    Frame();

    /// Makes the targets for `size` unless they have that size. Throws Error: bad_input beyond the driver's largest
    /// size, runtime when it cannot make them.
    void resize(glm::ivec2 size);
    void begin_scene() const noexcept;              ///< binds and clears the multisampled target
    void begin_smoke() const noexcept;              ///< resolves it; binds the resolved colour
    gl::Program& post() noexcept { return post_; }  ///< for gl::rebuild()
    std::size_t memory() const noexcept;            ///< bytes on the GPU
    GLuint scene_depth() const noexcept { return resolved_depth_.name(); }
    /// Writes the finished picture into `framebuffer`, lower left corner first.
    void finish(GLuint framebuffer, const CameraResponse& response, const PlateShown& plate = {}) const noexcept;

  private:
    glm::ivec2 size_{0};
    gl::Texture color_, depth_, resolved_color_, resolved_depth_;
    gl::Framebuffer scene_, smoke_, resolve_;
    gl::Program post_;
    gl::VertexArray no_attributes_;
};

}  // namespace lapfx::render
