#include "match/picture/traps.h"

#include <gtest/gtest.h>

#include "match/picture/view.h"
#include "unit/match/pictures.h"

namespace lapfx::match {
namespace {

const cv::Point middle{test::width / 2, test::height / 2};
constexpr int view_radius = 110;

InView trap_in(const cv::Mat& linear) {
    const cv::Mat code = test::code_picture(linear);
    return trap_of(code, view_of(code));
}

cv::Mat evenly(const cv::Scalar& light) {
    return {test::height, test::width, CV_32FC3, light};
}

cv::Mat in_round_view(const cv::Mat& picture) {
    cv::Mat made = evenly({0, 0, 0}), disc = cv::Mat::zeros(picture.size(), CV_8U);
    cv::circle(disc, middle, view_radius, 255, cv::FILLED);
    picture.copyTo(made, disc);
    return made;
}

/// `inside` seen through a white ring, whose hole has that radius and is so far off the middle.
cv::Mat ringed(const cv::Mat& inside, int radius, cv::Point off = {}) {
    cv::Mat made = evenly({0.75, 0.68, 0.66}), hole = cv::Mat::zeros(inside.size(), CV_8U);
    cv::circle(hole, middle + off, radius, 255, cv::FILLED);
    inside.copyTo(made, hole);
    return in_round_view(made);
}

cv::Mat veiled(double veil, const HazeLight& light) {
    return test::veiled(test::tissue(), cv::Mat(test::height, test::width, CV_32F, cv::Scalar(veil)),
                        test::light_of(light));
}

TEST(Traps, AViewWithoutRedIsABag) {
    cv::Mat blue, white;
    cv::transform(test::tissue(3), blue, cv::Matx33f(0, 0, 0.60F, 0, 0, 0.55F, 0, 0, 0.40F));
    cv::transform(test::tissue(3), white, cv::Matx33f(0, 0, 1.2F, 0, 0, 1.15F, 0, 0, 1.25F));
    for (const cv::Mat& bag : {blue, white, evenly({0.9, 0.9, 0.9}), evenly({0.1, 0.1, 0.1})}) {
        EXPECT_EQ(trap_in(bag), InView::bag);
        EXPECT_EQ(trap_in(in_round_view(bag)), InView::bag);
    }
}

TEST(Traps, TissueIsNone) {
    for (int seed = 1; seed < 6; ++seed) {
        EXPECT_EQ(trap_in(test::tissue(seed)), InView::tissue);
        EXPECT_EQ(trap_in(in_round_view(test::tissue(seed))), InView::tissue);
        EXPECT_EQ(trap_in(in_round_view(0.05 * test::tissue(seed))), InView::tissue) << "in poor light";
    }
    EXPECT_EQ(trap_in(evenly({0, 0, 0})), InView::tissue);
}

TEST(Traps, DenseSmokeBeforeTissueIsNone) {
    for (const HazeLight& light : {HazeLight{}, HazeLight{.color = {0.40, 0.37, 0.42}, .fall_off = 0.3},
                                   HazeLight{.color = {0.55, 0.48, 0.50}, .fall_off = 0.6}})
        for (const double veil : {0.3, 0.5, 0.7, 0.8}) {
            EXPECT_EQ(trap_in(veiled(veil, light)), InView::tissue) << veil << ", light " << light.color.g;
            EXPECT_EQ(trap_in(in_round_view(veiled(veil, light))), InView::tissue)
                << veil << ", light " << light.color.g;
        }
}

TEST(Traps, AWhiteRingAroundADarkerMiddleIsATrocar) {
    for (const int radius : {36, 50, 80}) {
        EXPECT_EQ(trap_in(ringed(test::tissue(), radius)), InView::trocar) << radius;
        EXPECT_EQ(trap_in(ringed(veiled(0.4, HazeLight{}), radius)), InView::trocar) << radius;
    }
    EXPECT_EQ(trap_in(ringed(test::tissue(), 78, {15, 5})), InView::trocar) << "not quite in the middle";
    EXPECT_EQ(trap_in(ringed(test::tissue(), 100, {100, 0})), InView::tissue) << "on one side only, as an instrument";
}

TEST(Traps, TheReddestTenthTellsHaze) {
    double last = -10.0;
    for (const double veil : {0.0, 0.2, 0.4, 0.6, 0.8}) {
        const cv::Mat code = test::code_picture(veiled(veil, HazeLight{}));
        const double found = reddest_tenth(code, view_of(code));
        EXPECT_GT(found, last) << veil;
        last = found;
    }
    EXPECT_LT(last, -0.07);
    EXPECT_NEAR(
        reddest_tenth(test::code_picture(evenly({0.3, 0.3, 0.3})), cv::Mat(test::height, test::width, CV_8U, 255)), 0.0,
        1e-6);
}

}  // namespace
}  // namespace lapfx::match
