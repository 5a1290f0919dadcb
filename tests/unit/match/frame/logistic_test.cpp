#include "match/frame/logistic.h"

#include <gtest/gtest.h>

#include <random>

namespace lapfx::match {
namespace {

/// Of one figure, the least is where w = 2 c / (1 + exp(w)) for rows at -1 and 1: here w = 0.40106.
TEST(Logistic, OfTwoRowsHasTheWeightOfTheFormula) {
    const cv::Mat rows = (cv::Mat_<double>(2, 1) << -1.0, 1.0);
    const Logistic found = Logistic::fit(rows, std::vector<std::uint8_t>{0, 1}, 0.5);
    EXPECT_NEAR(found.weights.at(0), 0.40106, 1e-4);
    EXPECT_NEAR(found.bias, 0.0, 1e-9);
}

TEST(Logistic, WeightsAreInTheUnitOfTheirFigure) {
    const cv::Mat rows = (cv::Mat_<double>(2, 2) << 90.0, 5.0, 110.0, 5.0);
    const Logistic found = Logistic::fit(rows, std::vector<std::uint8_t>{0, 1}, 0.5);
    EXPECT_NEAR(found.weights.at(0), 0.040106, 1e-5);
    EXPECT_NEAR(found.bias, -4.0106, 1e-3);
    EXPECT_EQ(found.weights.at(1), 0.0) << "what is always the same says nothing";
}

TEST(Logistic, BothKindsCountAlikeHoweverManyThereAre) {
    cv::Mat rows(10, 1, CV_64F, cv::Scalar(-1.0));
    std::vector<std::uint8_t> kinds(10, 0);
    rows.at<double>(9) = 1.0;
    kinds[9] = 1;
    const Logistic found = Logistic::fit(rows, kinds, 0.1);
    EXPECT_NEAR(Logistic::chance(found.bias), 0.5, 1e-6) << "in the middle between them";
    EXPECT_GT(found.weights[0], 0.0);
}

TEST(Logistic, FindsTheDirectionInWhichTheKindsLieApart) {
    std::mt19937 random(3);
    const auto noise = [&random] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
    cv::Mat rows(400, 3, CV_64F);
    std::vector<std::uint8_t> kinds;
    for (int i = 0; i < rows.rows; ++i) {
        kinds.push_back(i % 2 == 0 ? 1 : 0);
        rows.at<double>(i, 0) = noise();
        rows.at<double>(i, 1) = noise() + 0.4 * kinds.back();
        rows.at<double>(i, 2) = noise() - 0.4 * kinds.back();
    }
    const Logistic found = Logistic::fit(rows, kinds, 10.0);
    EXPECT_LT(std::abs(found.weights[0]), 0.15 * found.weights[1]);
    EXPECT_GT(found.weights[1], 0.0);
    EXPECT_NEAR(found.weights[2], -found.weights[1], 0.3 * found.weights[1]);
    int right = 0;
    for (int i = 0; i < rows.rows; ++i) {
        double sum = found.bias;
        for (int k = 0; k < 3; ++k) sum += found.weights[static_cast<std::size_t>(k)] * rows.at<double>(i, k);
        right += (Logistic::chance(sum) > 0.5) == (kinds[static_cast<std::size_t>(i)] == 1);
    }
    EXPECT_GT(right, 320);
}

TEST(Logistic, KindsThatLieApartWhollyHaveFiniteWeights) {
    const cv::Mat rows = (cv::Mat_<double>(4, 1) << -1e6, -0.9e6, 0.9e6, 1e6);
    const Logistic found = Logistic::fit(rows, std::vector<std::uint8_t>{0, 0, 1, 1}, 1e6);
    EXPECT_GT(found.weights[0], 0.0);
    EXPECT_LT(found.weights[0], 1.0);
    EXPECT_EQ(Logistic::chance(-1e4), 0.0);
    EXPECT_EQ(Logistic::chance(1e4), 1.0);
}

}  // namespace
}  // namespace lapfx::match
