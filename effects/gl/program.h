// A linked vertex and fragment shader. Values are set by name on the program itself, so no program need be
// bound.
//
//     const Program post("fullscreen.vert", "post.frag");
//     post.set("u_exposure", 1.5f);
//
// A uniform that is declared but that the compiler has found no use for is set in vain, without a fault: variants of
// one shader use some and not others.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <unordered_map>

#include "gl/gl.h"
#include "gl/objects.h"

namespace lapfx::gl {

void release_program(GLuint name);

class Program {
  public:
    Program() = default;
    /// File names in shaders/. Throws Error (runtime) with file, line and the numbered source around it.
    /// `defines`: whole lines of `#define NAME`, put before both texts, to make variants of one shader.
    Program(const std::string& vertex, const std::string& fragment, const std::string& defines = "");

    /// Compiled once more, from the texts as they are now. Throws as the constructor. Of an empty one, an empty one.
    Program rebuilt() const;

    void use() const { glUseProgram(name_.get()); }
    /// Throws Error (runtime), which ends a caller that is noexcept, for a name that neither text declares, and for a
    /// value of another type than declared: a fault of the caller. Where a text comes from disk such a value is
    /// ignored: while a shader is edited, its uniforms come and go.
    void set(const char* uniform, int value) const;
    void set(const char* uniform, float value) const;
    void set(const char* uniform, glm::vec2 value) const;
    void set(const char* uniform, glm::vec3 value) const;
    void set(const char* uniform, glm::vec4 value) const;
    void set(const char* uniform, glm::ivec4 value) const;
    void set(const char* uniform, const glm::mat3& value) const;
    void set(const char* uniform, const glm::mat4& value) const;
    GLuint name() const { return name_.get(); }

  private:
    struct Uniform {
        GLint location = -1;  ///< -1: declared, not used
        GLenum type = 0;      ///< of the value that is set; a sampler's and a bool's is GL_INT
    };
    GLint location(const char* uniform, GLenum type) const;

    struct Hash {
        using is_transparent = void;  // look-ups by const char* allocate nothing
        std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
    };
    std::string vertex_, fragment_, defines_;  // what it was made of
    Name<release_program> name_;
    std::unordered_map<std::string, Uniform, Hash, std::equal_to<>> uniforms_;
    bool edited_ = false;  // some of its text comes from disk
};

/// All of them compiled once more and then taken, or none. Throws Error (runtime).
void rebuild(std::span<Program* const> programs);

}  // namespace lapfx::gl
