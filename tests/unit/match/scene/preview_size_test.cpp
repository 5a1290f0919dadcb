// The size of pictures that are measured beside a reference.
#include <gtest/gtest.h>

#include "match/picture/view.h"
#include "match/scene/preview_curve.h"

namespace lapfx::match {
namespace {

TEST(PreviewSize, HasTheShapeOfTheReferenceAsItIsShown) {
    EXPECT_EQ(preview_size({1280, 1024}), glm::ivec2(256, 205));
    EXPECT_EQ(preview_size({480, 854}), glm::ivec2(144, 256));
    EXPECT_EQ(preview_size({720, 576}, 16.0 / 9.0), glm::ivec2(256, 144)) << "stored 5:4, shown 16:9";
    EXPECT_EQ(preview_size({4000, 2}), glm::ivec2(256, 16));
    EXPECT_EQ(preview_size({0, 0}), glm::ivec2(256, 256));
    EXPECT_EQ(preview_size({1280, 1024}, 0.0, 96), glm::ivec2(96, 77)) << "as small as is asked for";
}

TEST(PreviewSize, IsMeasuredInTheShapeInWhichTheReferenceIsStored) {
    const auto squeezed = PreviewCurve::options_for({720, 576}, 16.0 / 9.0, {});
    EXPECT_EQ(squeezed.size, glm::ivec2(364, 205)) << "no detail is lost";
    EXPECT_EQ(squeezed.measured, glm::ivec2(256, 205));
    EXPECT_EQ(PreviewCurve::options_for({1280, 1024}, 0.0, {}).measured, glm::ivec2(0)) << "as it is drawn";
    EXPECT_EQ(PreviewCurve::options_for({1280, 1024}, 1.25, {}).measured, glm::ivec2(0));
}

/// A round view of 0.4 of the height in pictures twice as wide as high, squeezed to a square.
TEST(PreviewSize, ARoundViewIsAnEllipseThen) {
    const cv::Mat round = disc_of({0.5, 0.5, 0.4}, {256, 128}), squeezed = disc_of({0.5, 0.5, 0.4}, {128, 128}, 2.0);
    const auto share = [](const cv::Mat& part) { return cv::countNonZero(part) / static_cast<double>(part.total()); };
    EXPECT_NEAR(share(squeezed), share(round), 0.01);
    EXPECT_EQ(squeezed.at<std::uint8_t>(64, 64 + 20), 255);
    EXPECT_EQ(squeezed.at<std::uint8_t>(64, 64 + 30), 0);
    EXPECT_EQ(squeezed.at<std::uint8_t>(64 + 46, 64), 255);
}

}  // namespace
}  // namespace lapfx::match
