#include "match/compare/region.h"

#include <gtest/gtest.h>

#include "match/picture/colors.h"

namespace lapfx::match {
namespace {

Image filled(int width, int height, glm::ivec3 color) {
    Image image{.width = width, .height = height, .pixels = {}, .name = ""};
    for (int i = 0; i < width * height; ++i)
        for (const int c : {color.r, color.g, color.b, 255}) image.pixels.push_back(static_cast<std::uint8_t>(c));
    return image;
}

void paint(Image& image, int x0, int y0, int x1, int y1, glm::ivec3 color) {
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x)
            for (int c = 0; c < 3; ++c)
                image.pixels[4 * static_cast<std::size_t>(y * image.width + x) + static_cast<std::size_t>(c)] =
                    static_cast<std::uint8_t>(color[c]);
}

constexpr ComparedRegion whole{.x = 0, .y = 0, .width = 1, .height = 1};

TEST(Region, OfOneColourHasItsFigures) {
    const RegionFigures found = figures_of(filled(90, 60, {200, 120, 90}), {}, {});
    EXPECT_NEAR(found.color.r, 200 / 255.0, 1e-3);
    EXPECT_NEAR(found.color.g, 120 / 255.0, 1e-3);
    EXPECT_NEAR(found.contrast, 0, 1e-6);
    EXPECT_NEAR(found.veil, 90 / 255.0, 1e-6);
    EXPECT_EQ(found.red, 0);
}

TEST(Region, IsTheRectangleOfThePicture) {
    Image image = filled(100, 80, {50, 50, 50});
    paint(image, 20, 40, 60, 60, {150, 10, 10});
    const RegionFigures inside = figures_of(image, {.x = 0.2, .y = 0.5, .width = 0.4, .height = 0.25}, {});
    EXPECT_EQ(inside.red, 1.0);
    EXPECT_NEAR(inside.color.r, 150 / 255.0, 1e-3);
    const RegionFigures half = figures_of(image, {.x = 0.2, .y = 0.25, .width = 0.4, .height = 0.5}, {});
    EXPECT_NEAR(half.red, 0.5, 1e-9);
    // A third of the area beyond the picture is nothing.
    EXPECT_EQ(figures_of(image, {.x = 0.9, .y = 0.9, .width = 1, .height = 1}, {}).red, 0);
}

TEST(Region, TakesTheMeanInLinearLightAndTheContrastInLuma) {
    Image image = filled(100, 100, {0, 0, 0});
    paint(image, 0, 0, 50, 100, {255, 255, 255});
    const RegionFigures found = figures_of(image, whole, {});
    EXPECT_NEAR(found.color.g, static_cast<double>(code_of(0.5F)) / 255, 1e-4);
    EXPECT_NEAR(found.contrast, 0.5, 1e-9);
    EXPECT_NEAR(found.veil, 0.5, 0.02);
}

TEST(Region, VeilIsTheDarkestNearBy) {
    Image image = filled(400, 400, {180, 170, 175});
    for (int y = 2; y < 400; y += 8)
        for (int x = 2; x < 400; x += 8) paint(image, x, y, x + 2, y + 2, {20, 10, 12});
    EXPECT_NEAR(figures_of(image, whole, {}).veil, 10 / 255.0, 1e-6) << "every cell has a dark place";
    EXPECT_NEAR(figures_of(filled(400, 400, {180, 170, 175}), whole, {}).veil, 170 / 255.0, 1e-6);
}

TEST(Region, FollowsTheQualifierOfBlood) {
    const Image blood = filled(40, 40, {150, 20, 20}), liver = filled(40, 40, {120, 60, 60});
    EXPECT_EQ(figures_of(blood, whole, {}).red, 1.0);
    EXPECT_EQ(figures_of(liver, whole, {}).red, 0.0);
    EXPECT_EQ(figures_of(liver, whole, {.redness = 1.5}).red, 1.0);
    EXPECT_EQ(figures_of(blood, whole, {.brightness = 0.5}).red, 0.0);
}

TEST(Region, OfALargePictureIsSampledEvenly) {
    Image image = filled(1600, 1200, {60, 40, 40});
    paint(image, 0, 0, 1600, 300, {150, 10, 10});
    EXPECT_NEAR(figures_of(image, whole, {}).red, 0.25, 0.01);
}

TEST(Region, DistanceIsTheColourDifferenceOfTheCie) {
    const auto of = [](glm::ivec3 color) { return figures_of(filled(8, 8, color), whole, {}); };
    EXPECT_EQ(distance(of({10, 20, 30}), of({10, 20, 30})), 0);
    EXPECT_NEAR(distance(of({0, 0, 0}), of({255, 255, 255})), 100, 0.1) << "L* of black is 0, of white 100";
    // sRGB red is L* 53.24, a* 80.09, b* 67.20.
    EXPECT_NEAR(distance(of({255, 0, 0}), of({0, 0, 0})), std::sqrt(53.24 * 53.24 + 80.09 * 80.09 + 67.20 * 67.20),
                0.1);
}

TEST(Region, OfNoPictureIsNothing) {
    EXPECT_EQ(figures_of({}, whole, {}).veil, 0);
    EXPECT_EQ(figures_of(filled(1, 1, {9, 9, 9}), {.x = 0.99, .y = 0.99, .width = 0.01, .height = 0.01}, {}).veil,
              9 / 255.0);
}

}  // namespace
}  // namespace lapfx::match
