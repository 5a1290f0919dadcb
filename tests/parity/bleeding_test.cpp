// shaders/bleeding.glsl with the uniform block that bleeding/bleed_gpu.h fills: the edge, and the colour along the depth.
#include "bleeding/bleed_gpu.h"
#include "gl/noise.h"
#include "gl/srgb.h"
#include "support/gpu_function.h"
#include "support/gpu_test.h"

namespace lapfx::bleeding {
namespace {

using BleedingParity = test::GpuTest;

constexpr std::uint32_t seed = 70'001;  // more than the 16 bits that the shader takes

/// Places in xyz and bleed values in w.
std::vector<glm::vec4> samples() {
    std::vector<glm::vec4> all;
    for (int i = 0; i < 2'000; ++i) {
        const auto t = static_cast<float>(i);
        all.emplace_back(0.37f * t - 300.0f, 11.0f * std::sin(t), 0.013f * t * t - 5.0f,
                         0.01f * static_cast<float>(i % 1'500) - 1.0f);
    }
    return all;
}

std::vector<BleedingParameters> parameters() {
    std::vector<BleedingParameters> all(3);
    all[1].threshold = 2.0;
    all[1].noise_strength = 0.4;
    all[1].noise_scale = 11.0;
    all[1].noise_octaves = 1;
    all[1].color_thin = {0.2, 0.9, 0.1};
    all[2].threshold = 1.0;
    all[2].noise_strength = 0.0;
    all[2].deep_at = 1.5;
    all[2].opacity = 0.3;
    return all;
}

/// The shader's documented depth: bleed - (threshold + noise); -1 where no blood can be.
float depth_of(const BleedingParameters& b, glm::vec4 sample) {
    const auto threshold = static_cast<float>(b.threshold), strength = static_cast<float>(b.noise_strength);
    if (sample.w <= threshold - strength) return -1.0f;
    const glm::vec3 p = glm::vec3(sample) / static_cast<float>(b.noise_scale);
    return sample.w - (threshold + strength * gl::fractal_noise(p, b.noise_octaves, seed & 0xffffu));
}

TEST_F(BleedingParity, DepthIsBleedLessThresholdAndNoise) {
    const test::GpuFunction gpu({"bleeding.glsl"}, "vec4(lapfx_blood(a.w, vec3(0.0), a.xyz).depth)");
    const BleedGpu block(1, seed);
    const auto inputs = samples();
    for (const BleedingParameters& b : parameters()) {
        block.set(b);
        block.bind();
        std::vector<glm::vec4> cpu;
        for (const glm::vec4& sample : inputs) cpu.emplace_back(depth_of(b, sample));
        test::expect_near(inputs, cpu, gpu(inputs), 0, 2e-4, "depth, threshold " + std::to_string(b.threshold));
    }
}

TEST_F(BleedingParity, ColourRunsFromThinToDeep) {
    const test::GpuFunction gpu({"bleeding.glsl"}, "lapfx_color(a)",
                                "vec4 lapfx_color(vec4 a) { LapfxBlood b = lapfx_blood(a.w, vec3(0.0), a.xyz); return "
                                "vec4(b.color, b.opacity); }");
    const BleedGpu block(1, seed);
    const auto inputs = samples();
    for (const BleedingParameters& b : parameters()) {
        block.set(b);
        block.bind();
        std::vector<glm::vec4> cpu;
        for (const glm::vec4& sample : inputs) {
            const float depth = std::max(depth_of(b, sample), 0.0f);
            const float pooled = 1.0f - std::exp2(-3.0f * depth / static_cast<float>(b.deep_at));
            const glm::vec3 color =
                glm::mix(gl::to_linear(glm::vec3(b.color_thin)), gl::to_linear(glm::vec3(b.color_deep)), pooled);
            cpu.emplace_back(color, static_cast<float>(b.opacity) * (1.0f - std::exp2(-2.0f * depth - 0.8f)));
        }
        const auto results = gpu(inputs);
        for (int i = 0; i < 4; ++i) test::expect_near(inputs, cpu, results, i, 3e-4, "colour and opacity");
    }
}

}  // namespace
}  // namespace lapfx::bleeding
