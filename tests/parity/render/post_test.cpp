// shaders/post.glsl beside the same on the CPU, in a shader of a host's own.
#include <glm/gtc/type_ptr.hpp>
#include <random>

#include "gl/objects.h"
#include "gl/read_back.h"
#include "lapfx/camera.h"
#include "parity/render/host_shader.h"
#include "parity/render/scene_fixture.h"
#include "support/post_cpu.h"

namespace lapfx {
namespace {

constexpr double tolerance = 0.75;  // code values: half a one is rounding

constexpr const char* fullscreen = R"(#version 450 core
layout(location = 0) out vec2 v_uv;
void main() {
    vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    v_uv = corner;
    gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
}
)";
constexpr const char* own = R"(
layout(location = 0) in vec2 v_uv;
layout(binding = 0) uniform sampler2D my_frame;
out vec4 o_color;
void main() { o_color = vec4(lapfx_post(my_frame, v_uv), 1.0); }
)";

/// A host that finishes its frames itself.
class PostTest : public test::GpuTest {
  protected:
    void SetUp() override {
        test::GpuTest::SetUp();
        program_ = glCreateProgram();
        for (const GLuint shader :
             {test::host_shader(GL_VERTEX_SHADER, fullscreen),
              test::host_shader(GL_FRAGMENT_SHADER, "#version 450 core\n" + post_shader() + own)}) {
            glAttachShader(program_, shader);
            glDeleteShader(shader);
        }
        glLinkProgram(program_);
    }
    void TearDown() override {
        glDeleteProgram(program_);
        test::GpuTest::TearDown();
    }

    std::vector<std::uint8_t> drawn(const test::Light& light, const CameraResponse& response) const {
        const gl::Texture frame({.size = light.size, .format = GL_RGB32F, .filter = GL_NEAREST}),
            target({.size = light.size, .format = GL_RGBA8});
        glTextureSubImage2D(frame.name(), 0, 0, 0, light.size.x, light.size.y, GL_RGB, GL_FLOAT, light.pixels.data());
        const gl::Framebuffer framebuffer(target, nullptr);
        const gl::VertexArray none;
        const auto values = post_values(response, light.size);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
        glViewport(0, 0, light.size.x, light.size.y);
        for (const GLenum off : {GL_BLEND, GL_DEPTH_TEST, GL_FRAMEBUFFER_SRGB, GL_SCISSOR_TEST}) glDisable(off);
        glBindTextureUnit(0, frame.name());
        glBindVertexArray(none.name());
        glUseProgram(program_);
        glUniform4fv(glGetUniformLocation(program_, "lapfx_camera"), 4, glm::value_ptr(values[0]));
        glDrawArrays(GL_TRIANGLES, 0, 3);
        std::vector<std::uint8_t> rgba(4 * light.pixels.size());
        glReadPixels(0, 0, light.size.x, light.size.y, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
        return rgba;
    }

    /// Of darks, lights and edges; the lightest is beyond white.
    static test::Light some_light(glm::ivec2 size) {
        test::Light light{.size = size, .pixels = {}};
        std::mt19937 random(5);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const auto some = [&random] { return static_cast<float>(random() % 1000) / 1000.0f; };
                const float step = x > size.x / 2 ? 1.0f : 0.05f,
                            level = 4.0f * static_cast<float>(y) / static_cast<float>(size.y);
                light.pixels.emplace_back(step * level * level * (0.7f + 0.3f * some()), step * level * some(),
                                          step * 0.2f * level);
            }
        return light;
    }

    static double largest_error(const test::Light& light, const CameraResponse& response,
                                const std::vector<std::uint8_t>& rgba) {
        const test::PostCpu wanted(light, response);
        double most = 0.0;
        for (int y = 0; y < light.size.y; ++y)
            for (int x = 0; x < light.size.x; ++x)
                for (int c = 0; c < 3; ++c)
                    most = std::max(most, std::abs(wanted.at({x, y})[c] -
                                                   rgba[static_cast<std::size_t>(4 * (y * light.size.x + x) + c)]));
        return most;
    }

  private:
    GLuint program_ = 0;
};

const CameraResponse as_film{.exposure = 0.7,
                             .white_balance = {1.03, 0.96, 1.08},
                             .sharpening = 0.9,
                             .saturation = 0.85,
                             .lens_falloff = 0.15,
                             .curve = ResponseCurve::film};

TEST_F(PostTest, IsWhatTheCpuSays) {
    for (const glm::ivec2 size : {glm::ivec2(160, 128), {60, 90}, {7, 5}}) {
        const test::Light light = some_light(size);
        for (const CameraResponse& response :
             {CameraResponse{}, CameraResponse{.exposure = 2.0, .vignette = 0.0}, as_film,
              CameraResponse{.vignette = 0.5, .sharpening = 2.0, .curve = ResponseCurve::film, .toe = 0.0},
              CameraResponse{.saturation = 1.5, .curve = ResponseCurve::film, .knee = 0.3, .white = 1.1}})
            EXPECT_LE(largest_error(light, response, drawn(light, response)), tolerance) << size.x;
    }
}

TEST_F(PostTest, LightIsNeverBeyondAPicture) {
    test::Light light{.size = {4, 1}, .pixels = {{0, 0, 0}, {1e4, 1e4, 1e4}, {0, 60000, 0}, {1e-7, 0, 0}}};
    CameraResponse response = as_film;
    response.vignette = response.sharpening = 0.0;
    const std::vector<std::uint8_t> rgba = drawn(light, response);
    EXPECT_EQ(std::vector(rgba.begin(), rgba.begin() + 8),
              (std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255, 255, 255}));
    EXPECT_EQ(rgba[12], 0);
}

TEST_F(PostTest, SharpeningLeavesWhatIsEvenAndBoundsEdges) {
    test::Light light{.size = {64, 512}, .pixels = std::vector<glm::vec3>(64 * 512, glm::vec3(0.2f))};
    for (int y = 256; y < 512; ++y) std::fill_n(light.pixels.begin() + 64 * y, 64, glm::vec3(0.4f));
    const CameraResponse flat{.vignette = 0.0}, sharp{.vignette = 0.0, .sharpening = 2.0};
    const std::vector<std::uint8_t> before = drawn(light, flat), after = drawn(light, sharp);
    const auto at = [](const std::vector<std::uint8_t>& rgba, int y) {
        return static_cast<int>(rgba[static_cast<std::size_t>(4 * (64 * y + 32))]);
    };
    EXPECT_EQ(at(after, 100), at(before, 100));
    EXPECT_EQ(at(after, 400), at(before, 400));
    EXPECT_GT(at(after, 257), at(before, 257) + 5) << "the lighter side of the edge";
    EXPECT_LT(at(after, 254), at(before, 254) - 5) << "the darker one";
    EXPECT_EQ(at(after, 260), at(before, 260)) << "1.5 px, and not farther";
}

}  // namespace
}  // namespace lapfx
