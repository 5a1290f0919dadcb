// shaders/color.glsl has the sRGB transfer of gl/srgb.h, and its two directions undo each other.
#include "gl/srgb.h"
#include "support/gpu_function.h"
#include "support/gpu_test.h"

namespace lapfx {
namespace {

using ColorParity = test::GpuTest;

std::vector<glm::vec4> ramp() {
    std::vector<glm::vec4> values;
    for (int i = 0; i <= 1020; ++i) {
        const float value = static_cast<float>(i) / 1020.0f;
        values.emplace_back(value, 1.0f - value, value * value, 0.0f);
    }
    return values;
}

void expect_all_near(const std::vector<glm::vec4>& cpu, const std::vector<glm::vec4>& gpu, double tolerance,
                     const char* what) {
    for (int i = 0; i < 3; ++i) test::expect_near(ramp(), cpu, gpu, i, tolerance, what);
}

TEST_F(ColorParity, ToLinear) {
    std::vector<glm::vec4> cpu;
    for (const glm::vec4& v : ramp()) cpu.emplace_back(gl::to_linear(glm::vec3(v)), 0.0f);
    expect_all_near(cpu, test::GpuFunction({"color.glsl"}, "vec4(lapfx_to_linear(a.rgb), 0.0)")(ramp()), 2e-5,
                    "to linear");
}

TEST_F(ColorParity, ToSrgb) {
    std::vector<glm::vec4> cpu;
    for (const glm::vec4& v : ramp()) cpu.emplace_back(glm::convertLinearToSRGB(glm::vec3(v)), 0.0f);
    expect_all_near(cpu, test::GpuFunction({"color.glsl"}, "vec4(lapfx_to_srgb(a.rgb), 0.0)")(ramp()), 2e-5, "to sRGB");
}

TEST_F(ColorParity, ThereAndBack) {
    const test::GpuFunction gpu({"color.glsl"}, "vec4(lapfx_to_srgb(lapfx_to_linear(a.rgb)), 0.0)");
    expect_all_near(ramp(), gpu(ramp()), 2e-5, "there and back");
}

TEST_F(ColorParity, KnownValues) {
    const std::vector<glm::vec4> inputs{{0.0f, 0.5f, 1.0f, 0.0f}, {0.04045f, 0.2f, 0.8f, 0.0f}};
    const auto linear = test::GpuFunction({"color.glsl"}, "vec4(lapfx_to_linear(a.rgb), 0.0)")(inputs);
    EXPECT_EQ(linear[0].x, 0.0f);
    EXPECT_NEAR(linear[0].y, 0.214041f, 2e-5f);
    EXPECT_NEAR(linear[0].z, 1.0f, 2e-5f);
    EXPECT_NEAR(linear[1].x, 0.0031308f, 1e-6f);
    EXPECT_NEAR(linear[1].y, 0.033105f, 2e-5f);
    EXPECT_NEAR(linear[1].z, 0.603827f, 2e-5f);
}

}  // namespace
}  // namespace lapfx
