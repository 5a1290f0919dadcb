#include "app/reference/picture_scopes.h"

#include <gtest/gtest.h>

#include <numeric>

namespace lapfx::app {
namespace {

/// `left` on its left half, `right` on the other.
Image halves(int width, int height, glm::u8vec3 left, glm::u8vec3 right) {
    Image image{.width = width, .height = height, .pixels = {}, .name = ""};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::u8vec3 c = 2 * x < width ? left : right;
            image.pixels.insert(image.pixels.end(), {c.r, c.g, c.b, 255});
        }
    return image;
}

TEST(PictureScopes, CountsEachChannel) {
    ui::ImageStore images;
    PictureScopes scopes(images);
    EXPECT_FALSE(scopes.counted());
    scopes.count(halves(64, 32, {200, 20, 10}, {0, 0, 0}));
    EXPECT_TRUE(scopes.counted());
    EXPECT_EQ(scopes.levels(Channel::red)[200], 64U * 32 / 2);
    EXPECT_EQ(scopes.levels(Channel::red)[0], 64U * 32 / 2);
    EXPECT_EQ(scopes.levels(Channel::blue)[10], 64U * 32 / 2);
    EXPECT_EQ(scopes.mean(Channel::red), 100);
    EXPECT_EQ(scopes.mean(Channel::green), 10);
    const int luma = static_cast<int>(std::lround(ui::luma_chroma({200, 20, 10}).x));
    EXPECT_EQ(scopes.levels(Channel::luma)[static_cast<std::size_t>(luma)], 64U * 32 / 2);
}

TEST(PictureScopes, OfALargePictureItCountsAGrid) {
    ui::ImageStore images;
    PictureScopes scopes(images);
    scopes.count(halves(1600, 1000, {255, 255, 255}, {0, 0, 0}));
    const auto levels = scopes.levels(Channel::luma);
    const std::uint32_t counted = std::accumulate(levels.begin(), levels.end(), 0U);
    EXPECT_EQ(counted, 1600U / 3 * 334 + 334) << "every third pixel of every third row";
    EXPECT_NEAR(scopes.mean(Channel::luma), 127.5, 0.5);
}

TEST(PictureScopes, AnotherPictureTakesThePlaceOfTheFormer) {
    ui::ImageStore images;
    PictureScopes scopes(images);
    scopes.count(halves(16, 16, {255, 255, 255}, {255, 255, 255}));
    const ui::ImageHandle waves = scopes.waves();
    const std::uint32_t before = images.find(waves)->serial;
    scopes.count(halves(16, 16, {9, 9, 9}, {9, 9, 9}));
    EXPECT_EQ(scopes.levels(Channel::luma)[255], 0U);
    EXPECT_EQ(scopes.levels(Channel::luma)[9], 256U);
    EXPECT_EQ(scopes.waves(), waves);
    EXPECT_NE(images.find(waves)->serial, before);
    scopes.count({});
    EXPECT_EQ(scopes.levels(Channel::luma)[9], 256U) << "nothing to count leaves what there was";
}

}  // namespace
}  // namespace lapfx::app
