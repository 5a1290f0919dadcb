#include "ui/canvas/curve.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace lapfx::ui {
namespace {

TEST(Curve, BeginsAsTheStraightLine) {
    const Curve curve;
    for (double x = 0; x <= 1; x += 0.125) EXPECT_DOUBLE_EQ(curve.evaluate(x), x);
    EXPECT_EQ(curve.evaluate(-3), 0);
    EXPECT_EQ(curve.evaluate(7), 1);
    EXPECT_EQ(curve.evaluate(std::numeric_limits<double>::quiet_NaN()), 0);
}

TEST(Curve, GoesStraightFromPointToPoint) {
    const Curve curve({{-1, 4}, {1, 0}, {2, 3}});
    EXPECT_DOUBLE_EQ(curve.evaluate(-0.5), 3);
    EXPECT_DOUBLE_EQ(curve.evaluate(0.5), 1);
    EXPECT_DOUBLE_EQ(curve.evaluate(1.25), 0.75);
}

TEST(Curve, GoesThroughItsPointsAndIsContinuous) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> value(-2, 2);
    for (int k = 0; k < 300; ++k) {
        std::vector<CurvePoint> points;
        double x = value(random);
        for (int i = 0; i < 6; ++i) {
            points.push_back({x, value(random)});
            x += 0.05 + std::abs(value(random));
        }
        const Curve curve(points);
        for (const CurvePoint& p : points) {
            EXPECT_DOUBLE_EQ(curve.evaluate(p.x), p.y);
            EXPECT_NEAR(curve.evaluate(p.x - 1e-9), p.y, 1e-5);
            EXPECT_NEAR(curve.evaluate(p.x + 1e-9), p.y, 1e-5);
        }
    }
}

TEST(Curve, InsertsInOrderAndRefusesASecondPointAtOnePlace) {
    Curve curve;
    EXPECT_EQ(curve.insert(0.5, 3), 1U);
    EXPECT_EQ(curve.insert(-1, 3), 0U);
    EXPECT_EQ(curve.insert(9, 3), 4U);
    EXPECT_FALSE(curve.insert(0.5, 1));
    EXPECT_FALSE(curve.insert(std::numeric_limits<double>::quiet_NaN(), 1));
    EXPECT_FALSE(curve.insert(0.7, std::numeric_limits<double>::infinity()));
    EXPECT_EQ(curve.size(), 5U);
    EXPECT_EQ(curve.evaluate(0.5), 3);
}

TEST(Curve, TheLastPointCannotBeErased) {
    Curve curve;
    curve.erase(0);
    EXPECT_EQ(curve.size(), 1U);
    EXPECT_EQ(curve.evaluate(0.2), 1);
    curve.erase(0);
    EXPECT_EQ(curve.size(), 1U);
}

TEST(Curve, PointsThatAreNoCurveAreNotValid) {
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(Curve::valid({}));
    EXPECT_FALSE(Curve::valid(std::vector<CurvePoint>{{0, infinity}}));
    EXPECT_FALSE(Curve::valid(std::vector<CurvePoint>{{1, 0}, {1, 0}})) << "x must ascend";
    EXPECT_TRUE(Curve::valid(std::vector<CurvePoint>{{1, 0}, {2, 0}}));
}

}  // namespace
}  // namespace lapfx::ui
