#include "media/picture.h"

#include <gtest/gtest.h>

namespace lapfx::media {
namespace {

void expect_color(const ColorMatrix& color, glm::vec3 code, glm::vec3 expected) {
    const glm::vec3 rgb = color.matrix * (code - color.offset);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(rgb[i], expected[i], 1.0f) << i;
}

TEST(Picture, ColorMatricesAreThoseOfTheStandards) {
    const ColorMatrix sd = color_matrix(0.299f, 0.114f, false), hd = color_matrix(0.2126f, 0.0722f, false);
    for (const ColorMatrix& color : {sd, hd}) {
        expect_color(color, {16, 128, 128}, {0, 0, 0});
        expect_color(color, {235, 128, 128}, {255, 255, 255});
    }
    // Colour bars of 100 % (ITU-R BT.601: red 82 90 240, blue 41 240 110; BT.709: green 173 42 26).
    expect_color(sd, {81.5, 90.2, 240}, {255, 0, 0});
    expect_color(sd, {41, 240, 109.8}, {0, 0, 255});
    expect_color(hd, {172.6, 41.7, 26.3}, {0, 255, 0});
    const ColorMatrix jpeg = color_matrix(0.299f, 0.114f, true);
    expect_color(jpeg, {0, 128, 128}, {0, 0, 0});
    expect_color(jpeg, {76.2, 85, 255.5}, {255, 0, 0});
}

TEST(Picture, PlanesOfOddSizesAreRoundedUp) {
    PictureFormat format{.size = {33, 17}, .layout = Layout::planar, .alpha = true};
    EXPECT_EQ(format.chroma_size(), glm::ivec2(17, 9));
    EXPECT_EQ(format.bytes(), 33u * 17 + 2u * 17 * 9 + 33u * 17);
    format.layout = Layout::rgb;
    EXPECT_EQ(format.bytes(), 4u * 33 * 17);
}

}  // namespace
}  // namespace lapfx::media
