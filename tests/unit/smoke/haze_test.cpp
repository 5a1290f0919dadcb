#include "smoke/haze_cpu.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lapfx::smoke {
namespace {

HazeParameters haze(double accumulation, double ventilation) {
    HazeParameters parameters;
    parameters.accumulation = accumulation;
    parameters.ventilation = ventilation;
    return parameters;
}

/// dE/dt = accumulation * power - ventilation * E by the midpoint rule, in steps that meet every start and end.
double integrated(const std::vector<Emission>& emissions, const HazeParameters& h, double time) {
    constexpr double step = 1.0 / 4096.0;
    double density = 0.0;
    for (double t = 0.0; t < time - step / 2.0; t += step) {
        double power = 0.0;
        for (const Emission& e : emissions)
            if (t >= e.start && t < e.end) power += e.power;
        const auto slope = [&](double value) { return h.accumulation * power - h.ventilation * value; };
        density += step * slope(density + 0.5 * step * slope(density));
    }
    return density;
}

TEST(Haze, SolvesItsDifferentialEquation) {
    const std::vector<Emission> emissions{{1.0, 3.0, 1.0}, {2.0, 5.5, 0.4}, {8.0, 8.25, 0.75}};
    for (const auto& parameters : {haze(0.12, 0.05), haze(1.5, 2.0), haze(0.7, 0.0)})
        for (const double time : {0.5, 1.0, 2.0, 2.5, 4.0, 8.0, 8.125, 12.0})
            EXPECT_NEAR(haze_density(emissions, parameters, time), integrated(emissions, parameters, time), 1e-6)
                << parameters.ventilation << " at " << time;
}

TEST(Haze, NothingBeforeAnyEmission) {
    EXPECT_EQ(haze_density({}, haze(1, 1), 5.0), 0.0);
    const std::vector<Emission> one{{2.0, 3.0, 1.0}};
    EXPECT_EQ(haze_density(one, haze(1, 1), 2.0), 0.0);
}

TEST(Haze, GrowsTowardsTheBalanceOfSupplyAndVentilation) {
    const std::vector<Emission> one{{0.0, 1e9, 0.5}};
    EXPECT_NEAR(haze_density(one, haze(0.6, 0.2), 200.0), 0.6 * 0.5 / 0.2, 1e-9);
    EXPECT_NEAR(haze_density(one, haze(0.6, 0.2), 5.0), 1.5 * (1.0 - std::exp(-1.0)), 1e-12);
}

TEST(Haze, DecaysByVentilationWhenTheToolStops) {
    const std::vector<Emission> one{{0.0, 2.0, 1.0}};
    const HazeParameters h = haze(0.5, 0.25);
    EXPECT_NEAR(haze_density(one, h, 6.0), haze_density(one, h, 2.0) * std::exp(-1.0), 1e-12);
}

TEST(Haze, VentilationZeroKeepsTheSumAndIsTheLimitOfSmallOnes) {
    const std::vector<Emission> two{{1.0, 3.0, 1.0}, {2.0, 4.0, 0.5}};
    EXPECT_DOUBLE_EQ(haze_density(two, haze(0.1, 0.0), 100.0), 0.1 * (2.0 + 1.0));
    for (const double ventilation : {1e-13, 1e-10, 1.1e-9, 1e-8})
        EXPECT_NEAR(haze_density(two, haze(0.1, ventilation), 100.0), 0.3, 1e-6) << ventilation;
}

TEST(Haze, OverlappingEmissionsAdd) {
    const HazeParameters h = haze(0.3, 0.1);
    const std::vector<Emission> first{{0.0, 4.0, 1.0}}, second{{2.0, 3.0, 0.6}}, both{first[0], second[0]};
    EXPECT_NEAR(haze_density(both, h, 5.0), haze_density(first, h, 5.0) + haze_density(second, h, 5.0), 1e-12);
}

TEST(Haze, AnEmissionWithoutDurationOrPowerGivesNone) {
    const std::vector<Emission> none{{1.0, 1.0, 1.0}, {3.0, 2.0, 1.0}, {0.0, 9.0, 0.0}};
    EXPECT_EQ(haze_density(none, haze(1, 1), 10.0), 0.0);
}

}  // namespace
}  // namespace lapfx::smoke
