// The comparer of the golden images: it has to fail when it should.
#include "support/image_compare.h"

#include <gmock/gmock.h>

namespace lapfx::tests {
namespace {

using testing::HasSubstr;

// Eight by four, grey 100, blue-green-red.
cv::Mat grey() {
    return cv::Mat(4, 8, CV_8UC3, cv::Scalar(100, 100, 100));
}

TEST(ImageCompare, EqualImagesPass) {
    const Comparison result = compare(grey(), grey());
    EXPECT_TRUE(result.passed);
    EXPECT_EQ(result.reason, "equal");
    EXPECT_EQ(result.max_difference, 0);
    EXPECT_EQ(result.failing_pixels, 0);
    EXPECT_EQ(result.pixels, 32);
}

TEST(ImageCompare, OneChannelOfOnePixelFailsAndIsNamed) {
    cv::Mat candidate = grey();
    candidate.at<cv::Vec3b>(2, 5)[1] = 101;
    const Comparison result = compare(grey(), candidate);
    EXPECT_FALSE(result.passed);
    EXPECT_EQ(result.failing_pixels, 1);
    EXPECT_EQ(result.max_difference, 1);
    EXPECT_EQ(result.worst, cv::Point(5, 2));
    EXPECT_DOUBLE_EQ(result.mean_difference, 1.0 / (32 * 3));
    EXPECT_THAT(result.reason, HasSubstr("max 1 at 5,2: expected (100,100,100), got (100,101,100)"));
}

TEST(ImageCompare, WorstIsTheLargestDifferenceInEitherDirection) {
    cv::Mat candidate = grey();
    candidate.at<cv::Vec3b>(0, 0) = {110, 100, 100};
    candidate.at<cv::Vec3b>(3, 7) = {100, 100, 80};
    const Comparison result = compare(grey(), candidate);
    EXPECT_EQ(result.max_difference, 20);
    EXPECT_EQ(result.worst, cv::Point(7, 3));
    EXPECT_EQ(result.failing_pixels, 2);
}

TEST(ImageCompare, ToleranceIsInclusive) {
    cv::Mat candidate = grey();
    candidate.at<cv::Vec3b>(1, 1)[0] = 103;
    EXPECT_TRUE(compare(grey(), candidate, {.max_difference = 3}).passed);
    EXPECT_FALSE(compare(grey(), candidate, {.max_difference = 2}).passed);
}

TEST(ImageCompare, FailingFractionIsInclusive) {
    cv::Mat candidate = grey();
    candidate.at<cv::Vec3b>(0, 0)[0] = 200;
    candidate.at<cv::Vec3b>(0, 1)[2] = 200;
    EXPECT_TRUE(compare(grey(), candidate, {.failing_fraction = 2.0 / 32}).passed);
    EXPECT_FALSE(compare(grey(), candidate, {.failing_fraction = 1.0 / 32}).passed);
}

TEST(ImageCompare, AlphaCounts) {
    const cv::Mat reference(2, 2, CV_8UC4, cv::Scalar(1, 2, 3, 255));
    cv::Mat candidate = reference.clone();
    candidate.at<cv::Vec4b>(0, 1)[3] = 254;
    EXPECT_FALSE(compare(reference, candidate).passed);
    EXPECT_EQ(difference_image(reference, candidate).at<cv::Vec3b>(0, 1), cv::Vec3b(16, 16, 16));
}

TEST(ImageCompare, AnotherSizeNeverPasses) {
    const cv::Mat wide(4, 9, CV_8UC3, cv::Scalar(100, 100, 100));
    const Comparison result = compare(grey(), wide, {.max_difference = 255, .failing_fraction = 1.0});
    EXPECT_FALSE(result.passed);
    EXPECT_THAT(result.reason, HasSubstr("expected 8x4 with 3 channels of 8 bits, got 9x4"));
}

TEST(ImageCompare, OtherChannelsDepthOrNothingNeverPass) {
    const Tolerance all{.max_difference = 255, .failing_fraction = 1.0};
    const cv::Mat deep(4, 8, CV_16UC3, cv::Scalar(100, 100, 100));
    EXPECT_FALSE(compare(grey(), cv::Mat(4, 8, CV_8UC4, cv::Scalar::all(100)), all).passed);
    EXPECT_FALSE(compare(grey(), deep, all).passed);
    EXPECT_THAT(compare(deep, deep, all).reason, HasSubstr("only 8 bits are compared"));
    EXPECT_FALSE(compare(grey(), {}, all).passed);
    EXPECT_FALSE(compare({}, grey(), all).passed);
    EXPECT_FALSE(compare({}, {}, all).passed);
}

TEST(ImageCompare, ViewsIntoLargerImagesCompareByTheirPixels) {
    cv::Mat large(20, 20, CV_8UC3, cv::Scalar(7, 7, 7));
    cv::Mat view = large(cv::Rect(3, 5, 8, 4));
    view.setTo(cv::Scalar(100, 100, 100));
    EXPECT_TRUE(compare(grey(), view).passed);
    large.at<cv::Vec3b>(5 + 3, 3 + 7)[0] = 0;
    EXPECT_EQ(compare(grey(), view).worst, cv::Point(7, 3));
}

TEST(DifferenceImage, IsAmplifiedAndClamped) {
    cv::Mat candidate = grey();
    candidate.at<cv::Vec3b>(0, 0) = {101, 98, 200};
    const cv::Mat image = difference_image(grey(), candidate);
    EXPECT_EQ(image.at<cv::Vec3b>(0, 0), cv::Vec3b(16, 32, 255));
    EXPECT_EQ(image.at<cv::Vec3b>(0, 1), cv::Vec3b(0, 0, 0));
    EXPECT_TRUE(difference_image(grey(), {}).empty());
}

TEST(ThresholdSweep, EndsAtTheToleranceThatWouldPass) {
    cv::Mat candidate = grey();
    candidate.at<cv::Vec3b>(0, 0)[0] = 103;
    candidate.at<cv::Vec3b>(0, 1)[0] = 101;
    EXPECT_EQ(threshold_sweep(grey(), candidate),
              "max difference  failing pixels\n"
              "             0               2\n"
              "             1               1\n"
              "             2               1\n"
              "             4               0\n");
}

}  // namespace
}  // namespace lapfx::tests
