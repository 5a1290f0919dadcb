// The tiles of noise_tiles_gpu.h have the noise of smoke/noise.h: at texels to 8 bits, filtered between them to a few
// hundredths, and each tile its own noise.
#include "smoke/noise_tiles_gpu.h"

#include "smoke/noise.h"
#include "support/gpu_test.h"

namespace lapfx::smoke {
namespace {

constexpr double stored = 1.1 / 255.0;  // half a step of 2 / 255, and rounding

/// Noise at a place of the clip (0..1) from the parameters: lobes, and a drift down and, more slowly, into the depth.
float expected(const KeyingParameters& k, float aspect, double time, int seed, glm::dvec2 uv) {
    const double drift = k.noise_drift * time / k.noise_scale;
    float sum = 0.0f;
    for (int octave = 0; octave < 2; ++octave) {
        const double frequency = octave == 0 ? 1.0 : 2.0;
        const glm::dvec3 p =
            frequency * glm::dvec3(uv.x * aspect / k.noise_scale, uv.y / k.noise_scale + drift, 0.35 * drift);
        const glm::dvec3 whole = glm::floor(p);
        const glm::uvec3 cell(static_cast<std::uint32_t>(static_cast<std::int64_t>(whole.x)),
                              static_cast<std::uint32_t>(static_cast<std::int64_t>(whole.y)),
                              static_cast<std::uint32_t>(static_cast<std::int64_t>(whole.z)));
        sum += smoke::perlin_from(cell, glm::vec3(p - whole), static_cast<std::uint32_t>(seed + octave)) /
               static_cast<float>(frequency);
    }
    return sum / 1.5f;
}

class NoiseTilesTest : public test::GpuTest {
  protected:
    void draw(NoiseTiles& tiles) {
        const gl::VertexArray no_attributes;
        glBindVertexArray(no_attributes.name());
        glDisable(GL_BLEND);
        glDisable(GL_SCISSOR_TEST);
        tiles.draw();
        glGetTextureLevelParameteriv(tiles.texture(), 0, GL_TEXTURE_WIDTH, &size.x);
        glGetTextureLevelParameteriv(tiles.texture(), 0, GL_TEXTURE_HEIGHT, &size.y);
        texels.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
        glGetTextureImage(tiles.texture(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(4 * texels.size()),
                          texels.data());
        glBindVertexArray(0);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
    }
    glm::vec4 texel(glm::ivec2 at) const {
        at = glm::clamp(at, glm::ivec2(0), size - 1);
        return glm::vec4(texels[static_cast<std::size_t>(at.y * size.x + at.x)]) / 255.0f * 2.0f - 1.0f;
    }
    /// The layers' shaders sample it so: bilinear.
    glm::vec4 sample(const NoiseTiles& tiles, std::size_t tile, glm::dvec2 uv) const {
        const glm::vec4 place = tiles.place(tile);
        const glm::dvec2 at = (glm::dvec2(place) + uv * glm::dvec2(place.z, place.w)) * glm::dvec2(size) - 0.5;
        const glm::ivec2 first(glm::floor(at));
        const glm::vec2 f(at - glm::floor(at));
        return glm::mix(glm::mix(texel(first), texel(first + glm::ivec2(1, 0)), f.x),
                        glm::mix(texel(first + glm::ivec2(0, 1)), texel(first + 1), f.x), f.y);
    }

    glm::ivec2 size{0};
    std::vector<glm::u8vec4> texels;
};

TEST_F(NoiseTilesTest, HoldTheNoiseOfTheirLayersAtAnyTime) {
    NoiseTiles tiles;
    KeyingParameters k;
    for (const double scale : {0.05, 0.25, 2.0})
        for (const double time : {0.0, 3.7, -12.0, 3.0e7}) {  // a year is 3e7 s
            k.noise_scale = scale;
            tiles.clear();
            const glm::ivec4 seeds(3, 65535, 77, 12);
            const NoiseTiles::Grid grid = NoiseTiles::grid(k, 1.5f, time);
            const std::size_t tile = tiles.add(grid, seeds, 4);
            draw(tiles);
            double worst = 0.0, between = 0.0;
            for (int i = 0; i < 40; ++i)
                for (int c = 0; c < 4; ++c) {
                    const glm::ivec2 at((i * 7) % grid.texels.x, (i * 11) % grid.texels.y);
                    const glm::dvec2 uv = glm::dvec2(at) / glm::dvec2(grid.texels - 1);
                    worst = std::max(worst, std::abs(static_cast<double>(sample(tiles, tile, uv)[c]) -
                                                     expected(k, 1.5f, time, seeds[c], uv)));
                    const glm::dvec2 off = glm::min(uv + 0.37 / glm::dvec2(grid.texels), glm::dvec2(1.0));
                    between = std::max(between, std::abs(static_cast<double>(sample(tiles, tile, off)[c]) -
                                                         expected(k, 1.5f, time, seeds[c], off)));
                }
            // A lattice of 1e8 lobes leaves the fraction of a double 1e-8, and texel positions are floats.
            EXPECT_LT(worst, stored + 2e-3) << "scale " << scale << " time " << time;
            EXPECT_LT(between, 0.08) << "scale " << scale << " time " << time;
        }
}

TEST_F(NoiseTilesTest, DoNotReachIntoEachOther) {
    NoiseTiles tiles;
    KeyingParameters coarse, fine;
    coarse.noise_scale = 1.0;
    fine.noise_scale = 0.1;
    const std::size_t a = tiles.add(NoiseTiles::grid(coarse, 1.5f, 1.0), glm::ivec4(5), 1);
    const std::size_t b = tiles.add(NoiseTiles::grid(fine, 0.8f, 2.0), glm::ivec4(6), 1);
    const std::size_t c = tiles.add(NoiseTiles::grid(coarse, 1.5f, 1.0), glm::ivec4(7), 1);
    draw(tiles);
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(1, 1)}) {
        EXPECT_NEAR(sample(tiles, a, corner).x, expected(coarse, 1.5f, 1.0, 5, corner), stored + 1e-3);
        EXPECT_NEAR(sample(tiles, b, corner).x, expected(fine, 0.8f, 2.0, 6, corner), stored + 1e-3);
        EXPECT_NEAR(sample(tiles, c, corner).x, expected(coarse, 1.5f, 1.0, 7, corner), stored + 1e-3);
    }
}

TEST_F(NoiseTilesTest, AreSharedByThoseThatAskForTheSame) {
    NoiseTiles tiles;
    const NoiseTiles::Grid now = NoiseTiles::grid({}, 1.5f, 1.0), later = NoiseTiles::grid({}, 1.5f, 2.0);
    const std::size_t a = tiles.add(now, glm::ivec4(5, 0, 0, 0), 1);
    EXPECT_EQ(tiles.add(now, glm::ivec4(5, 0, 0, 0), 1), a);
    EXPECT_NE(tiles.add(now, glm::ivec4(6, 0, 0, 0), 1), a);
    EXPECT_NE(tiles.add(later, glm::ivec4(5, 0, 0, 0), 1), a);
    EXPECT_EQ(tiles.add(now, glm::ivec4(5, 0, 0, 0), 1), a);
    const std::size_t both = tiles.add(now, glm::ivec4(5, 5, 9, 9), 4);
    EXPECT_NE(both, a);
    draw(tiles);
    const glm::dvec2 middle(24.0 / (now.texels.x - 1), 16.0 / (now.texels.y - 1));
    for (int c = 0; c < 4; ++c)
        EXPECT_NEAR(sample(tiles, both, middle)[c], expected({}, 1.5f, 1.0, c < 2 ? 5 : 9, middle), stored + 2e-3) << c;
}

TEST_F(NoiseTilesTest, AnyNumberFitsByGettingCoarser) {
    NoiseTiles tiles;
    KeyingParameters k;
    k.noise_scale = 0.01;
    for (int i = 0; i < 100; ++i) tiles.add(NoiseTiles::grid(k, 4.0f, 0.0), glm::ivec4(i), 1);
    draw(tiles);
    EXPECT_LE(size.x, 4096);
    EXPECT_LE(size.y, 4096);
    for (const std::size_t i : {std::size_t{0}, std::size_t{99}}) {
        const glm::vec4 place = tiles.place(i);
        EXPECT_GE(place.x, 0.0f);
        EXPECT_LE(place.x + place.z, 1.0f);
        EXPECT_LE(place.y + place.w, 1.0f);
        EXPECT_NEAR(sample(tiles, i, {0.0, 0.0}).x, expected(k, 4.0f, 0.0, static_cast<int>(i), {0.0, 0.0}),
                    stored + 1e-3);
    }
}

}  // namespace
}  // namespace lapfx::smoke
