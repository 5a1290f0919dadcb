// Blood whose lobes are as small as a pixel, because they are or because it is far away: its light is that of many
// small mirrors, and no pixel flashes by itself (shaders/bleeding.glsl, lapfx_blood_film).
#include "parity/render/scene_fixture.h"

namespace lapfx {
namespace {

class GlitterTest : public test::SceneTest {
  protected:
    static constexpr glm::ivec2 frame{200, 200};

    GlitterTest() {
        preset.smoke.clips.clear();
        preset.bleeding.max_extent = 30.0;
        scene.events.resize(1);
        scene.events[0].position = scene.events[0].to = {0.0, 0.0, 0.0};
    }

    /// Pixels that are far brighter than all four beside them, in the middle, where there is no bare tissue.
    int sparks() const {
        const Image image = preview().image(9.0, frame);
        const auto luma = [&](int x, int y) {
            const auto i = 4 * static_cast<std::size_t>(y * frame.x + x);
            return (image.pixels[i] + image.pixels[i + 1] + image.pixels[i + 2]) / 3;
        };
        int found = 0;
        for (int y = frame.y / 3; y < 2 * frame.y / 3; ++y)
            for (int x = frame.x / 3; x < 2 * frame.x / 3; ++x)
                found += luma(x, y) > 60 + std::max({luma(x - 1, y), luma(x + 1, y), luma(x, y - 1), luma(x, y + 1)});
        return found;
    }
};

TEST_F(GlitterTest, BloodOfSmallLobesHasNoSparks) {
    for (const double scale : {0.3, 0.6, 1.2}) {
        preset.bleeding.noise_scale = scale;
        EXPECT_LE(sparks(), 10) << scale << ": 140 to 260 without the filter";
    }
}

/// Mean colour in the middle of a picture of that many pixels, codes.
glm::dvec3 mean_color(const Image& image) {
    glm::dvec3 sum(0.0);
    int count = 0;
    for (int y = image.height / 3; y < 2 * image.height / 3; ++y)
        for (int x = image.width / 3; x < 2 * image.width / 3; ++x, ++count)
            for (int c = 0; c < 3; ++c)
                sum[c] += image.pixels[4 * static_cast<std::size_t>(y * image.width + x) + static_cast<std::size_t>(c)];
    return sum / double(count);
}

// What a small picture shows is the mean of what a large one shows: neither a veil nor too dark.
TEST_F(GlitterTest, ASmallPictureHasTheColoursOfALargeOne) {
    for (const double scale : {0.3, 0.6, 1.2, 3.0, 6.0}) {
        preset.bleeding.noise_scale = scale;
        const glm::dvec3 small = mean_color(preview().image(9.0, frame)),
                         large = mean_color(preview().image(9.0, 6 * frame));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(small[c], large[c], 8.0) << scale << ", channel " << c;
    }
}

TEST_F(GlitterTest, BloodStillReflectsTheLamp) {
    preset.bleeding.noise_scale = 6.0;
    const Image image = preview().image(9.0, frame);
    int white = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) white += image.pixels[i + 2] > 200;
    EXPECT_GT(white, 20);
}

}  // namespace
}  // namespace lapfx
