#include "match/frame/added_light.h"

#include <gtest/gtest.h>

#include "unit/match/pictures.h"

namespace lapfx::match {
namespace {

cv::Mat all() {
    return {test::height, test::width, CV_8U, cv::Scalar(255)};
}

/// `light`: of luminance 1, blue, green, red, as much of it as the map (CV_32F) says, added before the gain.
cv::Mat lit(const cv::Mat& tissue, const cv::Mat& map, const cv::Vec3f& light, double gain) {
    cv::Mat made = tissue.clone();
    for (int y = 0; y < made.rows; ++y)
        for (int x = 0; x < made.cols; ++x)
            made.at<cv::Vec3f>(y, x) =
                (tissue.at<cv::Vec3f>(y, x) + light * map.at<float>(y, x)) * static_cast<float>(gain);
    return made;
}

const cv::Vec3f grey(1.0F, 1.0F, 1.0F);

TEST(AddedLight, IsToldWhateverTheGain) {
    const cv::Mat clear = test::tissue();
    cv::Mat map = cv::max(test::ramp(-0.2, 0.3), 0.0);
    AddedLightFinder finder;
    for (const double gain : {0.5, 0.8, 1.0, 1.5}) {
        const AddedLight a = finder.find(clear, lit(clear, map, grey, gain), test::light_of({}), all());
        EXPECT_TRUE(a.known);
        EXPECT_NEAR(a.gain, gain, 0.01 * gain);
        EXPECT_NEAR(a.light, cv::mean(map)[0], 0.01) << gain;
    }
}

TEST(AddedLight, LeavesTheGainToTheClearestPlaces) {
    const cv::Mat clear = test::tissue();
    cv::Mat map(test::height, test::width, CV_32F, cv::Scalar(0.3));
    map.colRange(0, test::width / 5) = 0.0;
    AddedLightFinder finder;
    EXPECT_NEAR(finder.find(clear, lit(clear, map, grey, 0.7), test::light_of({}), all()).gain, 0.7, 0.02);
}

TEST(AddedLight, OfHazeEverywhereBoundsTheGain) {
    const HazeLight haze;
    const cv::Mat clear = test::tissue(), veil(test::height, test::width, CV_32F, cv::Scalar(0.3));
    AddedLightFinder finder;
    const AddedLight a =
        finder.find(clear, test::veiled(clear, veil, test::light_of(haze)), test::light_of(haze), all());
    EXPECT_NEAR(a.gain, 1.0, 0.15);
    EXPECT_LT(a.of_bright_smoke, 0.9);
    EXPECT_GT(a.of_dim_smoke, 1.1);
}

TEST(AddedLight, IsFoundThoughTheBaselineLiesBeside) {
    const cv::Mat clear = test::tissue(), map = cv::max(test::ramp(-0.2, 0.3), 0.0);
    const cv::Mat beside = cv::Mat(clear.size(), clear.type());
    cv::warpAffine(lit(clear, map, grey, 0.8), beside, cv::Matx23d(1, 0, 2, 0, 1, -1), clear.size(), cv::INTER_LINEAR,
                   cv::BORDER_REFLECT);
    const AddedLight a = AddedLightFinder().find(clear, beside, test::light_of({}), all());
    EXPECT_NEAR(a.gain, 0.8, 0.04);
    EXPECT_NEAR(a.light, cv::mean(map)[0], 0.015);
    EXPECT_GT(a.spread, 0.0);
}

TEST(AddedLight, OfTooLittleTissueIsNotKnown) {
    const cv::Mat clear = test::tissue();
    cv::Mat part = cv::Mat::zeros(test::height, test::width, CV_8U);
    part(cv::Rect(100, 100, 10, 10)) = 255;
    const cv::Mat lighter = lit(clear, test::ramp(0.2, 0.2), grey, 0.5);
    const AddedLight small = AddedLightFinder().find(clear, lighter, test::light_of({}), part);
    EXPECT_FALSE(small.known);
    EXPECT_EQ(small.gain, 1.0);
    EXPECT_EQ(small.light, 0.0);
    const cv::Mat plain(clear.size(), clear.type(), cv::Scalar(0.2, 0.152, 0.16));
    EXPECT_FALSE(AddedLightFinder().find(plain, 0.5 * plain, test::light_of({}), all()).known)
        << "its colour is that of smoke";
}

}  // namespace
}  // namespace lapfx::match
