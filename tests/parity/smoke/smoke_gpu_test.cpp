// Smoke of SmokeGpu against the CPU references of keying and thickness, and off-screen against directly over the frame.
#include "smoke/smoke_gpu.h"

#include <chrono>

#include "gl/srgb.h"
#include "parity/smoke/smoke_fixture.h"
#include "smoke/plume.h"

namespace lapfx::smoke {
namespace {

constexpr glm::vec4 everywhere{0.0f, 0.0f, 1.0f, 1.0f};

struct Case {
    const char* name;
    media::Layout layout;
    bool alpha;
    KeyingParameters keying;
    ClipPolarity polarity = ClipPolarity::light;
    bool mirrored = false;
};

KeyingParameters by_luma() {
    return {.luma_low = 16.0, .luma_high = 220.0, .noise_strength = 0.0};
}
KeyingParameters by_chroma() {
    KeyingParameters k = by_luma();
    k.key_color = {0.2, 0.5, 0.3};
    k.chroma_low = 5.0;
    k.chroma_high = 60.0;
    k.spill = 0.6;
    return k;
}
KeyingParameters with_edges() {
    KeyingParameters k = by_luma();
    k.choke = 1.5;
    k.feather = 2.5;
    return k;
}

const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {"rgb", media::Layout::rgb, false, by_luma()},
        {"planar", media::Layout::planar, false, by_luma()},
        {"planar_dark_mirrored", media::Layout::planar, false, by_luma(), ClipPolarity::dark, true},
        {"rgb_by_chroma", media::Layout::rgb, false, by_chroma()},
        {"planar_by_chroma", media::Layout::planar, false, by_chroma()},
        {"rgb_alpha", media::Layout::rgb, true, by_luma()},
        {"planar_alpha_edges", media::Layout::planar, true, with_edges()},
        {"planar_edges", media::Layout::planar, false, with_edges()},
    };
    return all;
}

glm::vec3 own_tint(const HandMade& clip, glm::vec2 place, const Keying& key) {
    const glm::vec3 code = clip.rgb(place);
    const glm::vec3 own = tint(luma(code), despill(chroma(code), key));
    return clip.shading(place) * (key.chroma_high > 0.0f ? glm::mix(own, glm::vec3(1.0f), key.spill) : own);
}

class SmokeLayers : public SmokeGpuTest, public testing::WithParamInterface<std::tuple<Case, SmokeResolution, int>> {};

// The clip has the size of the frame, so that texels match pixels. Several layers are more than one call draws.
TEST_P(SmokeLayers, HazeIsThatOfTheReferences) {
    const auto& [tested, resolution, count] = GetParam();
    const Keying key = keying_of(tested.keying, tested.polarity);
    std::vector<HandMade> clips;
    for (int i = 0; i < count; ++i)
        clips.emplace_back(size, tested.layout, tested.alpha, static_cast<std::uint32_t>(i), bt601());
    const auto distance = [](glm::ivec2 pixel) { return pixel.x < 20 ? 60.0f : 130.0f; };
    set_depth(distance);
    SmokeGpu gpu(resolution, false);
    gpu.set_clip_pixels({{0, size.x * size.y}});
    const double unevenness = 0.7, density = 1.3 / count;
    const auto pixels = draw(gpu, [&] {
        for (const HandMade& clip : clips)
            gpu.filling(ClipRole::haze,
                        {.frame = clip.frame(),
                         .keying = &tested.keying,
                         .polarity = tested.polarity,
                         .mirrored = tested.mirrored,
                         .density = density},
                        unevenness);
    });
    double worst = 0.0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            SmokeSum sum;
            glm::vec3 over(background);
            const float reach = distance({x, y}) / focus;
            for (const HandMade& clip : clips) {
                const float column = static_cast<float>(x) + 0.5f;
                const glm::vec2 place(tested.mirrored ? static_cast<float>(size.x) - column : column,
                                      static_cast<float>(size.y - 1 - y) + 0.5f);
                const float shape =
                    edged([&](glm::vec2 p) { return clip.opacity(p, key); }, place,
                          static_cast<float>(tested.keying.choke), static_cast<float>(tested.keying.feather));
                const auto thickness = static_cast<float>(density * (1.0 + unevenness * (2.0 * shape - 1.0)));
                SmokeSum alone;
                alone.add(own_tint(clip, place, key), thickness);
                sum.add(own_tint(clip, place, key), thickness);
                over = lay_over(over, alone, gl::to_linear(glm::vec3(haze.color)), glm::vec3(haze.extinction), reach);
            }
            const glm::vec3 summed = lay_over(glm::vec3(background), sum, gl::to_linear(glm::vec3(haze.color)),
                                              glm::vec3(haze.extinction), reach);
            const glm::vec3 expected = resolution == SmokeResolution::screen ? over : summed;
            const glm::vec3 error = glm::abs(glm::vec3(pixels[index({x, y})]) - expected);
            worst = std::max(worst, static_cast<double>(std::max({error.r, error.g, error.b})));
        }
    // Texture filtering has 8 bits, the sum half floats. Chroma is filtered everywhere, and the tint of dark pixels
    // enlarges it.
    const bool filtered = tested.keying.choke > 0.0 || tested.layout == media::Layout::planar;
    EXPECT_LT(worst, filtered ? 7e-3 : 1.5e-3);
}

INSTANTIATE_TEST_SUITE_P(Haze, SmokeLayers,
                         testing::Combine(testing::ValuesIn(cases()),
                                          testing::Values(SmokeResolution::screen, SmokeResolution::clip),
                                          testing::Values(1, 7)),
                         [](const auto& tested) {
                             return std::string(std::get<0>(tested.param).name) +
                                    (std::get<1>(tested.param) == SmokeResolution::screen ? "_direct_" : "_summed_") +
                                    std::to_string(std::get<2>(tested.param));
                         });

using SmokeGpuHaze = SmokeGpuTest;

TEST_F(SmokeGpuHaze, EvenIsTheSameInAllWays) {
    set_depth([](glm::ivec2 p) { return 30.0f + 5.0f * static_cast<float>(p.x); });
    for (const SmokeResolution resolution : {SmokeResolution::screen, SmokeResolution::clip, SmokeResolution::half}) {
        SmokeGpu gpu(resolution, false);
        const auto pixels = draw(gpu, [&] { gpu.even_haze(0.8); });
        for (int x = 0; x < size.x; ++x) {
            SmokeSum sum;
            sum.add(glm::vec3(1.0f), 0.8f);
            const float reach = std::clamp((30.0f + 5.0f * static_cast<float>(x)) / focus, 0.4f, 1.8f);
            const glm::vec3 expected = lay_over(glm::vec3(background), sum, gl::to_linear(glm::vec3(haze.color)),
                                                glm::vec3(haze.extinction), reach);
            for (int c = 0; c < 3; ++c) ASSERT_NEAR(pixels[index({x, 9})][c], expected[c], 2e-4) << x;
        }
    }
}

// glBindTextureUnit with 0 unbinds all targets, and the state guard saves only two of them.
TEST_F(SmokeGpuHaze, WithoutNoiseTheUnitOfItsTilesIsLeftAlone) {
    set_depth([](glm::ivec2) { return 100.0f; });
    constexpr GLuint noise_unit = 12;
    GLuint cube = 0;
    glCreateTextures(GL_TEXTURE_CUBE_MAP, 1, &cube);
    glBindTextureUnit(noise_unit, cube);
    SmokeGpu gpu(SmokeResolution::clip, false);
    draw(gpu, [&] { gpu.even_haze(0.8); });
    GLint bound = 0;
    glActiveTexture(GL_TEXTURE0 + noise_unit);
    glGetIntegerv(GL_TEXTURE_BINDING_CUBE_MAP, &bound);
    glActiveTexture(GL_TEXTURE0);
    EXPECT_EQ(static_cast<GLuint>(bound), cube);
    glDeleteTextures(1, &cube);
}

TEST_F(SmokeGpuHaze, NoiseIsEachLayersOwnHoweverTheyAreDrawn) {
    set_depth([](glm::ivec2) { return 100.0f; });
    HandMade clip(size, media::Layout::planar, false, 4, bt601());
    std::fill(clip.planes[1].begin(), clip.planes[1].end(), std::uint8_t{128});  // grey: then both ways are the same
    clip.textures[1].upload(GL_RG, clip.planes[1].data(), 2);
    KeyingParameters keying = by_luma();
    keying.noise_strength = 1.0;
    const auto drawn = [&](SmokeResolution resolution, std::uint32_t last_seed) {
        SmokeGpu gpu(resolution, false);
        gpu.set_clip_pixels({{0, size.x * size.y}});
        return draw(gpu, [&] {
            for (const std::uint32_t seed : {5u, 60u, 700u, last_seed})
                gpu.filling(ClipRole::haze,
                            {.frame = clip.frame(), .keying = &keying, .density = 0.5, .time = 2.0, .seed = seed}, 1.0);
        });
    };
    const auto largest = [](const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
        float most = 0.0f;
        for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i].g - b[i].g));
        return most;
    };
    const auto direct = drawn(SmokeResolution::screen, 8000u), summed = drawn(SmokeResolution::clip, 8000u);
    EXPECT_LT(largest(direct, summed), 1e-3f);
    EXPECT_GT(largest(direct, drawn(SmokeResolution::screen, 9u)), 5e-3f);
    EXPECT_GT(largest(summed, drawn(SmokeResolution::clip, 9u)), 5e-3f);
}

TEST_F(SmokeGpuHaze, ATurnedClipShowsNoBorder) {
    // Its left half is clear and its right half thick: rotated by a right angle the halves are above each other.
    set_size({40, 40});
    set_depth([](glm::ivec2) { return 100.0f; });
    HandMade clip({40, 40}, media::Layout::rgb, false, 1, {});
    for (std::size_t i = 0; i < clip.planes[0].size(); ++i) clip.planes[0][i] = (i / 3) % 40 < 20 ? 0 : 255;
    clip.textures[0].upload(GL_RGB, clip.planes[0].data(), 2);
    const KeyingParameters keying = by_luma();
    SmokeGpu gpu(SmokeResolution::clip, false);
    gpu.set_clip_pixels({{0, 1600}});
    for (const float quarter : {1.0f, -1.0f}) {
        const auto pixels = draw(gpu, [&] {
            gpu.filling(ClipRole::haze,
                        {.frame = clip.frame(), .keying = &keying, .angle = quarter * glm::radians(90.0f)}, 1.0);
        });
        // Counter-clockwise, the right half is on top.
        const float above = pixels[index({5, 30})].r, below = pixels[index({33, 9})].r;
        const float clear = quarter > 0.0f ? below : above, thick = quarter > 0.0f ? above : below;
        EXPECT_NEAR(clear, background.r, 1e-3f) << quarter;
        EXPECT_LT(thick, background.r - 0.05f) << quarter;
    }
    // At any angle its mirror image continues beyond the clip: it is never clear and shows no line.
    std::fill(clip.planes[0].begin(), clip.planes[0].end(), std::uint8_t{180});
    clip.textures[0].upload(GL_RGB, clip.planes[0].data(), 2);
    const auto pixels =
        draw(gpu, [&] { gpu.filling(ClipRole::haze, {.frame = clip.frame(), .keying = &keying, .angle = 0.6f}, 1.0); });
    for (const glm::vec4& pixel : pixels) ASSERT_NEAR(pixel.r, pixels[0].r, 1e-4f);
}

class SmokeGpuPlume : public SmokeGpuTest {
  protected:
    std::array<glm::vec3, 4> corners(float distance) const {
        return plume_corners(
            {.anchor = {0.0f, 0.0f, -distance}, .extent = glm::vec2(1.2f, 1.0f) * distance, .source = {0.5f, 0.5f}});
    }
    /// Those of a plume 100 mm away that fills the view.
    std::array<glm::vec3, 4> filling() const {
        const float tall = 2.0f * 100.0f * std::tan(glm::radians(30.0f));
        const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
        return plume_corners(
            {.anchor = {0.0f, 0.0f, -100.0f}, .extent = glm::vec2(aspect, 1.0f) * tall, .source = {0.5f, 0.5f}});
    }
    /// A clip of one grey all over.
    static HandMade even_clip(glm::ivec2 of_size, std::uint8_t code) {
        HandMade clip(of_size, media::Layout::rgb, false, 1, {});
        std::fill(clip.planes[0].begin(), clip.planes[0].end(), code);
        clip.textures[0].upload(GL_RGB, clip.planes[0].data(), 2);
        return clip;
    }
};

// An instrument 60 mm away in front of tissue at 200 mm, with smoke at 100 mm. At a third of the resolution the
// instrument still hides the smoke, which reaches exactly to its edge.
TEST_F(SmokeGpuPlume, HasNoHaloAtTheEdgeOfAnInstrument) {
    set_size({180, 120});
    set_depth([](glm::ivec2 p) { return p.x + p.y / 3 < 100 ? 60.0f : 200.0f; });
    const HandMade clip = even_clip({60, 40}, 150);
    const KeyingParameters keying = by_luma();
    std::vector<glm::vec4> direct;
    for (const SmokeResolution resolution : {SmokeResolution::screen, SmokeResolution::clip, SmokeResolution::half}) {
        SmokeGpu gpu(resolution, false);
        gpu.set_clip_pixels({{60 * 40, 0}});
        const auto pixels = draw(gpu, [&] {
            gpu.standing(ClipRole::plume, {.frame = clip.frame(), .keying = &keying, .density = 1.5}, corners(100.0f),
                         everywhere);
        });
        if (resolution == SmokeResolution::screen) direct = pixels;
        for (int y = 30; y < 90; ++y)
            for (int x = 40; x < 140; ++x) {
                const glm::vec4 pixel = pixels[index({x, y})], wanted = direct[index({x, y})];
                if (x + y / 3 < 100) {
                    ASSERT_NEAR(pixel.g, background.g, 2e-3f) << x << ' ' << y << " on the instrument";
                }
                ASSERT_NEAR(pixel.g, wanted.g, 1e-2f) << x << ' ' << y;
            }
        EXPECT_GT(std::abs(pixels[index({130, 60})].g - background.g), 0.05f) << "there is smoke";
    }
}

TEST_F(SmokeGpuPlume, FadesOverItsSoftnessWhereItMeetsTheScene) {
    const HandMade clip = even_clip(size, 150);
    const KeyingParameters keying = by_luma();
    const float alpha = (150.0f - 16.0f) / (220.0f - 16.0f);
    for (const double wanted : {2.0, 6.0, 20.0})
        for (const double behind : {-5.0, 0.0, 1.0, 5.0, 30.0}) {
            softness = wanted;
            set_depth([&](glm::ivec2) { return static_cast<float>(100.0 + behind); });
            SmokeGpu gpu(SmokeResolution::clip, false);
            gpu.set_clip_pixels({{size.x * size.y, 0}});
            const auto pixels = draw(gpu, [&] {
                gpu.standing(ClipRole::plume, {.frame = clip.frame(), .keying = &keying, .density = 0.9},
                             corners(100.0f), everywhere);
            });
            const auto soft = static_cast<float>(std::clamp(behind / wanted, 0.0, 1.0));
            SmokeSum sum;
            sum.add(glm::vec3(1.0f), -std::log(1.0f - alpha * soft) * 0.9f);  // the lamp gives 1 at the focus distance
            const glm::vec3 expected = lay_over(glm::vec3(background), sum, gl::to_linear(glm::vec3(plume.color)),
                                                glm::vec3(plume.extinction), 1.0f);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(pixels[index(size / 2)][c], expected[c], 3e-3) << wanted << ' ' << behind;
        }
}

// Thick smoke all over the clip: its thickness, not its opacity, fades towards the quad's border.
TEST_F(SmokeGpuPlume, ThickSmokeFadesEvenlyTowardsTheBorder) {
    set_size({120, 100});
    set_depth([](glm::ivec2) { return 400.0f; });
    plume.color = glm::dvec3(0.0);  // then only its transmission is seen
    const HandMade clip = even_clip({120, 100}, 255);
    const KeyingParameters keying = by_luma();
    SmokeGpu gpu(SmokeResolution::clip, false);
    gpu.set_clip_pixels({{size.x * size.y, 0}});
    const double density = 0.5;
    const float whole = static_cast<float>(-std::log(0.002) * density);
    for (const float below : {0.5f, 0.08f, 0.0f}) {
        const auto pixels = draw(gpu, [&] {
            gpu.standing(ClipRole::plume,
                         {.frame = clip.frame(), .keying = &keying, .density = density, .below = below}, filling(),
                         everywhere);
        });
        const auto thickness = [&](glm::ivec2 pixel) {
            return -std::log(pixels[index(pixel)].r / background.r) / static_cast<float>(plume.extinction.r);
        };
        const float ramp = std::clamp(below, 0.002f, 0.15f);
        for (int i = 0; i < 30; ++i) {
            const float place = (static_cast<float>(i) + 0.5f) / 100.0f;
            EXPECT_NEAR(thickness({60, 99 - i}), whole * glm::smoothstep(0.0f, 0.15f, place), 0.03f) << i << " above";
            EXPECT_NEAR(thickness({60, i}), whole * glm::smoothstep(0.0f, ramp, place), 0.03f) << i << ", " << below;
        }
    }
}

// Opaque white smoke is the same, whether the clip brings its opacity or it is keyed from black.
TEST_F(SmokeGpuPlume, WhiteWithItsOwnOpacityIsAsBrightAsKeyedFromBlack) {
    set_depth([](glm::ivec2) { return 400.0f; });
    const KeyingParameters keying = by_luma();
    const auto middle_of = [&](bool alpha) {
        HandMade clip(size, media::Layout::rgb, alpha, 1, {});
        std::fill(clip.planes[0].begin(), clip.planes[0].end(), std::uint8_t{255});
        clip.textures[0].upload(GL_RGB, clip.planes[0].data(), 2);
        if (alpha) {
            std::fill(clip.planes[2].begin(), clip.planes[2].end(), std::uint8_t{255});
            clip.textures[2].upload(GL_RED, clip.planes[2].data(), 2);
        }
        SmokeGpu gpu(SmokeResolution::clip, false);
        gpu.set_clip_pixels({{size.x * size.y, 0}});
        return draw(gpu, [&] {
            gpu.standing(ClipRole::plume, {.frame = clip.frame(), .keying = &keying}, corners(100.0f), everywhere);
        })[index(size / 2)];
    };
    const glm::vec4 keyed = middle_of(false), own = middle_of(true);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(keyed[c], gl::to_linear(glm::vec3(plume.color))[c], 1e-2f) << "nothing shows through";
        EXPECT_NEAR(own[c], keyed[c], 1e-4f);
    }
}

// The clip's left and right border, where it widens to twice its width at the top: a trapezoid about its source.
TEST_F(SmokeGpuPlume, WidensUpwardsAndGetsThinner) {
    set_size({200, 100});
    set_depth([](glm::ivec2) { return 400.0f; });
    plume.color = glm::dvec3(0.0);  // then only its transmission is seen
    const HandMade clip = even_clip({200, 100}, 120);
    const KeyingParameters keying = by_luma();
    SmokeGpu gpu(SmokeResolution::clip, false);
    gpu.set_clip_pixels({{size.x * size.y, 0}});
    const auto pixels = draw(gpu, [&] {
        gpu.standing(ClipRole::plume,
                     {.frame = clip.frame(), .keying = &keying, .source = {0.5f, 1.0f}, .widening = 2.0f}, filling(),
                     everywhere);
    });
    const auto thickness = [&](int x, int y) {
        return -std::log(pixels[index({x, y})].r / background.r) / static_cast<float>(plume.extinction.r);
    };
    const float whole = -std::log(1.0f - (120.0f - 16.0f) / (220.0f - 16.0f));
    for (const int row : {20, 50, 80}) {
        const float width = 1.0f + (static_cast<float>(row) + 0.5f) / 100.0f;  // rows from the bottom
        EXPECT_NEAR(thickness(100, row), whole / width, 0.01f) << row;
        const int half = static_cast<int>(std::lround(50.0f * width));
        for (const int side : {-1, 1}) {
            EXPECT_NEAR(thickness(100 + side * (half + 3), row), 0.0f, 1e-3f) << row << " beyond its border";
            EXPECT_GT(thickness(100 + side * (half - 10), row), 0.2f * whole / width) << row << " inside";
        }
    }
}

TEST_F(SmokeGpuPlume, LeavesTheRestOfTheFrameAlone) {
    set_depth([](glm::ivec2) { return 300.0f; });
    HandMade clip(size, media::Layout::rgb, false, 1, {});
    const KeyingParameters keying = by_luma();
    const auto small =
        plume_corners({.anchor = {0.0f, 0.0f, -100.0f}, .extent = {30.0f, 20.0f}, .source = {0.5f, 0.5f}});
    const glm::vec4 bounds = view_bounds(small, view.projection);
    for (const SmokeResolution resolution : {SmokeResolution::screen, SmokeResolution::clip}) {
        SmokeGpu gpu(resolution, false);
        gpu.set_clip_pixels({{size.x * size.y / 4, 0}});
        const auto pixels = draw(gpu, [&] {
            gpu.standing(ClipRole::plume, {.frame = clip.frame(), .keying = &keying, .density = 3.0}, small, bounds);
        });
        int changed = 0;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const glm::vec2 at = glm::vec2(x, y) + 0.5f;
                const bool inside = at.x > bounds.x * 48.0f && at.x < bounds.z * 48.0f && at.y > bounds.y * 32.0f &&
                                    at.y < bounds.w * 32.0f;
                const bool same = pixels[index({x, y})] == background;
                if (!inside) {
                    ASSERT_TRUE(same) << x << ' ' << y;
                }
                changed += same ? 0 : 1;
            }
        EXPECT_GT(changed, 20);
    }
}

using SmokeGpuTimings = SmokeGpuTest;

TEST_F(SmokeGpuTimings, CountFramesWithSmokeAndOnlyIfAskedTo) {
    set_depth([](glm::ivec2) { return 100.0f; });
    GLint bits = 0;
    glGetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
    for (const bool on : {false, true}) {
        SmokeGpu gpu(SmokeResolution::clip, on);
        const auto begin = std::chrono::steady_clock::now();
        for (int i = 0; i < 40; ++i) {
            draw(gpu, [&] { gpu.even_haze(i % 2 == 0 ? 0.5 : 0.0); });
            glFinish();
        }
        if (!on || bits == 0) {
            EXPECT_EQ(gpu.timer().spans(), 0u);
            EXPECT_EQ(gpu.timer().seconds(), 0.0);
        } else {
            EXPECT_GE(gpu.timer().spans(), 12u);  // there are 20; the last ones are not known yet
            EXPECT_LE(gpu.timer().spans(), 20u);
            EXPECT_GT(gpu.timer().seconds(), 0.0);
            EXPECT_LE(std::chrono::duration<double>(gpu.timer().seconds()), std::chrono::steady_clock::now() - begin);
        }
    }
}

}  // namespace
}  // namespace lapfx::smoke
