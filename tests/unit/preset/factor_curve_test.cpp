#include "preset/factor_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lapfx {
namespace {

using Points = std::vector<CurvePoint>;
const Points hill{{1.0, 0.5}, {2.0, 2.0}, {4.0, 0.0}};

TEST(FactorCurve, IsOneWithoutPoints) {
    const FactorCurve even;
    EXPECT_TRUE(even.even());
    EXPECT_EQ(even.at(-3.0), 1.0);
    EXPECT_EQ(even.integral(2.0, 5.0), 3.0);
    EXPECT_EQ(even.slope_after(1.0), 0.0);
    EXPECT_EQ(curve_at({}, 7.0), 1.0);
}

TEST(FactorCurve, IsStraightBetweenPointsAndLevelBeyond) {
    const FactorCurve curve(hill);
    const std::pair<double, double> expected[] = {{-5.0, 0.5}, {1.0, 0.5}, {1.5, 1.25}, {2.0, 2.0},
                                                  {3.0, 1.0},  {4.0, 0.0}, {99.0, 0.0}};
    for (const auto& [time, value] : expected) {
        EXPECT_DOUBLE_EQ(curve.at(time), value) << time;
        EXPECT_DOUBLE_EQ(curve_at(hill, time), value) << time;
    }
    EXPECT_EQ(curve.slope_after(0.0), 0.0);
    EXPECT_EQ(curve.slope_after(1.0), 1.5);
    EXPECT_EQ(curve.slope_after(2.0), -1.0);
    EXPECT_EQ(curve.slope_after(4.0), 0.0);
}

TEST(FactorCurve, IntegralIsTheAreaBelow) {
    const FactorCurve curve(hill);
    EXPECT_DOUBLE_EQ(curve.integral(0.0, 1.0), 0.5);
    EXPECT_DOUBLE_EQ(curve.integral(1.0, 2.0), 1.25);
    EXPECT_DOUBLE_EQ(curve.integral(0.0, 10.0), 0.5 + 1.25 + 2.0);
    EXPECT_DOUBLE_EQ(curve.integral(1.5, 3.0), 0.5 * 0.5 * (1.25 + 2.0) + 1.5);
    EXPECT_EQ(curve.integral(5.0, 9.0), 0.0);
}

TEST(FactorCurve, LeavesOutWhatCannotBe) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const Points bad{{1.0, 1.0}, {nan, 3.0}, {2.0, -1.0}, {0.5, 9.0}, {1.0, 9.0}, {2.0, nan}, {3.0, 3.0}};
    const FactorCurve curve(bad, 2.5);
    ASSERT_EQ(curve.points().size(), 2u);
    EXPECT_EQ(curve.points()[1], (CurvePoint{3.0, 2.5})) << "and what is too high counts as the highest";
    EXPECT_EQ(curve_at(bad, 2.0), 2.0);
    EXPECT_EQ(curve_at(Points{{nan, 2.0}}, 2.0), 1.0);
}

TEST(FactorCurve, KnowsItsPointsBetweenTwoTimes) {
    const FactorCurve curve(hill);
    EXPECT_EQ(curve.between(1.0, 4.0).size(), 1u) << "neither end";
    EXPECT_EQ(curve.between(0.0, 9.0).size(), 3u);
    EXPECT_TRUE(curve.between(5.0, 9.0).empty());
}

}  // namespace
}  // namespace lapfx
