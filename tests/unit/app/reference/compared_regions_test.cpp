#include "app/reference/compared_regions.h"

#include <gtest/gtest.h>

namespace lapfx::app {
namespace {

Image grey(int level) {
    Image image{.width = 16, .height = 16, .pixels = std::vector<std::uint8_t>(16 * 16 * 4, 255), .name = ""};
    for (std::size_t i = 0; i < image.pixels.size(); i += 4)
        image.pixels[i] = image.pixels[i + 1] = image.pixels[i + 2] = static_cast<std::uint8_t>(level);
    return image;
}

class ComparedRegionsTest : public ::testing::Test {
  protected:
    void SetUp() override { regions.follow({{}, {.x = 0, .y = 0, .width = 1, .height = 1}}, {}); }
    /// frame:value of a curve.
    std::string curve(std::size_t side, RegionFigure figure) {
        std::vector<double> frames, values;
        regions.curve(side, 1, figure, frames, values);
        std::string text;
        for (std::size_t i = 0; i < frames.size(); ++i)
            text += std::to_string(static_cast<int>(frames[i])) + ':' + std::to_string(std::lround(values[i])) + ' ';
        return text;
    }
    ComparedRegions regions;
};

TEST_F(ComparedRegionsTest, CurvesFillInAnyOrderAndKeepTheLast) {
    regions.count(0, grey(51), 30);
    regions.count(0, grey(102), 10);
    regions.count(0, grey(153), 20);
    EXPECT_EQ(curve(0, RegionFigure::veil), "10:40 20:60 30:20 ");
    regions.count(0, grey(255), 20);
    EXPECT_EQ(curve(0, RegionFigure::brightness), "10:40 20:100 30:20 ");
    EXPECT_EQ(curve(1, RegionFigure::veil), "");
    EXPECT_NEAR(regions.now(0, 1).veil, 1, 1e-9);
}

TEST_F(ComparedRegionsTest, WhatBelongsToNoFrameIsInNoCurve) {
    regions.count(0, grey(51), -1);
    EXPECT_TRUE(regions.counted(0));
    EXPECT_EQ(curve(0, RegionFigure::veil), "");
}

TEST_F(ComparedRegionsTest, TheDistanceIsWhereBothWereSeen) {
    regions.count(0, grey(0), 1);
    regions.count(0, grey(0), 3);
    regions.count(0, grey(0), 4);
    regions.count(1, grey(255), 3);
    regions.count(1, grey(0), 4);
    regions.count(1, grey(0), 5);
    EXPECT_EQ(curve(0, RegionFigure::distance), "3:100 4:0 ");
    EXPECT_EQ(curve(1, RegionFigure::distance), "3:100 4:0 ");
}

TEST_F(ComparedRegionsTest, OtherRegionsForgetBothSidesAnotherPictureItsOwn) {
    regions.count(0, grey(51), 1);
    regions.count(1, grey(51), 1);
    const std::uint64_t before = regions.version();
    regions.follow({{}, {.x = 0, .y = 0, .width = 1, .height = 1}}, {});
    EXPECT_EQ(regions.version(), before) << "they are the same";
    regions.forget(0);
    EXPECT_FALSE(regions.counted(0));
    EXPECT_EQ(curve(0, RegionFigure::veil), "");
    EXPECT_EQ(curve(1, RegionFigure::veil), "1:20 ");
    regions.follow({{}, {.x = 0.1, .y = 0, .width = 0.9, .height = 1}}, {});
    EXPECT_FALSE(regions.counted(1));
    regions.count(1, grey(51), 1);
    regions.follow({{}, {.x = 0.1, .y = 0, .width = 0.9, .height = 1}}, {.redness = 5});
    EXPECT_EQ(curve(1, RegionFigure::veil), "");
}

}  // namespace
}  // namespace lapfx::app
