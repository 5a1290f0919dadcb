// shaders/noise.glsl and its CPU mirror effects/smoke/noise.h give the same noise, to 1e-5.
#include "smoke/noise.h"

#include <random>

#include "support/gpu_function.h"
#include "support/gpu_test.h"

namespace lapfx {
namespace {

constexpr double tolerance = 1e-5;

using NoiseParity = test::GpuTest;

/// Half of them near the origin, on both sides of 0, half up to `extent` away.
std::vector<glm::vec4> points(std::size_t count, double extent) {
    std::mt19937 random(11);
    std::vector<glm::vec4> result;
    for (std::size_t i = 0; i < count; ++i) {
        const double range = i % 2 == 0 ? 8.0 : extent;
        const auto place = [&] {
            return static_cast<float>((static_cast<double>(random()) / 4294967296.0 * 2.0 - 1.0) * range);
        };
        const float x = place(), y = place(), z = place();
        result.emplace_back(x, y, z, 0.0f);
    }
    for (float x = -3.0f; x <= 3.0f; x += 0.5f) result.emplace_back(x, -x, 0.0f, 0.0f);  // on the lattice itself
    return result;
}

template <class Function>
std::vector<glm::vec4> on_cpu(const std::vector<glm::vec4>& inputs, Function function) {
    std::vector<glm::vec4> result;
    for (const glm::vec4& p : inputs) result.emplace_back(function(glm::vec3(p)), 0.0f, 0.0f, 0.0f);
    return result;
}

TEST_F(NoiseParity, Perlin) {
    const test::GpuFunction gpu({"noise.glsl"}, "lapfx_perlin(a.xyz, uint(u_0.x))");
    const auto inputs = points(10'000, 50'000.0);
    for (const std::uint32_t seed : {0u, 1u, 77u, 65535u})
        test::expect_near(inputs, on_cpu(inputs, [&](glm::vec3 p) { return smoke::perlin(p, seed); }),
                          gpu(inputs, {glm::vec4(static_cast<float>(seed))}), 0, tolerance,
                          "perlin, seed " + std::to_string(seed));
}

TEST_F(NoiseParity, Fractal) {
    const test::GpuFunction gpu({"noise.glsl"}, "lapfx_fractal_noise(a.xyz, int(u_0.y), uint(u_0.x))");
    const auto inputs = points(10'000, 2'000.0);
    for (const std::uint32_t seed : {0u, 5u, 40000u})
        for (const int octaves : {0, 1, 3, 6})
            test::expect_near(inputs,
                              on_cpu(inputs, [&](glm::vec3 p) { return smoke::fractal_noise(p, octaves, seed); }),
                              gpu(inputs, {glm::vec4(seed, octaves, 0, 0)}), 0, tolerance,
                              std::to_string(octaves) + " octaves, seed " + std::to_string(seed));
}

TEST_F(NoiseParity, TheAnalyticGradientIsThatOfTheValue) {
    const test::GpuFunction gpu({"noise.glsl"}, "lapfx_fractal_noise(a.xyz, int(u_0.y), uint(u_0.x)).yzwx");
    const auto inputs = points(4'000, 20.0);
    // Central differences in double of the CPU's noise would need it in double; a step of 1/256 is exact in float here.
    constexpr float step = 1.0f / 256.0f;
    for (const int octaves : {1, 3}) {
        const auto gradients = gpu(inputs, {glm::vec4(3, octaves, 0, 0)});
        std::vector<glm::vec4> differences;
        for (const glm::vec4& p : inputs) {
            glm::vec4 d(0.0f);
            for (int axis = 0; axis < 3; ++axis) {
                glm::vec3 to(p), from(p);
                to[axis] += step;
                from[axis] -= step;
                d[axis] = (smoke::fractal_noise(to, octaves, 3) - smoke::fractal_noise(from, octaves, 3)) /
                          (to[axis] - from[axis]);
            }
            differences.push_back(d);
        }
        // The error of the difference quotient is step^2 / 6 times the third derivative, about 60 * frequency^3.
        for (int axis = 0; axis < 3; ++axis)
            test::expect_near(inputs, differences, gradients, axis, octaves == 1 ? 2e-3 : 1e-2,
                              std::to_string(octaves) + " octaves, axis " + std::to_string(axis));
    }
}

TEST(Noise, HasMeanZeroAndStaysWithinOne) {
    std::mt19937 random(2);
    double sum = 0.0, squares = 0.0;
    float most = 0.0f;
    constexpr int count = 200'000;
    for (int i = 0; i < count; ++i) {
        const auto place = [&] {
            return static_cast<float>(static_cast<double>(random()) / 4294967296.0 * 400.0 - 200.0);
        };
        const float x = place(), y = place(), z = place();
        const float value = smoke::perlin({x, y, z}, 9);
        sum += value;
        squares += value * value;
        most = std::max(most, std::abs(value));
    }
    EXPECT_NEAR(sum / count, 0.0, 0.005);
    EXPECT_NEAR(std::sqrt(squares / count), 0.27, 0.05);
    EXPECT_LE(most, 1.04f);
    EXPECT_GT(most, 0.7f);
}

TEST(Noise, SeedsAreDifferentAndLatticePointsZero) {
    int same = 0;
    for (int i = 0; i < 100; ++i) {
        const glm::vec3 p(0.37f + static_cast<float>(i), 0.41f, -0.73f * static_cast<float>(i));
        same += smoke::perlin(p, 1) == smoke::perlin(p, 2) ? 1 : 0;
        EXPECT_EQ(smoke::perlin(glm::floor(p), 1), 0.0f);
    }
    EXPECT_LT(same, 10);
}

}  // namespace
}  // namespace lapfx
