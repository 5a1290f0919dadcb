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

/// What a camera sees that went sideways by so many pixels, round the middle of the tissue: near tissue moves more than
/// twice as far, what is farthest a little against it.
cv::Mat seen_from_beside(const cv::Mat& code, double by) {
    cv::Mat map(code.size(), CV_32FC2), made;
    for (int y = 0; y < code.rows; ++y)
        for (int x = 0; x < code.cols; ++x) {
            const double nearness = 1.0 + 1.2 * std::sin(0.03 * x) * std::cos(0.024 * y);
            map.at<cv::Vec2f>(y, x) = cv::Vec2f(static_cast<float>(x - by * nearness), static_cast<float>(y));
        }
    cv::remap(code, made, map, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_REFLECT);
    return made;
}

/// How far the middle of the baseline has moved, px.
cv::Point2d shift_of(const Placement& placement) {
    const cv::Vec3d to = placement.place() * cv::Vec3d(test::width / 2.0, test::height / 2.0, 1.0);
    return {to[0] - test::width / 2.0, to[1] - test::height / 2.0};
}

TEST(Placement, IsKeptWhereNearAndFarTissueMoveApart) {
    const cv::Mat code = test::code_picture(test::tissue());
    Placement placement(texture(code), everything());
    for (double by = 1.5; by <= 30.0; by += 1.5) placement.follow(texture(seen_from_beside(code, by)));
    for (int frame = 0; frame < 10; ++frame) {
        const double by = 30.0 + 0.6 * (frame % 2);
        EXPECT_FALSE(placement.follow(texture(seen_from_beside(code, by)))) << "nothing moves strongly";
        EXPECT_LT(placement.likeness(), 0.3) << "no motion of a camera lays it well";
        EXPECT_NEAR(shift_of(placement).x, by, 6.0);
        EXPECT_NEAR(shift_of(placement).y, 0.0, 6.0);
    }
}

TEST(Placement, ComesBackAfterOtherPictures) {
    const cv::Mat code = test::code_picture(test::tissue()), other = test::code_picture(test::tissue(2));
    Placement placement(texture(code), everything());
    placement.follow(texture(moved(code, {1, 0, 4, 0, 1, 2, 0, 0, 1})));
    for (int frame = 0; frame < 12; ++frame) {
        placement.follow(texture(moved(other, {1, 0, 3.0 * frame, 0, 1, 0, 0, 0, 1})));
        EXPECT_LT(placement.likeness(), 0.15);
    }
    const cv::Mat again = texture(moved(code, {1, 0, -8, 0, 1, 5, 0, 0, 1}));
    for (int frame = 0; frame < 2; ++frame) placement.follow(again);
    EXPECT_GT(placement.likeness(), 0.8);
    EXPECT_NEAR(shift_of(placement).x, -8.0, 0.5);
    EXPECT_NEAR(shift_of(placement).y, 5.0, 0.5);
}

TEST(Placement, ComesBackWhenTheCameraDoes) {
    const cv::Mat code = test::code_picture(test::tissue());
    Placement placement(texture(code), everything());
    const double away = 2.0 * test::width;
    for (double by = 8.0; by <= away; by += 8.0) placement.follow(texture(moved(code, {1, 0, by, 0, 1, 0, 0, 0, 1})));
    for (double by = away; by >= 0.0; by -= 8.0) placement.follow(texture(moved(code, {1, 0, by, 0, 1, 0, 0, 0, 1})));
    EXPECT_TRUE(placement.still());
    EXPECT_NEAR(placement.likeness(), 1.0, 0.002);
}

TEST(Placement, TellsOfStrongMotionOnly) {
    const cv::Mat code = test::code_picture(test::tissue());
    Placement placement(texture(code), everything());
    placement.follow(texture(seen_from_beside(code, 5.0)));
    for (const double by : {7.0, 9.0, 11.0, 13.0, 15.0, 17.0, 19.0, 21.0})
        EXPECT_FALSE(placement.follow(texture(seen_from_beside(code, by)))) << by;
    const cv::Mat turned = texture(moved(seen_from_beside(code, 21.0), {1, 0, 0, 0, 1, 11, 0, 0, 1}));
    EXPECT_TRUE(placement.follow(turned));
    EXPECT_FALSE(placement.follow(turned));
}

TEST(Placement, OfAnotherViewHasNoLikeness) {
    Placement placement(texture(test::code_picture(test::tissue())), everything());
    placement.follow(texture(test::code_picture(test::tissue(2))));
    EXPECT_LT(placement.likeness(), 0.15);
}

}  // namespace
}  // namespace lapfx::match
