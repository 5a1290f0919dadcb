#include "lapfx/authoring/round_view.h"

#include <gtest/gtest.h>

#include "media/opencv.h"
#include "support/endoscope.h"

namespace lapfx {
namespace {

/// Seen at this aspect, then stored in `stored`.
Image view(double aspect, glm::ivec2 stored, double radius = 0.45) {
    const glm::ivec2 shown(static_cast<int>(480 * aspect), 480);
    const Image seen =
        test::behind_round_view(test::tissue_picture(shown), {0.52 * shown.x, 0.49 * shown.y}, radius * shown.y);
    Image made{.width = stored.x, .height = stored.y, .pixels = {}, .name = ""};
    made.pixels.resize(4 * static_cast<std::size_t>(stored.x * stored.y));
    cv::Mat4b pixels = media::pixels_of(made);
    cv::resize(media::pixels_of(seen), pixels, pixels.size(), 0, 0, cv::INTER_AREA);
    return made;
}

TEST(AspectOfRoundView, IsThatWithWhichTheViewIsRound) {
    for (const double aspect : {5.0 / 4, 4.0 / 3, 16.0 / 9})
        for (const glm::ivec2 stored : {glm::ivec2(256, 256), {720, 576}, {640, 360}}) {
            const std::optional<double> found = aspect_of_round_view(view(aspect, stored));
            ASSERT_TRUE(found) << aspect << ' ' << stored.x;
            EXPECT_NEAR(*found / aspect, 1, 0.02) << stored.x;
        }
    const std::optional<double> cut = aspect_of_round_view(view(16.0 / 9, {256, 256}, 0.6));
    ASSERT_TRUE(cut) << "cut off above and below";
    EXPECT_NEAR(*cut, 16.0 / 9, 0.06);
}

TEST(AspectOfRoundView, IsNotKnownWithoutARoundView) {
    EXPECT_FALSE(aspect_of_round_view({}));
    EXPECT_FALSE(aspect_of_round_view(test::tissue_picture({320, 240})));
    Image bars = test::tissue_picture({320, 240});
    for (int y = 0; y < bars.height; ++y)
        for (int x = 0; x < bars.width; ++x)
            if (x < 40 || x >= 280) std::fill_n(bars.pixels.begin() + 4 * (y * bars.width + x), 3, std::uint8_t{0});
    EXPECT_FALSE(aspect_of_round_view(bars)) << "bars are straight";
}

}  // namespace
}  // namespace lapfx
