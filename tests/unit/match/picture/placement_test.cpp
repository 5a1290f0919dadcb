#include "match/picture/placement.h"

#include <gtest/gtest.h>

#include "unit/match/pictures.h"

namespace lapfx::match {
namespace {

cv::Mat texture(const cv::Mat& code) {
    cv::Mat made;
    texture_of(code, made);
    return made;
}

cv::Mat everything() {
    return {test::height, test::width, CV_8U, cv::Scalar(255)};
}

cv::Mat moved(const cv::Mat& code, const cv::Matx33d& by) {
    cv::Mat made;
    cv::warpPerspective(code, made, by, code.size(), cv::INTER_LINEAR, cv::BORDER_REFLECT);
    return made;
}

TEST(Placement, OfACameraThatStandsStillIsWhereItWas) {
    const cv::Mat code = test::code_picture(test::tissue());
    Placement placement(texture(code), everything());
    EXPECT_FALSE(placement.follow(texture(code)));
    EXPECT_TRUE(placement.still());
    EXPECT_NEAR(placement.likeness(), 1.0, 1e-6);
}

TEST(Placement, FindsAShiftAndATurn) {
    const cv::Mat code = test::code_picture(test::tissue());
    const double turn = 0.03;
    const cv::Matx33d by(std::cos(turn), -std::sin(turn), 9.0, std::sin(turn), std::cos(turn), -6.0, 0, 0, 1);
    Placement placement(texture(code), everything());
    EXPECT_TRUE(placement.follow(texture(moved(code, by))));
    EXPECT_FALSE(placement.still());
    EXPECT_NEAR(placement.place()(0, 2), 9.0, 0.5);
    EXPECT_NEAR(placement.place()(1, 2), -6.0, 0.5);
    EXPECT_NEAR(placement.place()(1, 0), std::sin(turn), 0.005);
    EXPECT_GT(placement.likeness(), 0.8);
}

TEST(Placement, FindsItBehindSmokeAndComesBack) {
    const cv::Mat clear = test::tissue(), code = test::code_picture(clear);
    const cv::Mat smoky = test::code_picture(test::veiled(clear, test::ramp(0.2, 0.6), test::light_of({})));
    Placement placement(texture(code), everything());
    placement.follow(texture(moved(smoky, {1, 0, 7, 0, 1, 4, 0, 0, 1})));
    EXPECT_NEAR(placement.place()(0, 2), 7.0, 0.6);
    placement.follow(texture(smoky));
    EXPECT_TRUE(placement.still());
}

TEST(Placement, OfAnotherViewHasNoLikeness) {
    Placement placement(texture(test::code_picture(test::tissue())), everything());
    placement.follow(texture(test::code_picture(test::tissue(2))));
    EXPECT_LT(placement.likeness(), 0.15);
}

}  // namespace
}  // namespace lapfx::match
