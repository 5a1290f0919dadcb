// A linked vertex and fragment shader. Values are set by name on the program itself, so no program need be
// bound.
//
//     const Program post("fullscreen.vert", "post.frag");
//     post.set("u_exposure", 1.5f);
//
// Setting a uniform that is declared but not used has no effect and is not a fault, because variants of one shader use
// different uniforms.
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
    /// File names in shaders/. Throws Error (runtime) with file, line and the numbered source around it. `defines`:
    /// whole lines of `#define NAME` before both texts, to make variants of one shader.
    Program(const std::string& vertex, const std::string& fragment, const std::string& defines = "");

    /// The same program compiled again from the present texts. Throws like the constructor. An empty program gives an
    /// empty one.
    Program rebuilt() const;

    void use() const { glUseProgram(name_.get()); }
    /// Throws Error (runtime), which ends a noexcept caller, for a name that neither text declares, and for a value
    /// whose type differs from that of a used uniform: both are faults of the caller. If a text comes from disk such a
    /// value is ignored, because uniforms change while somebody edits a shader.
    void set(const char* uniform, int value) const;
    void set(const char* uniform, float value) const;
    void set(const char* uniform, glm::vec2 value) const;
    void set(const char* uniform, glm::vec3 value) const;
    void set(const char* uniform, glm::vec4 value) const;
    void set(const char* uniform, std::span<const glm::vec4> values) const;  ///< an array
    void set(const char* uniform, glm::ivec4 value) const;
    void set(const char* uniform, const glm::mat3& value) const;
    void set(const char* uniform, const glm::mat4& value) const;
    GLuint name() const { return name_.get(); }

  private:
    struct Uniform {
        GLint location = -1;  ///< -1: declared, not used
        GLenum type = 0;      ///< GL tells it, which knows only used uniforms
    };
    void find_used();
    GLint location(const char* uniform, GLenum type) const;

    struct Hash {
        using is_transparent = void;  // so that a look-up by const char* allocates nothing
        std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
    };
    std::string vertex_, fragment_, defines_;  // its files and defines
    Name<release_program> name_;
    std::unordered_map<std::string, Uniform, Hash, std::equal_to<>> uniforms_;
    bool edited_ = false;  // some of its text comes from disk
};

/// Compiles all of them again, and replaces all or none. Throws Error (runtime).
void rebuild(std::span<Program* const> programs);

}  // namespace lapfx::gl
