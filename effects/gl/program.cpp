#include "gl/program.h"

#include <array>
#include <cctype>
#include <glm/gtc/type_ptr.hpp>
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

/// One fault per line of the log, so that each is one line on stderr.
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

/// The text that is compiled.
std::string text_of(const ShaderSource& source, const std::string& defines) {
    std::string text = source.text;
    if (!defines.empty()) text.insert(text.find('\n') + 1, defines + "#line 2 0\n");  // #version stays first
    return text;
}

Shader compile(GLenum stage, const std::string& name, const ShaderSource& source, const std::string& text) {
    Shader shader(glCreateShader(stage));
    const char* lines = text.c_str();
    glShaderSource(shader.get(), 1, &lines, nullptr);
    glCompileShader(shader.get());
    GLint done = 0;
    glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &done);
    if (done == GL_FALSE)
        throw shader_error(name, readable_log(source, read_log(shader.get(), glGetShaderiv, glGetShaderInfoLog)));
    return shader;
}

constexpr std::array<std::pair<std::string_view, GLenum>, 12> types{{{"int", GL_INT},
                                                                     {"uint", GL_UNSIGNED_INT},
                                                                     {"bool", GL_BOOL},
                                                                     {"float", GL_FLOAT},
                                                                     {"vec2", GL_FLOAT_VEC2},
                                                                     {"vec3", GL_FLOAT_VEC3},
                                                                     {"vec4", GL_FLOAT_VEC4},
                                                                     {"ivec4", GL_INT_VEC4},
                                                                     {"mat3", GL_FLOAT_MAT3},
                                                                     {"mat4", GL_FLOAT_MAT4},
                                                                     {"sampler2D", GL_SAMPLER_2D},
                                                                     {"sampler2DArray", GL_SAMPLER_2D_ARRAY}}};

/// The word of GLSL for a type.
std::string_view word_of(GLenum type) {
    for (const auto& [word, known] : types)
        if (known == type) return word;
    return "a type that is never set";
}

/// 0 for types whose values are never set.
GLenum type_of(std::string_view word) {
    for (const auto& [known, type] : types)
        if (known == word) return type;
    return 0;
}

/// Whether a value of one type can set a uniform of another: a sampler takes the number of its unit.
bool takes(GLenum declared, GLenum value) {
    const bool by_int = declared == GL_BOOL || declared == GL_SAMPLER_2D || declared == GL_SAMPLER_2D_ARRAY;
    return (by_int ? GLenum{GL_INT} : declared) == value;
}

std::string without_comments(const std::string& text) {
    std::string code;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t comment = std::min(text.find("//", at), text.find("/*", at));
        code.append(text, at, comment - at);
        if (comment == std::string::npos) break;
        const bool line = text[comment + 1] == '/';
        const std::size_t end = line ? text.find('\n', comment) : text.find("*/", comment + 2);
        code += ' ';
        at = end == std::string::npos ? text.size() : end + (line ? 0 : 2);
    }
    return code;
}

bool in_word(char c) {
    return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0;
}

/// The last word of it.
std::string last_word(std::string_view text) {
    std::size_t end = text.size();
    while (end > 0 && !in_word(text[end - 1])) --end;
    std::size_t begin = end;
    while (begin > 0 && in_word(text[begin - 1])) --begin;
    return std::string(text.substr(begin, end - begin));
}

/// Calls take(name, type) for each uniform that is declared outside blocks in any variant of a shader. `declaration`:
/// what stands between `uniform` and its semicolon, "vec4 u_a, u_b[2] = vec4[2](...)".
template <typename Take>
void read_declaration(std::string_view declaration, const Take& take) {
    std::string type;
    int depth = 0;
    for (std::size_t begin = 0, at = 0; at <= declaration.size(); ++at) {
        const char c = at < declaration.size() ? declaration[at] : ',';
        if (c == '(' || c == '[' || c == '{') ++depth;
        if (c == ')' || c == ']' || c == '}') --depth;
        if (c != ',' || depth > 0) continue;
        const std::string_view part = declaration.substr(begin, at - begin),
                               head = part.substr(0, part.find_first_of("[="));
        std::string name = last_word(head);
        if (begin == 0) type = last_word(head.substr(0, head.rfind(name)));
        if (!name.empty()) take(std::move(name), type);
        begin = at + 1;
    }
}

template <typename Take>
void for_each_declared(const std::string& text, const Take& take) {
    constexpr std::string_view keyword = "uniform";
    const std::string code = without_comments(text);
    for (std::size_t at = code.find(keyword); at != std::string::npos; at = code.find(keyword, at + 1)) {
        const std::size_t begin = at + keyword.size();
        const std::size_t kind = code.find_first_of(";={", begin), end = code.find(';', begin);
        const bool inside_word = (at > 0 && in_word(code[at - 1])) || (begin < code.size() && in_word(code[begin]));
        if (inside_word || end == std::string::npos || code[kind] == '{') continue;
        read_declaration(std::string_view(code).substr(begin, end - begin), take);
    }
}

}  // namespace

Program::Program(const std::string& vertex, const std::string& fragment, const std::string& defines)
    : vertex_(vertex), fragment_(fragment), defines_(defines), name_(glCreateProgram()) {
    const ShaderSource vertex_source = shader_source(vertex), fragment_source = shader_source(fragment);
    const std::string vertex_text = text_of(vertex_source, defines), fragment_text = text_of(fragment_source, defines);
    const Shader vertex_shader = compile(GL_VERTEX_SHADER, vertex, vertex_source, vertex_text);
    const Shader fragment_shader = compile(GL_FRAGMENT_SHADER, fragment, fragment_source, fragment_text);
    glAttachShader(name(), vertex_shader.get());
    glAttachShader(name(), fragment_shader.get());
    glLinkProgram(name());
    // Attached shaders would stay as long as the program, with all data of the compiler.
    glDetachShader(name(), vertex_shader.get());
    glDetachShader(name(), fragment_shader.get());
    GLint done = 0;
    glGetProgramiv(name(), GL_LINK_STATUS, &done);
    if (done == GL_FALSE)
        throw shader_error(vertex + " + " + fragment, read_log(name(), glGetProgramiv, glGetProgramInfoLog));

    edited_ = vertex_source.edited || fragment_source.edited;
    // GL knows only used uniforms, so declared ones are found in the text. One that a macro names stays unknown.
    for (const std::string* text : {&vertex_text, &fragment_text})
        for_each_declared(*text, [&](std::string&& uniform, const std::string& type) {
            uniforms_.try_emplace(std::move(uniform), Uniform{.location = -1, .type = type_of(type)});
        });
    find_used();
}

void Program::find_used() {
    GLint count = 0, longest = 0;
    glGetProgramiv(name(), GL_ACTIVE_UNIFORMS, &count);
    glGetProgramiv(name(), GL_ACTIVE_UNIFORM_MAX_LENGTH, &longest);
    std::string buffer(static_cast<std::size_t>(std::max(longest, 1)), '\0');
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(name(), i, longest, nullptr, &size, &type, buffer.data());
        const GLint location = glGetUniformLocation(name(), buffer.c_str());
        if (location < 0) continue;  // in a block
        const std::string_view uniform = buffer.c_str();
        uniforms_[std::string(uniform.substr(0, uniform.find("[0]")))] = {location, type};
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

GLint Program::location(const char* uniform, GLenum type) const {
    const auto found = uniforms_.find(std::string_view(uniform));
    const bool declared = found != uniforms_.end();
    if (declared && (found->second.type == 0 || takes(found->second.type, type))) return found->second.location;
    if (edited_) return -1;  // GL ignores it
    throw Error(Failure::runtime,
                Fault{.file = vertex_ + " + " + fragment_,
                      .place = uniform,
                      .reason = declared ? "a value of type " + std::string(word_of(type)) +
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
void Program::set(const char* uniform, std::span<const glm::vec4> values) const {
    glProgramUniform4fv(name(), location(uniform, GL_FLOAT_VEC4), static_cast<GLsizei>(values.size()),
                        glm::value_ptr(values.front()));
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
