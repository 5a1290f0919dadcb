// A shader as a host compiles it, of text that it was given.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "gl/gl.h"

namespace lapfx::test {

/// The caller deletes it.
inline GLuint host_shader(GLenum stage, const std::string& text) {
    const GLuint shader = glCreateShader(stage);
    const char* const source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    char log[2048] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    EXPECT_EQ(compiled, GL_TRUE) << log;
    return shader;
}

}  // namespace lapfx::test
