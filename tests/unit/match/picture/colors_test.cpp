#include "match/picture/colors.h"

#include <gtest/gtest.h>

#include "unit/match/pictures.h"

namespace lapfx::match {
namespace {

TEST(Colors, CodeValuesAndLinearLightAreEachOthersInverse) {
    EXPECT_FLOAT_EQ(linear_of(0), 0);
    EXPECT_FLOAT_EQ(linear_of(255), 1);
    EXPECT_NEAR(linear_of(128), 0.21586, 1e-4);  // sRGB's own example
    for (int code = 0; code <= 255; ++code) {
        const float linear = linear_of(static_cast<float>(code));
        EXPECT_NEAR(code_of(linear), code, 1e-2);
        EXPECT_NEAR(QuickCode()(linear), code, 0.1) << code;
    }
}

TEST(Colors, RednessIsRedOverTheMeanOfGreenAndBlueWithAnOffset) {
    cv::Mat linear(1, 2, CV_32FC3), redness;
    linear.at<cv::Vec3f>(0, 0) = {linear_of(20), linear_of(17), linear_of(71)};  // blood, blue green red
    linear.at<cv::Vec3f>(0, 1) = {0, 0, 0};
    redness_of(linear, redness);
    EXPECT_NEAR(redness.at<float>(0, 0), (71 + 8) / (18.5 + 8), 0.02);
    EXPECT_FLOAT_EQ(redness.at<float>(0, 1), 1);
}

TEST(Colors, AnEvenVeilHardlyChangesTheTexture) {
    const cv::Mat clear = test::tissue(),
                  smoky = test::veiled(clear, cv::Mat(clear.size(), CV_32F, 0.5F), test::light_of({}));
    cv::Mat a, b, unlike;
    texture_of(test::code_picture(clear), a);
    texture_of(test::code_picture(smoky), b);
    cv::absdiff(a, b, unlike);
    EXPECT_LT(cv::mean(unlike)[0], 8.0);
    cv::Mat other;
    texture_of(test::code_picture(test::tissue(2)), other);
    cv::absdiff(a, other, unlike);
    EXPECT_GT(cv::mean(unlike)[0], 30.0);
}

}  // namespace
}  // namespace lapfx::match
