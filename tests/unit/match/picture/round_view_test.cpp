#include "match/picture/round_view.h"

#include <gmock/gmock.h>

#include <opencv2/imgproc.hpp>

namespace lapfx::match {
namespace {

/// Tissue of uneven light behind a round rim that is softened over a few pixels; drawn four times as large and shrunk.
cv::Mat behind_rim(cv::Size size, glm::dvec2 center, double radius) {
    cv::Mat large(size * 4, CV_8UC3, cv::Scalar(4, 3, 6));
    const cv::Point middle(static_cast<int>(4 * (center.x + 0.5)), static_cast<int>(4 * (center.y + 0.5)));
    cv::circle(large, middle, static_cast<int>(4 * radius), cv::Scalar(70, 80, 165), cv::FILLED);
    for (int i = 0; i < 12; ++i)  // folds
        cv::circle(large, middle + cv::Point(120 * (i % 4) - 180, 100 * (i / 4) - 100), 40, cv::Scalar(40, 50, 120),
                   12);
    cv::Mat made;
    cv::resize(large, made, size, 0, 0, cv::INTER_AREA);
    cv::GaussianBlur(made, made, {5, 5}, 1.2);
    return made;
}

TEST(RoundView, IsFoundToPartsOfAPixelWhereverItLies) {
    struct Case {
        cv::Size size;
        glm::dvec2 center;
        double radius;
    };
    for (const Case& c : {Case{{320, 240}, {150, 122}, 95}, Case{{640, 360}, {330.25, 170.5}, 220},
                          Case{{854, 480}, {431, 238}, 268.5}, Case{{1280, 720}, {655.5, 351}, 402}}) {
        const auto found = round_view(behind_rim(c.size, c.center, c.radius));
        ASSERT_TRUE(found) << c.radius;
        EXPECT_NEAR(found->center.x, c.center.x, 0.4) << c.radius;
        EXPECT_NEAR(found->center.y, c.center.y, 0.4) << c.radius;
        EXPECT_NEAR(found->radius, c.radius, 0.5);
    }
}

TEST(RoundView, IsNotBentByInstrumentsAndShadeAtTheRim) {
    cv::Mat picture = behind_rim({854, 480}, {425, 240}, 260);
    cv::rectangle(picture, {560, 150}, {760, 190}, cv::Scalar(8, 6, 9), cv::FILLED);  // in the shade
    cv::line(picture, {160, 300}, {330, 250}, cv::Scalar(150, 150, 150), 24);
    cv::putText(picture, "12:45", {20, 40}, cv::FONT_HERSHEY_SIMPLEX, 1, cv::Scalar(230, 230, 230), 2);
    const auto found = round_view(picture);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->center.x, 425, 0.8);
    EXPECT_NEAR(found->center.y, 240, 0.8);
    EXPECT_NEAR(found->radius, 260, 0.8);
}

TEST(RoundView, IsNoneInAFullFrameBetweenBarsAndInBlack) {
    EXPECT_FALSE(round_view(cv::Mat(240, 320, CV_8UC3, cv::Scalar(70, 80, 165))));
    EXPECT_FALSE(round_view(cv::Mat(240, 320, CV_8UC3, cv::Scalar(0, 0, 0))));
    cv::Mat bars(240, 320, CV_8UC3, cv::Scalar(0, 0, 0));
    bars.rowRange(30, 210) = cv::Scalar(70, 80, 165);
    EXPECT_FALSE(round_view(bars));
}

TEST(DiscOf, IsFoundWhereverItLies) {
    cv::Mat view = cv::Mat::zeros(240, 320, CV_8U);
    cv::circle(view, {140, 110}, 95, 255, cv::FILLED);
    const auto disc = disc_of(view);
    ASSERT_TRUE(disc.has_value());
    EXPECT_NEAR(disc->center.x, 140, 1);
    EXPECT_NEAR(disc->center.y, 110, 1);
    EXPECT_NEAR(disc->radius, 95, 1.5);
    view = cv::Mat::zeros(240, 320, CV_8U);
    cv::circle(view, {160, 120}, 140, 255, cv::FILLED);
    ASSERT_TRUE(disc_of(view).has_value()) << "cut off above and below";
    EXPECT_NEAR(disc_of(view)->radius, 140, 2);
    EXPECT_FALSE(disc_of(cv::Mat(240, 320, CV_8U, cv::Scalar(255))).has_value());
    view = cv::Mat::zeros(240, 320, CV_8U);
    cv::rectangle(view, {40, 30}, {280, 210}, 255, cv::FILLED);
    EXPECT_FALSE(disc_of(view).has_value());
}

}  // namespace
}  // namespace lapfx::match
