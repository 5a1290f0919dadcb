#include "ui/gl/renderer.h"

#include "ui/gl/renderer_fixture.h"

namespace lapfx::ui::test {
namespace {

// --- pictures ---

TEST_F(RendererTest, AnImageIsShownWithItsFirstRowOnTop) {
    const ImageHandle image = images.add({2, 2}, red_green_blue_white);
    const Picture picture = drawn([&](Painter& p) { p.image({10, 10, 40, 40}, image, true); });
    EXPECT_EQ(bounds_of(picture), Rect(10, 10, 40, 40));
    EXPECT_EQ(at(picture, 29, 29), red);
    EXPECT_EQ(at(picture, 30, 29), green);
    EXPECT_EQ(at(picture, 29, 30), blue);
    EXPECT_EQ(at(picture, 30, 30), white);
}

TEST_F(RendererTest, AnImageIsFilteredUnlessAskedOtherwise) {
    const ImageHandle image = images.add({2, 1}, std::vector<std::uint8_t>{0, 0, 0, 255, 200, 100, 50, 255});
    const Picture picture = drawn([&](Painter& p) { p.image({0, 0, 80, 10}, image); });
    EXPECT_EQ(at(picture, 5, 5), black);
    EXPECT_NEAR(at(picture, 40, 5).r, 200 * (40.5 - 20) / 40, 1.5);
    EXPECT_NEAR(at(picture, 50, 5).g, 100 * (50.5 - 20) / 40, 1.5);
    EXPECT_EQ(at(picture, 75, 5), Color(200, 100, 50, 255));
}

TEST_F(RendererTest, AnImageHasStraightAlphaAndATint) {
    const ImageHandle image = images.add({1, 1}, std::vector<std::uint8_t>{200, 100, 50, 128});
    const Picture picture = drawn([&](Painter& p) {
        p.fill({0, 0, 20, 10}, white);
        p.image({0, 0, 10, 10}, image);
        p.image({10, 0, 10, 10}, image, false, {255, 0, 0, 128});
    });
    EXPECT_NEAR(at(picture, 5, 5).r, 227, 1);
    EXPECT_NEAR(at(picture, 5, 5).g, 177, 1);
    EXPECT_NEAR(at(picture, 15, 5).r, 241, 1);
    EXPECT_NEAR(at(picture, 15, 5).g, 191, 1);
}

TEST_F(RendererTest, ATextureOfTheHostIsShownAsOpenGlDrewIt) {
    const Canvas host({4, 4});
    const std::uint8_t lowest_row[16] = {255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255};
    host.fill(green);
    glTextureSubImage2D(host.texture(), 0, 0, 0, 4, 1, GL_RGBA, GL_UNSIGNED_BYTE, lowest_row);
    for (const bool nearest : {true, false}) {
        const Picture picture = drawn([&](Painter& p) { p.image({0, 0, 40, 40}, host.texture(), nearest); });
        EXPECT_EQ(at(picture, 20, 1), green);
        EXPECT_EQ(at(picture, 20, 38), red);
    }
}

TEST_F(RendererTest, OnlyAChangedImageIsSentAgain) {
    const ImageHandle image = images.add({2, 2}, red_green_blue_white),
                      hidden = images.add({1, 1}, std::vector<std::uint8_t>(4));
    const auto draw = [&](Painter& p) { p.image({0, 0, 40, 40}, image, true); };
    drawn(draw);
    drawn(draw);
    const std::size_t steady = renderer->last().bytes;
    images.update(hidden, {1, 1}, std::vector<std::uint8_t>(4));
    drawn(draw);
    EXPECT_EQ(renderer->last().bytes, steady);
    images.update(image, {1, 1}, std::vector<std::uint8_t>{0, 0, 255, 255});
    const Picture picture = drawn(draw);
    EXPECT_EQ(renderer->last().bytes, steady + 4);
    EXPECT_EQ(at(picture, 2, 2), blue);
}

TEST_F(RendererTest, AnImageThatWasRemovedIsBlackAndItsSuccessorIsItself) {
    const ImageHandle image = images.add({2, 2}, red_green_blue_white);
    const auto draw = [&](Painter& p) {
        p.fill({0, 0, 40, 40}, white);
        p.image({0, 0, 40, 40}, image, true);
    };
    EXPECT_EQ(at(drawn(draw), 1, 1), red);
    images.remove(image);
    EXPECT_EQ(at(drawn(draw), 1, 1), black);
    ASSERT_EQ(images.add({1, 1}, std::vector<std::uint8_t>{0, 255, 0, 255}), image);
    EXPECT_EQ(at(drawn(draw), 1, 1), green);
}

// --- comparing ---

class CompareTest : public RendererTest {
  protected:
    /// A comparison of 80 by 40 px. The first picture is red 200, the second red 40 and green 100.
    Picture compared(const CompareLook& look) {
        const ImageHandle first = images.add({1, 1}, std::vector<std::uint8_t>{200, 0, 0, 255});
        const ImageHandle second = images.add({1, 1}, std::vector<std::uint8_t>{40, 100, 0, 255});
        return drawn([&](Painter& p) { p.compare({10, 10, 80, 40}, first, second, look); });
    }
    static constexpr Color one{200, 0, 0, 255}, two{40, 100, 0, 255};
};

TEST_F(CompareTest, AWipeHasTheFirstOnItsLeft) {
    const Picture picture = compared({.position = 0.25F});
    EXPECT_EQ(at(picture, 29, 30), one);
    EXPECT_EQ(at(picture, 30, 30), two);
    EXPECT_EQ(bounds_of(picture), Rect(10, 10, 80, 40));
    EXPECT_EQ(at(compared({.position = 0}), 10, 30), two);
    EXPECT_EQ(at(compared({.position = 1}), 89, 30), one);
}

TEST_F(CompareTest, AWipeTurnsAroundTheMiddle) {
    const float quarter = 1.57079633F;
    const Picture down = compared({.angle = quarter});
    EXPECT_EQ(at(down, 80, 29), one);
    EXPECT_EQ(at(down, 20, 30), two);
    const Picture half = compared({.position = 0.25F, .angle = 2 * quarter});
    EXPECT_EQ(at(half, 69, 30), two) << "its left is now on the right";
    EXPECT_EQ(at(half, 70, 30), one);
    const Picture slanted = compared({.angle = quarter / 2});
    EXPECT_EQ(at(slanted, 50 - 10, 30 + 6), one);
    EXPECT_EQ(at(slanted, 50 + 10, 30 - 6), two);
    EXPECT_NEAR(at(slanted, 50 + 5, 30 - 6).r, 120, 60) << "smooth along the line";
}

TEST_F(CompareTest, ADifferenceIsAbsoluteAndAmplified) {
    EXPECT_EQ(at(compared({.mode = CompareMode::difference}), 50, 30), Color(160, 100, 0, 255));
    const Color half = at(compared({.mode = CompareMode::difference, .gain = 0.5F}), 50, 30);
    EXPECT_NEAR(half.r, 80, 1);
    EXPECT_EQ(at(compared({.mode = CompareMode::difference, .gain = 2}), 50, 30), Color(255, 200, 0, 255));
}

TEST_F(CompareTest, AnOnionSkinIsAMixtureAndEachAloneIsItself) {
    const Color onion = at(compared({.mode = CompareMode::onion, .mix = 0.25F}), 50, 30);
    EXPECT_NEAR(onion.r, 160, 1);
    EXPECT_NEAR(onion.g, 25, 1);
}

TEST_F(CompareTest, PicturesOfTheHostAndOwnOnesLieTheSameWayUp) {
    const ImageHandle own = images.add({1, 2}, std::vector<std::uint8_t>{0, 255, 0, 255, 255, 0, 0, 255});
    const Canvas host({1, 2});
    const std::uint8_t from_the_bottom[] = {255, 0, 0, 255, 0, 255, 0, 255};
    glTextureSubImage2D(host.texture(), 0, 0, 0, 1, 2, GL_RGBA, GL_UNSIGNED_BYTE, from_the_bottom);
    for (const bool host_first : {true, false}) {
        const ImageHandle first = host_first ? host.texture() : own, second = host_first ? own : host.texture();
        const Picture picture = drawn([&](Painter& p) { p.compare({0, 0, 40, 40}, first, second, {.nearest = true}); });
        for (const int x : {5, 35}) {
            EXPECT_EQ(at(picture, x, 5), green);
            EXPECT_EQ(at(picture, x, 35), red);
        }
    }
}

}  // namespace
}  // namespace lapfx::ui::test
