#include "gl/program.h"

#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <sstream>
#include <utility>

#include "gl/shader_source.h"
#include "lapfx/error.h"

namespace lapfx::gl {

void release_program(GLuint name) {
    glDeleteProgram(name);
}

namespace {

void release_shader(GLuint name) {
    glDeleteShader(name);
}
using Shader = Name<release_shader>;

template <typename GetInteger, typename GetLog>
std::string read_log(GLuint name, GetInteger get_integer, GetLog get_log) {
    GLint length = 0;
    get_integer(name, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    get_log(name, length, nullptr, log.data());
    log.resize(log.find('\0') == std::string::npos ? log.size() : log.find('\0'));
    return log;
}

/// One fault per line of the log, so that each stays a line of its own on stderr.
Error shader_error(const std::string& name, const std::string& log) {
    std::vector<Fault> faults{{.file = name, .place = "", .reason = "the shader does not compile"}};
    std::size_t begin = 0;
    while (begin < log.size()) {
        const std::size_t end = std::min(log.find('\n', begin), log.size());
        if (end > begin) faults.push_back({.file = "", .place = "", .reason = log.substr(begin, end - begin)});
        begin = end + 1;
    }
    return {Failure::runtime, std::move(faults)};
}

Shader compile(GLenum stage, const std::string& name, const ShaderSource& source, const std::string& defines) {
    Shader shader(glCreateShader(stage));
    std::string text = source.text;
    if (!defines.empty()) text.insert(text.find('\n') + 1, defines + "#line 2 0\n");  // #version stays first
    const char* lines = text.c_str();
    glShaderSource(shader.get(), 1, &lines, nullptr);
    glCompileShader(shader.get());
    GLint done = 0;
    glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &done);
    if (done == GL_FALSE)
        throw shader_error(name, readable_log(source, read_log(shader.get(), glGetShaderiv, glGetShaderInfoLog)));
    return shader;
}

constexpr std::array<std::pair<std::string_view, GLenum>, 10> types{{{"int", GL_INT},
                                                                     {"bool", GL_INT},
                                                                     {"float", GL_FLOAT},
                                                                     {"vec2", GL_FLOAT_VEC2},
                                                                     {"vec3", GL_FLOAT_VEC3},
                                                                     {"vec4", GL_FLOAT_VEC4},
                                                                     {"ivec4", GL_INT_VEC4},
                                                                     {"mat3", GL_FLOAT_MAT3},
                                                                     {"mat4", GL_FLOAT_MAT4},
                                                                     {"sampler", GL_INT}}};

/// In the words of GLSL.
std::string_view word_of(GLenum type) {
    for (const auto& [word, known] : types)
        if (known == type) return word;
    return "a type that is never set";
}

GLenum type_of(std::string_view word) {
    for (const auto& [known, type] : types)
        if (word == known || (known == "sampler" && word.starts_with(known))) return type;
    return 0;
}

/// Type and name of each uniform outside of a block that a text declares, in whatever variant of it.
template <typename Take>
void for_each_uniform(const std::string& text, const Take& take) {
    constexpr std::string_view word = "uniform ";
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        const std::size_t line = text.rfind('\n', at) + 1, end = text.find_first_of(";{", at);
        const bool comment = std::string_view(text).substr(line, at - line).find("//") != std::string_view::npos;
        if (comment || end == std::string::npos || text[end] == '{') continue;
        std::istringstream words(text.substr(at + word.size(), end - at - word.size()));
        std::string type, name;
        words >> type;
        while (std::getline(words >> std::ws, name, ',')) take(type, name.substr(0, name.find_first_of(" [")));
    }
}

}  // namespace

Program::Program(const std::string& vertex, const std::string& fragment, const std::string& defines)
    : vertex_(vertex), fragment_(fragment), defines_(defines), name_(glCreateProgram()) {
    const ShaderSource vertex_source = shader_source(vertex), fragment_source = shader_source(fragment);
    const Shader vertex_shader = compile(GL_VERTEX_SHADER, vertex, vertex_source, defines);
    const Shader fragment_shader = compile(GL_FRAGMENT_SHADER, fragment, fragment_source, defines);
    glAttachShader(name(), vertex_shader.get());
    glAttachShader(name(), fragment_shader.get());
    glLinkProgram(name());
    // What is attached stays as long as the program, with all that its compiler knew.
    glDetachShader(name(), vertex_shader.get());
    glDetachShader(name(), fragment_shader.get());
    GLint done = 0;
    glGetProgramiv(name(), GL_LINK_STATUS, &done);
    if (done == GL_FALSE)
        throw shader_error(vertex + " + " + fragment, read_log(name(), glGetProgramiv, glGetProgramInfoLog));

    edited_ = vertex_source.edited || fragment_source.edited;
    for (const ShaderSource* source : {&vertex_source, &fragment_source})
        for_each_uniform(source->text, [&](const std::string& type, const std::string& uniform) {
            uniforms_[uniform] = {.location = glGetUniformLocation(name(), uniform.c_str()), .type = type_of(type)};
        });
}

Program Program::rebuilt() const {
    return name() == 0 ? Program() : Program(vertex_, fragment_, defines_);
}

void rebuild(std::span<Program* const> programs) {
    std::vector<Program> made;
    for (const Program* program : programs) made.push_back(program->rebuilt());
    for (std::size_t i = 0; i < programs.size(); ++i) *programs[i] = std::move(made[i]);
}

GLint Program::location(const char* uniform, GLenum type) const {
    const auto found = uniforms_.find(std::string_view(uniform));
    const bool known = found != uniforms_.end();
    if (known && found->second.type == type) return found->second.location;
    if (edited_) return -1;  // GL ignores it
    throw Error(Failure::runtime,
                Fault{.file = vertex_ + " + " + fragment_,
                      .place = uniform,
                      .reason = known ? "a value of type " + std::string(word_of(type)) +
                                            " is set; it is declared as " + std::string(word_of(found->second.type))
                                      : std::string("is set, but not declared as a uniform")});
}

void Program::set(const char* uniform, int value) const {
    glProgramUniform1i(name(), location(uniform, GL_INT), value);
}
void Program::set(const char* uniform, float value) const {
    glProgramUniform1f(name(), location(uniform, GL_FLOAT), value);
}
void Program::set(const char* uniform, glm::vec2 value) const {
    glProgramUniform2fv(name(), location(uniform, GL_FLOAT_VEC2), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, glm::vec3 value) const {
    glProgramUniform3fv(name(), location(uniform, GL_FLOAT_VEC3), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, glm::vec4 value) const {
    glProgramUniform4fv(name(), location(uniform, GL_FLOAT_VEC4), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, glm::ivec4 value) const {
    glProgramUniform4iv(name(), location(uniform, GL_INT_VEC4), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::mat3& value) const {
    glProgramUniformMatrix3fv(name(), location(uniform, GL_FLOAT_MAT3), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::mat4& value) const {
    glProgramUniformMatrix4fv(name(), location(uniform, GL_FLOAT_MAT4), 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace lapfx::gl
