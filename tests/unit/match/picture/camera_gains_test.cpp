#include "match/picture/camera_gains.h"

#include <gtest/gtest.h>

#include "unit/match/pictures.h"

namespace lapfx::match {
namespace {

cv::Mat gained(const cv::Mat& picture, const cv::Vec3f& by) {
    cv::Mat made;
    cv::multiply(picture, cv::Scalar(by[0], by[1], by[2]), made);
    return made;
}

cv::Mat all() {
    return {test::height, test::width, CV_8U, cv::Scalar(255)};
}

TEST(CameraGains, AreFoundBesideBlood) {
    const cv::Vec3f gains(1.3F, 1.1F, 0.8F);
    const cv::Mat clear = test::tissue();
    cv::Mat frame = gained(clear, gains);
    test::bleed(frame, {150, 130}, 70);  // a fifth of the picture
    const cv::Vec3f found = camera_gains(clear, frame, all());
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], gains[k], 0.02) << k;
}

TEST(CameraGains, AreWhatACameraDoesAtMost) {
    const cv::Mat clear = test::tissue();
    const cv::Vec3f found = camera_gains(clear, gained(clear, {5.0F, 0.1F, 1.0F}), all());
    EXPECT_NEAR(found[0], std::exp(0.8), 1e-4);
    EXPECT_NEAR(found[1], std::exp(-0.8), 1e-4);
    EXPECT_NEAR(found[2], 1.0, 1e-4);
}

TEST(CameraGains, OfTooLittleAreNone) {
    cv::Mat part = cv::Mat::zeros(test::height, test::width, CV_8U);
    part(cv::Rect(100, 100, 12, 12)) = 255;
    const cv::Mat clear = test::tissue();
    EXPECT_EQ(camera_gains(clear, gained(clear, {1.3F, 1.3F, 1.3F}), part), cv::Vec3f(1.0F, 1.0F, 1.0F));
}

}  // namespace
}  // namespace lapfx::match
