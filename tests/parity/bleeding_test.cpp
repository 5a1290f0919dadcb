// shaders/bleeding.glsl with the uniform block that bleeding/bleed_gpu.h fills: the edge, and the colour along the
// depth.
#include "bleeding/bleed_gpu.h"
#include "gl/srgb.h"
#include "support/edge_noise.h"
#include "support/gpu_function.h"
#include "support/gpu_test.h"

namespace lapfx::bleeding {
namespace {

using BleedingParity = test::GpuTest;

constexpr std::uint32_t seed = 70'001;  // more than the 16 bits that the shader uses

/// Places in xyz and bleed values in w.
std::vector<glm::vec4> samples() {
    std::vector<glm::vec4> all;
    for (int i = 0; i < 2'000; ++i) {
        const auto t = static_cast<float>(i);
        all.emplace_back(0.37f * t - 300.0f, 11.0f * std::sin(t), 0.0002f * t * t - 5.0f,
                         0.01f * static_cast<float>(i % 1'500) - 1.0f);
    }
    return all;
}

std::vector<BleedingParameters> parameters() {
    std::vector<BleedingParameters> all(4);
    all[1].threshold = 2.0;
    all[1].noise_strength = 0.4;
    all[1].noise_scale = 11.0;
    all[1].noise_octaves = 1;
    all[1].rivulets = 0.0;
    all[1].color_thin = {0.2, 0.9, 0.1};
    all[2].threshold = 1.0;
    all[2].noise_strength = 0.0;
    all[2].deep_at = 1.5;
    all[2].opacity = 0.3;
    all[3].rivulets = 1.0;
    all[3].noise_octaves = 5;
    all[3].clot_darkening = 0.4;
    return all;
}

const glm::dvec3 down = glm::normalize(glm::dvec3(0.3, -1.0, 0.2));

/// Level, slanted and vertical tissue in turns, as a GLSL expression of u_0.x and in C++.
const glm::vec3 normals[] = {glm::vec3(-down), glm::normalize(glm::vec3(0.2f, 0.4f, 1.0f)),
                             glm::normalize(glm::cross(glm::vec3(down), glm::vec3(1.0f, 0.0f, 0.0f)))};

/// The shader's documented depth: bleed - (threshold + noise); noise is -1 where no blood can be.
float depth_of(const BleedingParameters& b, glm::vec4 sample, glm::vec3 normal) {
    const auto threshold = static_cast<float>(b.threshold), strength = static_cast<float>(b.noise_strength);
    if (sample.w <= threshold - strength) return sample.w - (threshold - strength);
    return sample.w - (threshold + strength * test::edge_noise(b, down, seed, glm::vec3(sample), normal));
}

TEST_F(BleedingParity, DepthIsBleedLessThresholdAndNoise) {
    const test::GpuFunction gpu({"bleeding.glsl"},
                                "vec4(lapfx_blood(vec2(a.w, 0.0), vec3(0.0), a.xyz, u_0.xyz).depth)");
    const BleedGpu block(1);
    const auto inputs = samples();
    for (const BleedingParameters& b : parameters())
        for (const glm::vec3 normal : normals) {
            block.set(b, down, seed);
            block.bind();
            std::vector<glm::vec4> cpu;
            for (const glm::vec4& sample : inputs) cpu.emplace_back(depth_of(b, sample, normal));
            test::expect_near(inputs, cpu, gpu(inputs, {glm::vec4(normal, 0.0f)}), 0, 3e-4,
                              "depth, threshold " + std::to_string(b.threshold));
        }
}

TEST_F(BleedingParity, RivuletsLeaveLevelTissueAloneAndStretchUprightTissue) {
    // Mean change of the edge over 1 mm, along and across: round where level; on a wall several times as long as wide.
    BleedingParameters b;
    b.rivulets = 1.0;
    b.noise_octaves = 3;
    const auto roughness = [&](glm::vec3 normal, glm::vec3 direction) {
        double sum = 0.0;
        for (const glm::vec4& sample : samples()) {
            const glm::vec3 p(sample);
            sum += std::abs(test::edge_noise(b, down, seed, p + direction, normal) -
                            test::edge_noise(b, down, seed, p, normal));
        }
        return sum;
    };
    const glm::vec3 g(down), level = glm::normalize(glm::cross(g, glm::vec3(1.0f, 0.0f, 0.0f)));
    const glm::vec3 across = glm::cross(g, level);
    EXPECT_NEAR(roughness(-g, level) / roughness(-g, across), 1.0, 0.1);
    EXPECT_GT(roughness(level, across) / roughness(level, g), 2.5);
}

TEST_F(BleedingParity, ColourRunsFromThinToDeepAndFilmHidesByBeerAndLambert) {
    const char* const call =
        "LapfxBlood blood(vec4 a) { return lapfx_blood(vec2(a.w, 0.0), vec3(0.0), a.xyz, u_0.xyz); }";
    const test::GpuFunction color({"bleeding.glsl"}, "vec4(blood(a).color, blood(a).gloss)", call);
    const test::GpuFunction opacity({"bleeding.glsl"}, "vec4(blood(a).opacity, blood(a).clot)", call);
    const BleedGpu block(1);
    const auto inputs = samples();
    for (const BleedingParameters& b : parameters()) {
        block.set(b, down, seed);
        block.bind();
        std::vector<glm::vec4> colors, opacities;
        for (const glm::vec4& sample : inputs) {
            const float depth = std::max(depth_of(b, sample, normals[1]), 0.0f) / static_cast<float>(b.deep_at);
            const glm::vec3 body = glm::mix(gl::to_linear(glm::vec3(b.color_thin)),
                                            gl::to_linear(glm::vec3(b.color_deep)), 1.0f - std::exp2(-3.0f * depth));
            colors.emplace_back(body, b.gloss);
            const glm::vec3 most = 1.0f - static_cast<float>(1.0 - b.opacity) * glm::vec3(1.0f, 0.15f, 0.15f);
            opacities.emplace_back(most * (1.0f - glm::exp2(-glm::vec3(2.6f, 8.0f, 7.5f) * (depth + 0.06f))), 0.0f);
        }
        const auto parameter = std::array{glm::vec4(normals[1], 0.0f), glm::vec4(0.0f), glm::vec4(0.0f)};
        const auto gpu_colors = color(inputs, parameter), gpu_opacities = opacity(inputs, parameter);
        for (int i = 0; i < 4; ++i) {
            test::expect_near(inputs, colors, gpu_colors, i, 3e-4, "colour and gloss");
            test::expect_near(inputs, opacities, gpu_opacities, i, 3e-4, "opacity per channel and clot");
        }
    }
}

// Alpha squared and the lobes' variance add up, to a bound; what a picture clips of sparks is left out. By hand with
// the tilt of white, 0.25: alpha 0.01 keeps 0.0784 of its light, 0.2 keeps 0.96, from 0.25 on all.
TEST_F(BleedingParity, TheFilmIsRougherAndWeakerWhereAPixelHoldsManyLobes) {
    const test::GpuFunction film({"bleeding.glsl"}, "vec4(film(a).roughness, film(a).wetness, 0.0, 0.0)",
                                 "LapfxFilm film(vec4 a) { return lapfx_blood_film(a.x, a.y, a.z); }");
    const std::vector<glm::vec4> inputs{
        {0.1f, 1.0f, 0.0f, 0.0f}, {0.1f, 0.5f, 0.0399f, 0.0f}, {0.1f, 1.0f, 9.0f, 0.0f}, {0.6f, 0.8f, 0.0f, 0.0f}};
    const std::vector<glm::vec4> expected{{0.1f, 1.0f, 0.0f, 0.0f},
                                          {std::sqrt(0.2f), 0.5f * 0.0784f / 0.96f, 0.0f, 0.0f},
                                          {std::pow(0.2001f, 0.25f), 0.0784f, 0.0f, 0.0f},
                                          {0.6f, 0.8f, 0.0f, 0.0f}};
    const auto found = film(inputs, {});
    for (int i = 0; i < 2; ++i) test::expect_near(inputs, expected, found, i, 1e-3, "roughness and strength");
}

/// Mean over the samples that have blood.
glm::dvec4 mean_of(const std::vector<glm::vec4>& values, const std::vector<glm::vec4>& inputs,
                   const BleedingParameters& b) {
    glm::dvec4 sum(0.0);
    int count = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (depth_of(b, inputs[i], normals[1]) > 0.0f) sum += glm::dvec4(values[i]), ++count;
    EXPECT_GT(count, 500);
    return sum / static_cast<double>(count);
}

TEST_F(BleedingParity, ClotsAreBrownBlackAndDull) {
    const test::GpuFunction gpu(
        {"bleeding.glsl"}, "vec4(blood(a).color.rg, blood(a).gloss, blood(a).opacity.r)",
        "LapfxBlood blood(vec4 a) { return lapfx_blood(vec2(a.w, u_1.x), vec3(0.0), a.xyz, u_0.xyz); }");
    BleedingParameters b;
    const BleedGpu block(1);
    const auto inputs = samples();
    const auto mean = [&](double clot) {
        block.set(b, down, seed);
        block.bind();
        return mean_of(gpu(inputs, {glm::vec4(normals[1], 0.0f), glm::vec4(glm::dvec4(clot)), glm::vec4(0.0f)}), inputs,
                       b);
    };
    b.clot_darkening = 1.0;
    const glm::dvec4 fresh = mean(0.0), half = mean(0.5), clotted = mean(1.0);
    EXPECT_LT(clotted.x, 0.6 * fresh.x) << "red";
    EXPECT_GT(clotted.y / clotted.x, 1.5 * fresh.y / fresh.x) << "towards brown";
    EXPECT_NEAR(clotted.z, 0.15 * b.gloss, 0.03) << "gloss";
    EXPECT_GT(clotted.w, fresh.w) << "opacity";
    EXPECT_TRUE(half.x < fresh.x && half.x > clotted.x);
    b.clot_darkening = 0.0;
    EXPECT_NEAR(mean(1.0).x, fresh.x, 1e-6) << "no darkening, the same red";
    EXPECT_NEAR(mean(1.0).z, clotted.z, 1e-6) << "but as dull";
}

}  // namespace
}  // namespace lapfx::bleeding
