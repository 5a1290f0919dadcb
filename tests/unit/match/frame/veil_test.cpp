#include "match/frame/veil.h"

#include <gtest/gtest.h>

#include "unit/match/pictures.h"

namespace lapfx::match {
namespace {

cv::Mat ones() {
    return {test::height, test::width, CV_32F, cv::Scalar(1)};
}

double mean_error(const cv::Mat& a, const cv::Mat& b) {
    cv::Mat off;
    cv::absdiff(a, b, off);
    return cv::mean(off)[0];
}

TEST(Veil, OfTheModelIsFoundWhereverTheLightIsKnown) {
    const cv::Mat clear = test::tissue(), veil = test::ramp(0.0, 0.9), light = test::light_of({});
    VeilSolver solver;
    solver.solve(clear, test::veiled(clear, veil, light), ones(), light);
    EXPECT_LT(mean_error(solver.veil(), veil), 0.01);
}

TEST(Veil, IsZeroOverTheBaselineItself) {
    const cv::Mat clear = test::tissue();
    VeilSolver solver;
    solver.solve(clear, clear, ones(), test::light_of({}));
    EXPECT_LT(cv::mean(solver.veil())[0], 0.003);
}

TEST(Veil, IsNotDrawnAsideByWhatNoVeilExplains) {
    const cv::Mat clear = test::tissue(), veil(test::height, test::width, CV_32F, cv::Scalar(0.3)),
                  light = test::light_of({});
    cv::Mat bloody = clear.clone();
    test::bleed(bloody, {160, 128}, 22);
    VeilSolver solver;
    solver.solve_wide(clear, test::veiled(bloody, veil, light), ones(), light, 3);
    EXPECT_NEAR(solver.veil().at<float>(128, 160), 0.3, 0.06);
}

TEST(Veil, OverTissueIsNotThatOfTheDarkBehindIt) {
    cv::Mat clear = test::tissue(), veil(test::height, test::width, CV_32F, cv::Scalar(0.1));
    const cv::Mat light = test::light_of({});
    const cv::Rect behind(0, 0, test::width / 3, test::height);
    clear(behind) = cv::Scalar::all(0.001);
    veil(behind) = 0.3F;
    VeilSolver solver;
    solver.solve(clear, test::veiled(clear, veil, light), ones(), light);
    const cv::Rect rim(test::width / 3 + 2, 30, 12, test::height - 60), dark(test::width / 3 - 14, 30, 12, rim.height);
    EXPECT_NEAR(cv::mean(solver.veil()(rim))[0], 0.1, 0.01);
    EXPECT_NEAR(cv::mean(solver.veil()(dark))[0], 0.3, 0.01);
    EXPECT_LT(mean_error(solver.veil(), veil), 0.01);
}

TEST(Veil, WhereNothingCountsComesFromAround) {
    const cv::Mat clear = test::tissue(), veil(test::height, test::width, CV_32F, cv::Scalar(0.4)),
                  light = test::light_of({});
    cv::Mat counts = ones();
    counts(cv::Rect(100, 80, 90, 90)) = 0.0F;
    VeilSolver solver;
    solver.solve(clear, test::veiled(clear, veil, light), counts, light);
    EXPECT_NEAR(solver.veil().at<float>(125, 145), 0.4, 0.02);
}

TEST(Veil, StandsOutByWhatIsAboveItsMedian) {
    cv::Mat veil(test::height, test::width, CV_32F, cv::Scalar(0.2)), part(veil.size(), CV_8U, cv::Scalar(255));
    veil(cv::Rect(0, 0, test::width / 4, test::height)) = 0.6;
    veil(cv::Rect(test::width / 2, 0, test::width / 8, test::height)) = 0.0;
    std::vector<float> sorted;
    EXPECT_NEAR(standing_out(veil, part, sorted), 0.4 / 4.0, 1e-6) << "what is below the median takes nothing from it";
    part(cv::Rect(0, 0, test::width / 4, test::height)) = 0;
    EXPECT_NEAR(standing_out(veil, part, sorted), 0.0, 1e-6);
    part.setTo(0);
    EXPECT_EQ(standing_out(veil, part, sorted), 0.0);
}

TEST(Veil, ResidualIsInUnitsOfNoise) {
    const cv::Mat clear = test::tissue(), light = test::light_of({});
    VeilSolver solver;
    cv::Mat frame = test::veiled(clear, test::ramp(0.2, 0.2), light), rest;
    solver.solve(clear, frame, ones(), light);
    solver.residual(clear, frame, light, 0.0, rest);
    EXPECT_LT(cv::mean(rest)[0], 0.2);
    frame(cv::Rect(50, 50, 10, 10)) = cv::Scalar(0.6, 0.1, 0.1);  // blue: neither tissue nor smoke
    solver.residual(clear, frame, light, 0.0, rest);
    EXPECT_GT(rest.at<float>(55, 55), 5.0F);
}

}  // namespace
}  // namespace lapfx::match
