#include "bleeding/point_blur.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/tissue.h"

namespace lapfx::bleeding {
namespace {

using namespace test;

/// A square grid in a plane, `spacing` mm apart, 60 mm wide, and 1 where x > 0.
struct Grid {
    explicit Grid(double spacing) {
        const int half = static_cast<int>(30.0 / spacing);
        for (int z = -half; z < half; ++z)
            for (int x = -half; x < half; ++x) {
                points.emplace_back((x + 0.5) * spacing, 0.0, (z + 0.5) * spacing);
                values.push_back(x >= 0 ? 1.0f : 0.0f);
            }
        weights.assign(points.size(), static_cast<float>(spacing * spacing));
    }
    std::vector<glm::vec3> points;
    std::vector<float> values, weights;
};

TEST(PointBlur, AStepBecomesTheErrorFunctionAtAnySpacing) {
    for (const double spacing : {2.0, 1.0, 0.25}) {
        const Grid grid(spacing);
        const std::vector<float> blurred = PointBlur(grid.points, grid.weights, 3.0)(grid.values);
        double worst = 0.0;
        for (std::size_t i = 0; i < blurred.size(); ++i)
            if (std::abs(grid.points[i].z) < 20.0f && std::abs(grid.points[i].x) < 20.0f)
                worst = std::max(worst, std::abs(double(blurred[i]) - below(double(grid.points[i].x), 3.0)));
        EXPECT_LT(worst, 0.04) << spacing;
    }
}

TEST(PointBlur, WeightsCountAndAConstantStaysOne) {
    const std::vector<glm::vec3> points{{0, 0, 0}, {0.1f, 0, 0}, {0, 0.1f, 0}};
    const std::vector<float> weights{1.0f, 2.0f, 1.0f}, values{0.0f, 1.0f, 4.0f}, same(3, 0.7f);
    const PointBlur blur(points, weights, 100.0);
    for (const float value : blur(values)) EXPECT_NEAR(value, 1.5f, 1e-5f);
    for (const float value : blur(same)) EXPECT_NEAR(value, 0.7f, 1e-6f);
}

TEST(PointBlur, WhatIsFarAwayDoesNotCount) {
    const std::vector<glm::vec3> points{{0, 0, 0}, {7.6f, 0, 0}, {-4, 0, 0}};
    const std::vector<float> values{1.0f, 2.0f, 5.0f};
    const std::vector<float> blurred = PointBlur(points, std::vector<float>(3, 1.0f), 3.0)(values);
    EXPECT_EQ(blurred[1], 2.0f) << "2.5 deviations are 7.5 mm";
    EXPECT_GT(blurred[0], 1.1f);
}

TEST(PointBlur, BadPointsKeepTheirOwnAndDisturbNone) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<glm::vec3> points{{0, 0, 0}, {nan, 0, 0}, {0, 1e30f, 0}, {0, 0, 0.5f}, {0.2f, 0, 0}};
    const std::vector<float> weights{1.0f, 1.0f, 1.0f, 0.0f, nan}, values{1.0f, 2.0f, 3.0f, 4.0f, 5.0f};
    EXPECT_EQ(PointBlur(points, weights, 1.0)(values), values);
    EXPECT_TRUE(PointBlur({}, {}, 1.0)({}).empty());
}

}  // namespace
}  // namespace lapfx::bleeding
