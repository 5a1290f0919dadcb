#include "ui/canvas/curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace lapfx::ui {
namespace {

using enum CurveHandle;

TEST(Curve, BeginsAsTheStraightLine) {
    const Curve curve;
    for (double x = 0; x <= 1; x += 0.125) EXPECT_DOUBLE_EQ(curve.evaluate(x), x);
    EXPECT_EQ(curve.evaluate(-3), 0);
    EXPECT_EQ(curve.evaluate(7), 1);
    EXPECT_EQ(curve.evaluate(std::numeric_limits<double>::quiet_NaN()), 0);
}

TEST(Curve, TheSPresetIsTheCubic) {
    const Curve s = Curve::preset(CurvePreset::s);
    for (double x = 0; x <= 1; x += 0.0625) EXPECT_NEAR(s.evaluate(x), x * x * (3 - 2 * x), 1e-15);
}

TEST(Curve, TheEasePresetIsTheParabola) {
    const Curve ease = Curve::preset(CurvePreset::ease);
    for (double x = 0; x <= 1; x += 0.0625) EXPECT_NEAR(ease.evaluate(x), 1 - (1 - x) * (1 - x), 1e-15);
}

TEST(Curve, AStepKeepsItsValueUntilTheNextPoint) {
    const Curve step = Curve::preset(CurvePreset::step);
    EXPECT_EQ(step.evaluate(0.499999), 0);
    EXPECT_EQ(step.evaluate(0.5), 1);
    EXPECT_EQ(step.evaluate(0.9), 1);
}

TEST(Curve, ThePulseRisesAndFallsAlike) {
    const Curve pulse = Curve::preset(CurvePreset::pulse);
    EXPECT_EQ(pulse.evaluate(0.5), 1);
    EXPECT_EQ(pulse.evaluate(1), 0);
    for (double x = 0; x <= 0.5; x += 0.05) EXPECT_NEAR(pulse.evaluate(x), pulse.evaluate(1 - x), 1e-15);
}

TEST(Curve, FreeSlopesMakeAnyCubicExact) {
    // y = x^3 - x over -1..2, slopes 3x^2 - 1
    const Curve curve({{-1, 0, free, 2, 2}, {0.5, -0.375, free, -0.25, -0.25}, {2, 6, free, 11, 11}});
    for (double x = -1; x <= 2; x += 0.1) EXPECT_NEAR(curve.evaluate(x), x * x * x - x, 1e-14);
}

TEST(Curve, AutomaticPointsOnAParabolaWithEvenStepsHaveItsSlope) {
    const Curve curve({{0, 0}, {1, 1}, {2, 4}, {3, 9}});
    EXPECT_DOUBLE_EQ(curve.slope_in(1), 2);
    EXPECT_DOUBLE_EQ(curve.slope_out(2), 4);
    EXPECT_NEAR(curve.evaluate(1.5), 2.25, 1e-15);
    EXPECT_DOUBLE_EQ(curve.slope_out(0), 1) << "at an end: the way to its neighbour";
}

TEST(Curve, BothSlopesOfAFreePointAreItsOwn) {
    const Curve curve({{0, 0, linear}, {1, 1, free, -1, 2}, {2, 0, linear}});
    EXPECT_EQ(curve.slope_in(1), -1);
    EXPECT_EQ(curve.slope_out(1), 2);
    const double h = 1e-6;
    EXPECT_NEAR((curve.evaluate(1) - curve.evaluate(1 - h)) / h, -1, 1e-4);
    EXPECT_NEAR((curve.evaluate(1 + h) - curve.evaluate(1)) / h, 2, 1e-4);
}

TEST(Curve, GoesThroughItsPointsAndIsContinuous) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> value(-2, 2);
    for (int k = 0; k < 300; ++k) {
        std::vector<CurvePoint> points;
        double x = value(random);
        for (int i = 0; i < 6; ++i) {
            const auto handle = static_cast<CurveHandle>(random() % 3);  // all but step
            points.push_back({x, value(random), handle, value(random), value(random)});
            x += 0.05 + std::abs(value(random));
        }
        const Curve curve(points, k % 2 == 0);
        for (const CurvePoint& p : points) {
            EXPECT_DOUBLE_EQ(curve.evaluate(p.x), p.y);
            EXPECT_NEAR(curve.evaluate(p.x - 1e-9), p.y, 1e-5);
            EXPECT_NEAR(curve.evaluate(p.x + 1e-9), p.y, 1e-5);
        }
    }
}

TEST(Curve, MonotoneNeverLeavesWhatLiesBetweenTwoPoints) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> value(-1, 1);
    int overshoots = 0;
    for (int k = 0; k < 1000; ++k) {
        std::vector<CurvePoint> points;
        double x = 0;
        for (int i = 0; i < 5; ++i) {
            points.push_back({x, i == 3 ? points.back().y : value(random), i % 2 == 0 ? automatic : free,
                              20 * value(random), 20 * value(random)});
            x += 0.01 + std::abs(value(random));
        }
        const Curve curve(points, true), loose(points);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const double low = std::min(points[i].y, points[i + 1].y), high = std::max(points[i].y, points[i + 1].y);
            double before = points[i].y;
            const double way = points[i + 1].y - points[i].y;
            for (int part = 1; part <= 40; ++part) {
                const double at = std::min(points[i + 1].x, points[i].x + (points[i + 1].x - points[i].x) * part / 40);
                const double y = curve.evaluate(at);
                ASSERT_GE(y, low - 1e-12);
                ASSERT_LE(y, high + 1e-12);
                ASSERT_GE((y - before) * way, -1e-12) << "turns back";
                before = y;
                overshoots += loose.evaluate(at) > high + 1e-6 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(overshoots, 100) << "else the test shows nothing";
}

TEST(Curve, MonotoneKeepsAutomaticPointsSmooth) {
    const Curve curve({{0, 0}, {1, 0.01}, {1.1, 5}, {4, 5.2}, {5, 3}}, true);
    for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(curve.slope_in(i), curve.slope_out(i));
    EXPECT_EQ(curve.slope_in(3), 0) << "a summit is flat";
    EXPECT_GT(curve.slope_in(1), 0);
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

TEST(Curve, ComesBackFromItsArray) {
    const Curve curve({{0, 1, step}, {2, 0.1, free, -3, 4}, {3, 7, linear}, {4, 1}}, true);
    const auto back = Curve::from_array(curve.to_array(), true);
    ASSERT_TRUE(back);
    EXPECT_EQ(*back, curve);
    EXPECT_EQ(back->evaluate(2.3), curve.evaluate(2.3));
}

TEST(Curve, ArraysThatAreNoCurveAreRefused) {
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(Curve::from_array({}));
    EXPECT_FALSE(Curve::from_array(std::vector<double>{0, 0, 0, 0}));
    EXPECT_FALSE(Curve::from_array(std::vector<double>{0, 0, 4, 0, 0}));
    EXPECT_FALSE(Curve::from_array(std::vector<double>{0, 0, 0.5, 0, 0}));
    EXPECT_FALSE(Curve::from_array(std::vector<double>{0, infinity, 0, 0, 0}));
    EXPECT_FALSE(Curve::from_array(std::vector<double>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0})) << "x must ascend";
    EXPECT_TRUE(Curve::from_array(std::vector<double>{1, 0, 0, 0, 0, 2, 0, 3, 0, 0}));
}

TEST(Curve, MadeFreeItKeepsItsShape) {
    Curve curve({{0, 0}, {1, 3}, {2, 1}, {3, 1}});
    const double before = curve.evaluate(1.3);
    curve.make_free(1);
    curve.make_free(2);
    EXPECT_EQ(curve.point(1).handle, free);
    EXPECT_DOUBLE_EQ(curve.evaluate(1.3), before);
}

}  // namespace
}  // namespace lapfx::ui
