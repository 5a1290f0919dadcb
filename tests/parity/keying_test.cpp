// shaders/keying.glsl and its CPU reference effects/smoke/keying_pixel.h agree to 1e-5 of alpha and 1e-3 of a code
// value.
#include <cmath>
#include <limits>

#include "smoke/keying_pixel.h"
#include "support/gpu_function.h"
#include "support/gpu_test.h"

namespace lapfx::smoke {
namespace {

const char* key_of_parameters =
    "LapfxKeying key() { return LapfxKeying(u_0.x, u_0.y, u_1.xy, u_0.z, u_0.w, u_1.z, u_1.w); }";

std::array<glm::vec4, 3> parameters_of(const Keying& k, glm::vec4 more = {}) {
    return {glm::vec4(k.luma_low, k.luma_high, k.chroma_low, k.chroma_high), glm::vec4(k.key_chroma, k.spill, k.dark),
            more};
}

/// Every channel from -64 to 320, beyond the range of clips on both sides.
std::vector<glm::vec4> ramps() {
    std::vector<glm::vec4> codes;
    for (int r = -64; r <= 320; r += 24)
        for (int g = -64; g <= 320; g += 24)
            for (int b = -64; b <= 320; b += 24) codes.emplace_back(r, g, b, 0);
    for (int grey = -64; grey <= 320; ++grey) codes.emplace_back(grey, grey, grey, 0);
    return codes;
}

std::vector<glm::vec4> not_finite() {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    std::vector<glm::vec4> codes;
    for (const float r : {nan, infinity, -infinity, 90.0f})
        for (const float g : {nan, infinity, -infinity, 120.0f})
            for (const float b : {nan, infinity, -infinity, 200.0f}) codes.emplace_back(r, g, b, 0.0f);
    return codes;
}

/// All polarities, chroma on and off, green, blue and grey backgrounds.
std::vector<Keying> keyings() {
    std::vector<Keying> keys;
    for (const float dark : {0.0f, 1.0f})
        for (const glm::vec3 background : {glm::vec3(0, 0, 0), glm::vec3(0, 255, 0), glm::vec3(20, 40, 230)})
            for (const auto& [low, high] : {std::pair{0.0f, 0.0f}, {0.0f, 60.0f}, {25.0f, 140.0f}, {50.0f, 50.0f}})
                for (const auto& [from, to] : {std::pair{16.0f, 200.0f}, {0.0f, 255.0f}, {90.0f, 91.0f}})
                    keys.push_back({.luma_low = from,
                                    .luma_high = to,
                                    .key_chroma = chroma(background),
                                    .chroma_low = low,
                                    .chroma_high = high,
                                    .spill = dark > 0.0f ? 1.0f : 0.4f,
                                    .dark = dark});
    return keys;
}

using KeyingParity = test::GpuTest;

TEST_F(KeyingParity, Alpha) {
    const test::GpuFunction gpu({"keying.glsl"}, "vec4(lapfx_key_alpha(a.rgb, key()))", key_of_parameters);
    for (const auto& inputs : {ramps(), not_finite()})
        for (const Keying& key : keyings()) {  // one program, changed parameters
            std::vector<glm::vec4> cpu;
            for (const glm::vec4& code : inputs) cpu.emplace_back(key_alpha(glm::vec3(code), key));
            const bool step = key.luma_high - key.luma_low < 2.0f || key.chroma_low == key.chroma_high;
            test::expect_near(inputs, cpu, gpu(inputs, parameters_of(key)), 0, step ? 2e-2 : 1e-5,
                              "alpha, luma " + std::to_string(key.luma_low) + " chroma " +
                                  std::to_string(key.chroma_high) + " dark " + std::to_string(key.dark));
        }
}

TEST_F(KeyingParity, AlphaOfAnythingIsWithinZeroAndOne) {
    const test::GpuFunction gpu({"keying.glsl"}, "vec4(lapfx_vary_alpha(lapfx_key_alpha(a.rgb, key()), u_2.x, u_2.y))",
                                key_of_parameters);
    for (const Keying& key : keyings())
        for (const glm::vec4& value : gpu(not_finite(), parameters_of(key, {0.7f, 0.9f, 0.0f, 0.0f})))
            ASSERT_TRUE(value.x >= 0.0f && value.x <= 1.0f) << value.x;
}

TEST_F(KeyingParity, LumaAndChroma) {
    const test::GpuFunction gpu({"keying.glsl"}, "vec4(lapfx_luma(a.rgb), lapfx_chroma(a.rgb), 0.0)");
    const auto inputs = ramps();
    std::vector<glm::vec4> cpu;
    for (const glm::vec4& code : inputs) cpu.emplace_back(luma(glm::vec3(code)), chroma(glm::vec3(code)), 0.0f);
    const auto results = gpu(inputs);
    for (int i = 0; i < 3; ++i) test::expect_near(inputs, cpu, results, i, 1e-3, "component " + std::to_string(i));
}

TEST_F(KeyingParity, Despill) {
    const test::GpuFunction gpu({"keying.glsl"}, "vec4(lapfx_despill(lapfx_chroma(a.rgb), key()), 0.0, 0.0)",
                                key_of_parameters);
    const auto inputs = ramps();
    for (const Keying& key : keyings()) {
        std::vector<glm::vec4> cpu;
        for (const glm::vec4& code : inputs) cpu.emplace_back(despill(chroma(glm::vec3(code)), key), 0.0f, 0.0f);
        const auto results = gpu(inputs, parameters_of(key));
        for (int i = 0; i < 2; ++i) test::expect_near(inputs, cpu, results, i, 1e-3, "despilled chroma");
    }
}

TEST_F(KeyingParity, VaryAlpha) {
    const test::GpuFunction gpu({"keying.glsl"}, "vec4(lapfx_vary_alpha(a.x, a.y, a.z))");
    std::vector<glm::vec4> inputs, cpu;
    for (float alpha = 0.0f; alpha <= 1.0f; alpha += 0.0625f)
        for (float noise = -1.25f; noise <= 1.25f; noise += 0.125f)
            for (float strength = 0.0f; strength <= 1.0f; strength += 0.25f)
                inputs.emplace_back(alpha, noise, strength, 0.0f);
    for (const glm::vec4& i : inputs) cpu.emplace_back(vary_alpha(i.x, i.y, i.z));
    test::expect_near(inputs, cpu, gpu(inputs), 0, 1e-6, "varied alpha");
}

TEST_F(KeyingParity, Tint) {
    const test::GpuFunction gpu({"keying.glsl"}, "vec4(lapfx_tint(a.x, a.yz), 0.0)");
    std::vector<glm::vec4> inputs, cpu;
    for (float y = -20.0f; y <= 280.0f; y += 15.0f)
        for (float cb = -130.0f; cb <= 130.0f; cb += 20.0f)
            for (float cr = -130.0f; cr <= 130.0f; cr += 20.0f) inputs.emplace_back(y, cb, cr, 0.0f);
    for (const glm::vec4& i : inputs) cpu.emplace_back(tint(i.x, glm::vec2(i.y, i.z)), 0.0f);
    const auto results = gpu(inputs);
    for (int i = 0; i < 3; ++i) test::expect_near(inputs, cpu, results, i, 1e-5, "tint");
}

TEST_F(KeyingParity, Shade) {
    const test::GpuFunction gpu({"keying.glsl"}, "vec4(lapfx_shade(a.x, a.y))");
    std::vector<glm::vec4> inputs, cpu;
    for (float y = -20.0f; y <= 280.0f; y += 7.5f)
        for (float alpha = -0.25f; alpha <= 1.25f; alpha += 0.0625f) inputs.emplace_back(y, alpha, 0.0f, 0.0f);
    for (const glm::vec4& i : inputs) cpu.emplace_back(shade(i.x, i.y));
    test::expect_near(inputs, cpu, gpu(inputs), 0, 1e-5, "shade");
}

/// Crop, fade and masks: where smoke remains, and that it is 0 elsewhere.
TEST_F(KeyingParity, Window) {
    const test::GpuFunction gpu({"window.glsl"},
                                "vec4(lapfx_inside(a.xy, u_0, u_1) * lapfx_outside(a.xy, u_2, a.z), 0.0, 0.0, 0.0)");
    SmokeClip clip;
    clip.crop = {.left = 0.1, .top = 0.2, .right = 0.05, .bottom = 0.15};
    clip.source_x = 0.3, clip.source_y = 0.8;
    clip.masks = {{.x = 0.5, .y = 0.45, .width = 0.2, .height = 0.1}};
    for (const double fade : {0.0, 0.1, 0.5}) {
        clip.edge_fade = fade;
        const Window window = window_of(clip, {64, 48});
        std::vector<glm::vec4> inputs, cpu;
        for (float x = -4.25f; x < 70.0f; x += 0.5f)
            for (float y = -4.25f; y < 52.0f; y += 0.5f) inputs.emplace_back(x, y, window.softness, 0.0f);
        for (const glm::vec4& i : inputs) cpu.emplace_back(window_at(window, glm::vec2(i)));
        test::expect_near(inputs, cpu, gpu(inputs, {glm::vec4(window.low, window.high), window.fades, window.mask[0]}),
                          0, 1e-4, "fade " + std::to_string(fade));
    }
}

/// Opacity of a made-up clip, as a function of the place: steep and round.
float blobs(glm::vec2 p) {
    return unit(0.5f + 0.7f * std::sin(0.31f * p.x) * std::cos(0.23f * p.y));
}

TEST_F(KeyingParity, ChokeAndFeather) {
    const test::GpuFunction gpu(
        {"keying.glsl", "edges.glsl"}, "vec4(lapfx_edged(a.xy, u_0.x, u_0.y))",
        "float lapfx_opacity_at(vec2 p) { return lapfx_unit(0.5 + 0.7 * sin(0.31 * p.x) * cos(0.23 * p.y)); }");
    std::vector<glm::vec4> inputs;
    for (float x = 0.0f; x < 40.0f; x += 0.75f)
        for (float y = 0.0f; y < 40.0f; y += 0.75f) inputs.emplace_back(x, y, 0.0f, 0.0f);
    for (const auto& [choke, feather] :
         {std::pair{0.0f, 0.0f}, {3.0f, 0.0f}, {0.0f, 2.5f}, {1.5f, 6.0f}, {16.0f, 16.0f}}) {
        std::vector<glm::vec4> cpu;
        for (const glm::vec4& i : inputs) cpu.emplace_back(edged(blobs, glm::vec2(i), choke, feather));
        test::expect_near(inputs, cpu, gpu(inputs, {glm::vec4(choke, feather, 0.0f, 0.0f)}), 0, 1e-5,
                          "choke " + std::to_string(choke) + " feather " + std::to_string(feather));
    }
}

}  // namespace
}  // namespace lapfx::smoke
