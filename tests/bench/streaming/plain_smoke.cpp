#include "bench/streaming/plain_smoke.h"

#include <glad/gl.h>

#include <chrono>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "lapfx/error.h"

namespace lapfx::bench {

namespace {

constexpr int clip_width = 720, clip_height = 480, noise_size = 256;

constexpr const char* rectangle = R"(#version 450 core
layout(location = 0) out vec2 v_uv;
void main() {
    v_uv = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(2.0 * v_uv - 1.0, 0.0, 1.0);
})";

constexpr const char* clip = R"(#version 450 core
layout(location = 0) in vec2 v_uv;
layout(binding = 0) uniform sampler2D u_frame;
layout(binding = 1) uniform sampler2D u_noise;
layout(location = 0) uniform vec2 u_drift;
layout(location = 0) out vec4 o_color;
void main() {
    vec3 color = texture(u_frame, vec2(v_uv.x, 1.0 - v_uv.y)).rgb;
    float alpha = clamp((dot(color, vec3(0.299, 0.587, 0.114)) - 0.1) / 0.7, 0.0, 1.0);
    float noise = 2.0 * texture(u_noise, v_uv + u_drift).r - 1.0;
    o_color = vec4(color, clamp(alpha * (1.0 + 0.5 * noise), 0.0, 1.0));
})";

constexpr const char* lay = R"(#version 450 core
layout(location = 0) in vec2 v_uv;
layout(binding = 0) uniform sampler2D u_smoke;  // premultiplied
layout(location = 0) out vec4 o_color;
void main() { o_color = texture(u_smoke, v_uv); }
)";

[[noreturn]] void fail(const std::string& what) {
    throw Error(Failure::runtime, Fault{"", "", what});
}

unsigned compiled(GLenum kind, const char* text) {
    const unsigned shader = glCreateShader(kind);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    int done = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done == 0) fail("the bench's plain smoke shader does not compile");
    return shader;
}

unsigned program_of(const char* fragment) {
    const unsigned program = glCreateProgram();
    const unsigned shaders[] = {compiled(GL_VERTEX_SHADER, rectangle), compiled(GL_FRAGMENT_SHADER, fragment)};
    for (const unsigned shader : shaders) glAttachShader(program, shader);
    glLinkProgram(program);
    for (const unsigned shader : shaders) glDeleteShader(shader);
    return program;
}

unsigned texture_of(const cv::Mat& picture, GLenum inner, GLenum outer) {
    unsigned name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    glTextureStorage2D(name, 1, inner, picture.cols, picture.rows);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureSubImage2D(name, 0, 0, 0, picture.cols, picture.rows, outer, GL_UNSIGNED_BYTE, picture.data);
    return name;
}

/// Smooth values around the middle, which repeat.
cv::Mat noise() {
    cv::RNG random(1);
    cv::Mat coarse(16, 16, CV_8U), smooth;
    random.fill(coarse, cv::RNG::UNIFORM, 0, 256);
    cv::resize(coarse, smooth, {noise_size, noise_size}, 0, 0, cv::INTER_CUBIC);
    return smooth;
}

double ms_of(const auto& drawing) {
    finish_drawing();
    const auto start = std::chrono::steady_clock::now();
    drawing();
    finish_drawing();
    return 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

PlainSmoke::PlainSmoke(const BenchClips& clips, int streams) {
    for (int i = 0; i < streams; ++i) {
        cv::VideoCapture reader(clips.path(i).string());
        cv::Mat frame;
        if (!reader.read(frame)) fail(clips.path(i).string() + " cannot be read");
        frames_.push_back(texture_of(frame, GL_RGB8, GL_BGR));
    }
    noise_ = texture_of(noise(), GL_R8, GL_RED);
    glCreateTextures(GL_TEXTURE_2D, 1, &smoke_);
    glTextureStorage2D(smoke_, 1, GL_RGBA16F, clip_width, clip_height);
    glTextureParameteri(smoke_, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glCreateFramebuffers(1, &smoke_framebuffer_);
    glNamedFramebufferTexture(smoke_framebuffer_, GL_COLOR_ATTACHMENT0, smoke_, 0);
    glCreateVertexArrays(1, &vertices_);
    clip_program_ = program_of(clip);
    lay_program_ = program_of(lay);
}

PlainSmoke::~PlainSmoke() {
    glDeleteTextures(static_cast<int>(frames_.size()), frames_.data());
    for (const unsigned texture : {noise_, smoke_}) glDeleteTextures(1, &texture);
    glDeleteFramebuffers(1, &smoke_framebuffer_);
    glDeleteVertexArrays(1, &vertices_);
    for (const unsigned program : {clip_program_, lay_program_}) glDeleteProgram(program);
}

void PlainSmoke::draw_clips() const {
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(clip_program_);
    glBindVertexArray(vertices_);
    glBindTextureUnit(1, noise_);
    for (std::size_t i = 0; i < frames_.size(); ++i) {
        glBindTextureUnit(0, frames_[i]);
        glProgramUniform2f(clip_program_, 0, 0.07F * static_cast<float>(i), 0.11F * static_cast<float>(i));
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
}

double PlainSmoke::over_frame_ms(const HostFrame& host) const {
    host.bind(1.0);
    const double took = ms_of([&] { draw_clips(); });
    glDisable(GL_BLEND);
    return took;
}

double PlainSmoke::at_clip_resolution_ms(const HostFrame& host) const {
    const double took = ms_of([&] {
        glBindFramebuffer(GL_FRAMEBUFFER, smoke_framebuffer_);
        glViewport(0, 0, clip_width, clip_height);
        constexpr float nothing[4] = {};
        glClearNamedFramebufferfv(smoke_framebuffer_, GL_COLOR, 0, nothing);
        draw_clips();
        host.bind(1.0);
        glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        glUseProgram(lay_program_);
        glBindTextureUnit(0, smoke_);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    });
    glDisable(GL_BLEND);
    return took;
}

}  // namespace lapfx::bench
