#include "gl/state_guard.h"

#include <string_view>

namespace lapfx::gl {

namespace {

constexpr GLenum blend_queries[6] = {GL_BLEND_SRC_RGB,   GL_BLEND_DST_RGB,      GL_BLEND_SRC_ALPHA,
                                     GL_BLEND_DST_ALPHA, GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA};

GLenum as_enum(GLint value) {
    return static_cast<GLenum>(value);
}
GLuint as_name(GLint value) {
    return static_cast<GLuint>(value);
}

PolygonOffsetClamp loaded_clamp = nullptr;  // gl.h lacks this function

bool has_extension(std::string_view name) {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
        const GLubyte* extension = glGetStringi(GL_EXTENSIONS, i);
        if (extension != nullptr && name == reinterpret_cast<const char*>(extension)) return true;
    }
    return false;
}

bool is_version_4_6() {
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    return major > 4 || (major == 4 && minor >= 6);
}

}  // namespace

PolygonOffsetClamp polygon_offset_clamp() noexcept {
    return loaded_clamp;
}

/// Drivers also give addresses for functions that they do not have.
void load_polygon_offset_clamp(GLADloadfunc get_proc_address) {
    const char* name = is_version_4_6() || has_extension("GL_ARB_polygon_offset_clamp") ? "glPolygonOffsetClamp"
                       : has_extension("GL_EXT_polygon_offset_clamp")                   ? "glPolygonOffsetClampEXT"
                                                                                        : nullptr;
    loaded_clamp = name != nullptr ? reinterpret_cast<PolygonOffsetClamp>(get_proc_address(name)) : nullptr;
}

StateGuard::StateGuard() noexcept {
    for (std::size_t i = 0; i < switches.size(); ++i) enabled_[i] = glIsEnabled(switches[i]);
    for (GLuint i = 0; i < uniform_bindings; ++i) {
        UniformBinding& binding = uniform_buffers_[i];
        glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, i, &binding.buffer);
        glGetInteger64i_v(GL_UNIFORM_BUFFER_START, i, &binding.start);
        glGetInteger64i_v(GL_UNIFORM_BUFFER_SIZE, i, &binding.size);
    }
    glGetIntegerv(GL_UNIFORM_BUFFER_BINDING, &uniform_buffer_);
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active_texture_);
    for (int i = 0; i < texture_units; ++i) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        glGetIntegerv(GL_TEXTURE_BINDING_2D, &textures_[static_cast<std::size_t>(i)]);
        glGetIntegerv(GL_TEXTURE_BINDING_2D_ARRAY, &texture_arrays_[static_cast<std::size_t>(i)]);
        glGetIntegerv(GL_SAMPLER_BINDING, &samplers_[static_cast<std::size_t>(i)]);
        if (samplers_[static_cast<std::size_t>(i)] != 0) glBindSampler(static_cast<GLuint>(i), 0);
    }
    glActiveTexture(as_enum(active_texture_));
    glGetIntegerv(GL_CURRENT_PROGRAM, &program_);
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertex_array_);
    glGetIntegerv(GL_DEPTH_FUNC, &depth_function_);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &depth_mask_);
    for (int i = 0; i < 6; ++i) glGetIntegerv(blend_queries[i], &blend_[i]);
    glGetFloatv(GL_POLYGON_OFFSET_FACTOR, &offset_factor_);
    glGetFloatv(GL_POLYGON_OFFSET_UNITS, &offset_units_);
    if (loaded_clamp != nullptr) glGetFloatv(polygon_offset_clamp_query, &offset_clamp_);
}

StateGuard::~StateGuard() {
    for (std::size_t i = 0; i < switches.size(); ++i)
        enabled_[i] == GL_TRUE ? glEnable(switches[i]) : glDisable(switches[i]);
    for (GLuint i = 0; i < uniform_bindings; ++i) {
        const UniformBinding& binding = uniform_buffers_[i];
        if (binding.buffer != 0 && binding.size > 0)
            glBindBufferRange(GL_UNIFORM_BUFFER, i, as_name(binding.buffer), binding.start, binding.size);
        else
            glBindBufferBase(GL_UNIFORM_BUFFER, i, as_name(binding.buffer));
    }
    glBindBuffer(GL_UNIFORM_BUFFER, as_name(uniform_buffer_));
    for (int i = 0; i < texture_units; ++i) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        glBindTexture(GL_TEXTURE_2D, as_name(textures_[static_cast<std::size_t>(i)]));
        glBindTexture(GL_TEXTURE_2D_ARRAY, as_name(texture_arrays_[static_cast<std::size_t>(i)]));
        if (samplers_[static_cast<std::size_t>(i)] != 0)
            glBindSampler(static_cast<GLuint>(i), as_name(samplers_[static_cast<std::size_t>(i)]));
    }
    glActiveTexture(as_enum(active_texture_));
    // A program that the host has deleted while it was current does not exist after another one has been used.
    glUseProgram(program_ != 0 && glIsProgram(as_name(program_)) == GL_TRUE ? as_name(program_) : 0);
    glBindVertexArray(as_name(vertex_array_));
    glDepthFunc(as_enum(depth_function_));
    glDepthMask(depth_mask_);
    if (loaded_clamp != nullptr)
        loaded_clamp(offset_factor_, offset_units_, offset_clamp_);
    else
        glPolygonOffset(offset_factor_, offset_units_);
    glBlendFuncSeparate(as_enum(blend_[0]), as_enum(blend_[1]), as_enum(blend_[2]), as_enum(blend_[3]));
    glBlendEquationSeparate(as_enum(blend_[4]), as_enum(blend_[5]));
}

}  // namespace lapfx::gl
