#include "gl/program.h"

#include <glm/gtc/type_ptr.hpp>

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

Shader compile(GLenum stage, const std::string& name, const std::string& defines) {
    const ShaderSource source = shader_source(name);
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

}  // namespace

Program::Program(const std::string& vertex, const std::string& fragment, const std::string& defines)
    : vertex_(vertex), fragment_(fragment), defines_(defines), name_(glCreateProgram()) {
    const Shader vertex_shader = compile(GL_VERTEX_SHADER, vertex, defines);
    const Shader fragment_shader = compile(GL_FRAGMENT_SHADER, fragment, defines);
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

    GLint count = 0;
    glGetProgramiv(name(), GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        char uniform[128] = {};
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(name(), static_cast<GLuint>(i), sizeof uniform, nullptr, &size, &type, uniform);
        locations_.emplace(uniform, glGetUniformLocation(name(), uniform));
    }
}

Program Program::rebuilt() const {
    return name() == 0 ? Program() : Program(vertex_, fragment_, defines_);
}

void rebuild(std::span<Program* const> programs) {
    std::vector<Program> made;
    for (const Program* program : programs) made.push_back(program->rebuilt());
    for (std::size_t i = 0; i < programs.size(); ++i) *programs[i] = std::move(made[i]);
}

GLint Program::location(const char* uniform) const {
    const auto found = locations_.find(std::string_view(uniform));
    return found == locations_.end() ? -1 : found->second;
}

void Program::set(const char* uniform, int value) const {
    glProgramUniform1i(name(), location(uniform), value);
}
void Program::set(const char* uniform, float value) const {
    glProgramUniform1f(name(), location(uniform), value);
}
void Program::set(const char* uniform, glm::vec2 value) const {
    glProgramUniform2fv(name(), location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, glm::vec3 value) const {
    glProgramUniform3fv(name(), location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, glm::vec4 value) const {
    glProgramUniform4fv(name(), location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, glm::ivec4 value) const {
    glProgramUniform4iv(name(), location(uniform), 1, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::mat3& value) const {
    glProgramUniformMatrix3fv(name(), location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(const char* uniform, const glm::mat4& value) const {
    glProgramUniformMatrix4fv(name(), location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace lapfx::gl
