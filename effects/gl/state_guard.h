// Saves the GL state that the core's draw calls touch and restores it. Samplers that the host has bound are unbound
// meanwhile, because they would override the filtering of the core's textures. State that GL keeps for each draw buffer
// (blending) or viewport (scissor test) is saved from the first and restored for all. effects.h requires it to be the
// same for all, because querying each of them in every frame would cost every host more than it helps a rare one.
#pragma once

#include <array>

#include "gl/gl.h"

namespace lapfx::gl {

/// glPolygonOffsetClamp, without which setting an offset would lose the host's clamp. It belongs to OpenGL 4.6 or an
/// extension, so gl.h lacks it. Null if the driver does not have it.
using PolygonOffsetClamp = void(GLAD_API_PTR*)(GLfloat factor, GLfloat units, GLfloat clamp);
PolygonOffsetClamp polygon_offset_clamp() noexcept;
constexpr GLenum polygon_offset_clamp_query = 0x8E1B;  // GL_POLYGON_OFFSET_CLAMP
/// Looks for it in the current context, whose other functions are loaded.
void load_polygon_offset_clamp(GLADloadfunc get_proc_address);

class StateGuard {
  public:
    StateGuard() noexcept;
    ~StateGuard();
    StateGuard(const StateGuard&) = delete;
    StateGuard& operator=(const StateGuard&) = delete;

  private:
    static constexpr std::array<GLenum, 6> switches{GL_BLEND,       GL_DEPTH_TEST,   GL_CULL_FACE,
                                                    GL_MULTISAMPLE, GL_SCISSOR_TEST, GL_POLYGON_OFFSET_FILL};
    static constexpr int uniform_bindings = 3;
    static constexpr int texture_units = 14;

    std::array<GLboolean, switches.size()> enabled_{};
    struct UniformBinding {
        GLint buffer = 0;
        GLint64 start = 0, size = 0;  // size 0: the whole buffer
    };
    std::array<UniformBinding, uniform_bindings> uniform_buffers_{};
    std::array<GLint, texture_units> textures_{}, texture_arrays_{}, samplers_{};
    GLint program_ = 0, vertex_array_ = 0, depth_function_ = 0, active_texture_ = 0, uniform_buffer_ = 0;
    GLint blend_[6] = {};
    GLfloat offset_factor_ = 0.0f, offset_units_ = 0.0f, offset_clamp_ = 0.0f;
    GLboolean depth_mask_ = GL_TRUE;
};

}  // namespace lapfx::gl
