// Least squares within bounds, against closed forms.
#include "match/explain/least_squares.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace lapfx::match {
namespace {

/// Rosenbrock's valley, "An automatic method for finding the greatest or least value of a function", 1960: least, 0, at
/// (1, 1).
LeastSquares valley() {
    LeastSquares problem{.residuals = 2, .low = {-3.0, -3.0}, .high = {3.0, 3.0}};
    problem.evaluate = [](std::span<const double> x, std::span<double> r) {
        r[0] = 10.0 * (x[1] - x[0] * x[0]), r[1] = 1.0 - x[0];
        return true;
    };
    problem.slope_step = 1e-5, problem.tolerance = 1e-12, problem.iterations = 100;
    return problem;
}

TEST(LeastSquares, EndsAtTheLeast) {
    std::vector<double> x = {-1.2, 1.0};
    const auto cost = solve(valley(), x);
    ASSERT_TRUE(cost);
    EXPECT_NEAR(x[0], 1.0, 1e-3);
    EXPECT_NEAR(x[1], 1.0, 2e-3);
    EXPECT_LT(*cost, 1e-6);
}

TEST(LeastSquares, StaysWithinItsBounds) {
    LeastSquares problem = valley();
    problem.high[0] = 0.5;  // the least on that edge is at x1 = 0.25, where the cost is 0.5^2 / 2
    std::vector<double> x = {-1.2, 1.0};
    EXPECT_NEAR(*solve(problem, x), 0.125, 1e-3);
    EXPECT_NEAR(x[0], 0.5, 1e-6);
    EXPECT_NEAR(x[1], 0.25, 5e-3);
}

TEST(LeastSquares, TurnsBackWhereThereIsNothing) {
    LeastSquares problem = valley();
    const auto inside = problem.evaluate;
    problem.evaluate = [&](std::span<const double> x, std::span<double> r) { return x[0] < 0.8 && inside(x, r); };
    std::vector<double> x = {-1.2, 1.0}, outside = {1.5, 1.0};
    EXPECT_LT(*solve(problem, x), 0.5);
    EXPECT_LT(x[0], 0.8);
    EXPECT_FALSE(solve(problem, outside));
    EXPECT_EQ(outside, (std::vector<double>{1.5, 1.0}));
}

TEST(LeastSquares, EndsWhenItIsTold) {
    LeastSquares problem = valley();
    int asked = 0;
    problem.goes_on = [&] { return ++asked < 3; };
    std::vector<double> x = {-1.2, 1.0};
    const double cost = *solve(problem, x);
    EXPECT_EQ(asked, 3);
    EXPECT_GT(cost, 1e-3) << "it was not there yet";
    EXPECT_LT(cost, 0.5 * (4.4 * 4.4 + 2.2 * 2.2)) << "but nearer than at the beginning";
}

TEST(LeastSquares, WhatIsThrownComesThrough) {
    LeastSquares problem = valley();
    problem.goes_on = []() -> bool { throw std::runtime_error("stopped"); };
    std::vector<double> x = {-1.2, 1.0};
    EXPECT_THROW(solve(problem, x), std::runtime_error);
}

TEST(LeastSquares, Linearises) {
    LeastSquares problem = valley();
    problem.slope_step = 1e-6;
    std::vector<double> r(2), slopes(4);
    ASSERT_TRUE(linearise(problem, std::vector{0.5, 2.0}, r, slopes));
    EXPECT_NEAR(r[0], 17.5, 1e-12);
    EXPECT_NEAR(r[1], 0.5, 1e-12);
    EXPECT_NEAR(slopes[0], -10.0, 1e-4);
    EXPECT_NEAR(slopes[1], 10.0, 1e-4);
    EXPECT_NEAR(slopes[2], -1.0, 1e-4);
    EXPECT_NEAR(slopes[3], 0.0, 1e-4);
    ASSERT_TRUE(linearise(problem, std::vector{0.5, 3.0}, r, slopes)) << "at a bound the step is inwards";
    EXPECT_NEAR(slopes[1], 10.0, 1e-4);
}

}  // namespace
}  // namespace lapfx::match
