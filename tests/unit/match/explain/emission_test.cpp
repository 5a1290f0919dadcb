// Haze that the core makes of known smoke, and the smoke found in it.
#include "match/explain/emission.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "smoke/haze.h"

namespace lapfx::match {
namespace {

struct Known {
    double accumulation = 0.2, ventilation = 0.15;
    std::vector<smoke::Emission> bursts = {{2.0, 5.0, 1.0}};
    std::vector<CurvePoint> factor = {};
    double noise = 0.0;
};

std::vector<HazePoint> points_of(const Known& known, double seconds = 14.0) {
    HazeParameters haze;
    haze.accumulation = known.accumulation, haze.ventilation = known.ventilation;
    smoke::HazeCurve curve;
    curve.set_parameters(haze);
    curve.set_factor(FactorCurve(known.factor));
    curve.set(known.bursts, {});
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 1.0);
    std::vector<HazePoint> points;
    for (double time = 0.0; time <= seconds; time += 0.04)
        points.push_back(
            {time, std::max(curve.density(time) + known.noise * noise(random), 0.0), std::max(known.noise, 0.01)});
    return points;
}

SmokeFound found_in(const Known& known, double usual = 0.05) {
    return smoke_of(points_of(known), usual);
}

TEST(Emission, OfOneBurstIsFound) {
    const SmokeFound found = found_in({});
    ASSERT_EQ(found.bursts.size(), 1U);
    EXPECT_NEAR(found.bursts[0].start, 2.0, 0.2);
    EXPECT_NEAR(found.bursts[0].end, 5.0, 0.2);
    EXPECT_NEAR(found.ventilation, 0.15, 0.02);
    EXPECT_NEAR(found.accumulation, 0.2, 0.02);
    EXPECT_TRUE(found.emission.empty()) << "it is even";
}

TEST(Emission, ExplainsTheHazeThatItWasFoundIn) {
    const std::vector<HazePoint> points = points_of({.bursts = {{1.0, 2.0, 1.0}, {6.0, 9.0, 0.5}}});
    const std::vector<Burst> bursts = smoke_of(points, 0.05).bursts;
    ASSERT_EQ(bursts.size(), 2U);
    EXPECT_NEAR(bursts[0].emission * (bursts[0].end - bursts[0].start), 0.2 * 1.0, 0.01);
    EXPECT_NEAR(bursts[1].emission * (bursts[1].end - bursts[1].start), 0.1 * 3.0, 0.015);
    const EmissionFound found = emission_within(points, emission_of(points, 0.05), bursts);
    for (const HazePoint& p : points) EXPECT_NEAR(found.density(p.time), p.density, 0.02) << p.time;
    EXPECT_LT(found.error, 1.0);
}

TEST(Emission, SurvivesNoise) {
    const SmokeFound found = found_in({.bursts = {{2.0, 5.0, 1.0}, {8.0, 10.0, 1.0}}, .noise = 0.02});
    ASSERT_EQ(found.bursts.size(), 2U);
    EXPECT_NEAR(found.bursts[1].start, 8.0, 0.4);
    EXPECT_NEAR(found.bursts[1].end, 10.0, 0.4);
    EXPECT_NEAR(found.accumulation, 0.2, 0.04);
    EXPECT_NEAR(found.ventilation, 0.15, 0.05);
}

TEST(Emission, ThatChangesWithinABurstIsACurve) {
    const SmokeFound found = found_in({.bursts = {{2.0, 8.0, 1.0}}, .factor = {{2.0, 0.2}, {8.0, 1.8}}});
    ASSERT_GE(found.emission.size(), 4U);
    EXPECT_LT(found.emission.front().value, 0.6);
    EXPECT_GT(found.emission.back().value, 1.4);
    for (std::size_t i = 1; i < found.emission.size(); ++i) {
        EXPECT_GT(found.emission[i].time, found.emission[i - 1].time);
        EXPECT_GE(found.emission[i].value, found.emission[i - 1].value - 0.1);
    }
}

TEST(Emission, HazeThatNeverFallsDoesNotTellTheVentilation) {
    const Known still{.ventilation = 0.0, .bursts = {{2.0, 14.0, 1.0}}};
    const EmissionFound found = emission_of(points_of(still), 0.07);
    EXPECT_FALSE(found.falls);
    EXPECT_EQ(found.ventilation, 0.07);
    EXPECT_LT(found.error, 1.0);
}

TEST(Emission, IsNotThereWithoutHaze) {
    EXPECT_TRUE(found_in({.accumulation = 0.0}).bursts.empty());
    EXPECT_TRUE(smoke_of({}, 0.05).bursts.empty());
    const HazePoint one{1.0, 0.5, 0.01};
    EXPECT_TRUE(smoke_of({&one, 1}, 0.05).bursts.empty());
}

TEST(Emission, IsNeverBelowNothing) {
    for (const double e : emission_of(points_of({.noise = 0.05}), 0.05).emission) EXPECT_GE(e, 0.0);
}

TEST(Emission, IsFoundAboveAHazyBaseline) {
    for (const double offset : {-0.03, 0.0, 0.03}) {
        std::vector<HazePoint> points = points_of({.noise = 0.02});
        for (HazePoint& point : points) point.density += offset;
        const SmokeFound found = smoke_above_offset(points, 0.05);
        EXPECT_NEAR(found.offset, offset, 0.016);
        ASSERT_EQ(found.bursts.size(), 1U) << offset;
        EXPECT_NEAR(found.bursts[0].start, 2.0, 0.3) << offset;
        EXPECT_NEAR(found.bursts[0].end, 5.0, 0.3) << offset;
        EXPECT_NEAR(found.accumulation, 0.2, 0.03) << offset;
        EXPECT_NEAR(found.ventilation, 0.15, 0.04) << offset;
    }
}

/// Half a second of dense smoke after nine of thin: its factor would be more than a scene may have.
TEST(Emission, AStrongPuffKeepsTheFactorAllowed) {
    const Known known{.accumulation = 0.03, .bursts = {{1.0, 10.0, 1.0}, {12.0, 12.6, 14.0}}};
    const SmokeFound found = found_in(known);
    ASSERT_EQ(found.bursts.size(), 2U);
    ASSERT_FALSE(found.emission.empty());
    double most = 0.0;
    for (const CurvePoint& point : found.emission) most = std::max(most, point.value);
    EXPECT_NEAR(most, 4.0, 1e-12);
    EXPECT_GT(found.accumulation * most, 0.2) << "the puff is as dense as it was";
    EXPECT_NEAR(found.accumulation * found.emission.front().value, 0.03, 0.015);
}

/// Nine seconds of a clear view before the first point do not make the offset certain.
TEST(Emission, AClearMomentLeavesTheOffset) {
    std::vector<HazePoint> points =
        points_of({.accumulation = 0.25, .bursts = {{8.0, 11.0, 1.0}}, .noise = 0.02}, 17.0);
    std::erase_if(points, [](const HazePoint& point) { return point.time < 5.0; });
    for (HazePoint& point : points) point.density += 0.045;
    const SmokeFound found = smoke_above_offset(points, 0.05, 3.0);
    EXPECT_NEAR(found.offset, 0.045, 0.016);
    ASSERT_EQ(found.bursts.size(), 1U);
    EXPECT_NEAR(found.bursts[0].start, 8.0, 0.3);
}

TEST(Emission, AHazyBaselineAloneIsNoSmoke) {
    std::vector<HazePoint> points;
    for (int i = 0; i < 100; ++i) points.push_back({0.1 * i, 0.03, 0.03});
    const SmokeFound found = smoke_above_offset(points, 0.05);
    EXPECT_TRUE(found.bursts.empty());
    EXPECT_GE(found.offset, 0.0);
    EXPECT_TRUE(smoke_above_offset({}, 0.05).bursts.empty());
}

}  // namespace
}  // namespace lapfx::match
