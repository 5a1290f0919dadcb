#include "smoke/haze.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace lapfx::smoke {
namespace {

using Emissions = std::vector<Emission>;
using Suctions = std::vector<Suction>;

HazeParameters haze(double accumulation, double ventilation, double suction = 0.0) {
    HazeParameters parameters;
    parameters.accumulation = accumulation;
    parameters.ventilation = ventilation;
    parameters.suction = suction;
    return parameters;
}

void set(HazeCurve& curve, const Emissions& emissions, const Suctions& suctions, const HazeParameters& h,
         const FactorCurve& factor = {}) {
    curve.set_parameters(h);
    curve.set_factor(factor);
    curve.set(emissions, suctions);
}

double density(const Emissions& emissions, const HazeParameters& h, double time, const Suctions& suctions = {}) {
    HazeCurve curve;
    set(curve, emissions, suctions, h);
    return curve.density(time);
}

/// The equation by the midpoint rule, in steps that meet every start and end.
double integrated(const Emissions& emissions, const Suctions& suctions, const HazeParameters& h, double time) {
    constexpr double step = 1.0 / 4096.0;
    double value = 0.0;
    for (double t = 0.0; t < time - step / 2.0; t += step) {
        double power = 0.0, loss = h.ventilation;
        for (const Emission& e : emissions)
            if (t >= e.start && t < e.end) power += e.power;
        if (std::any_of(suctions.begin(), suctions.end(), [&](const Suction& s) { return t >= s.start && t < s.end; }))
            loss += h.suction;
        const auto slope = [&](double at) { return h.accumulation * power - loss * at; };
        value += step * slope(value + 0.5 * step * slope(value));
    }
    return value;
}

const Emissions three{{1.0, 3.0, 1.0}, {2.0, 5.5, 0.4}, {8.0, 8.25, 0.75}};
const Suctions two_suctions{{2.5, 4.0}, {3.5, 6.0}};
constexpr double times[] = {0.5, 1.0, 2.0, 2.5, 3.75, 4.0, 6.0, 8.0, 8.125, 12.0};

TEST(Haze, SolvesItsDifferentialEquation) {
    for (const auto& parameters : {haze(0.12, 0.05), haze(1.5, 2.0), haze(0.7, 0.0)})
        for (const double time : times)
            EXPECT_NEAR(density(three, parameters, time), integrated(three, {}, parameters, time), 1e-6)
                << parameters.ventilation << " at " << time;
}

TEST(Haze, SolvesItWithSuctionAsWell) {
    for (const auto& parameters : {haze(0.12, 0.05, 0.6), haze(1.5, 2.0, 5.0), haze(0.7, 0.0, 1.0)})
        for (const double time : times)
            EXPECT_NEAR(density(three, parameters, time, two_suctions),
                        integrated(three, two_suctions, parameters, time), 2e-6)
                << parameters.suction << " at " << time;
}

TEST(Haze, SuctionTakesItsShareWhileItRuns) {
    const Emissions one{{0.0, 2.0, 1.0}};
    const HazeParameters h = haze(0.5, 0.25, 0.75);
    const double before = density(one, h, 3.0);
    EXPECT_NEAR(density(one, h, 5.0, {{3.0, 5.0}}), before * std::exp(-2.0), 1e-12);
    EXPECT_NEAR(density(one, h, 7.0, {{3.0, 5.0}}), before * std::exp(-2.5), 1e-12) << "ventilation goes on alone";
    EXPECT_EQ(density(one, h, 5.0, {{3.0, 5.0}, {3.5, 4.5}, {3.0, 5.0}}), density(one, h, 5.0, {{3.0, 5.0}}))
        << "a second tool in the same gas takes no more";
    EXPECT_EQ(density(one, h, 3.0, {{3.0, 5.0}}), before) << "nothing before it starts";
}

TEST(Haze, GoingOnFromAnyMomentGivesTheSame) {
    // The semigroup property: E at t depends only on E at any earlier time.
    const HazeParameters h = haze(0.3, 0.1, 0.8);
    const Emissions emissions{{0.0, 100.0, 0.7}};
    const Suctions suctions{{20.0, 40.0}};
    HazeCurve curve;
    set(curve, emissions, suctions, h);
    for (double t = 0.0; t < 60.0; t += 0.37) {
        const bool sucked = t >= 20.0 && t < 40.0;
        const double loss = sucked ? 0.9 : 0.1, dt = 0.01, balance = 0.3 * 0.7 / loss;
        if ((t < 20.0) != (t + dt < 20.0) || (t < 40.0) != (t + dt < 40.0)) continue;
        EXPECT_NEAR(curve.density(t + dt), balance + (curve.density(t) - balance) * std::exp(-loss * dt), 1e-12) << t;
    }
}

TEST(Haze, NothingBeforeAnyEmission) {
    EXPECT_EQ(density({}, haze(1, 1), 5.0), 0.0);
    EXPECT_EQ(HazeCurve().density(5.0), 0.0);
    EXPECT_EQ(density({{2.0, 3.0, 1.0}}, haze(1, 1), 2.0), 0.0);
    EXPECT_EQ(density({{2.0, 3.0, 1.0}}, haze(1, 1, 1), 1.5, {{0.0, 1.0}}), 0.0);
}

TEST(Haze, GrowsTowardsTheBalanceOfSupplyAndVentilation) {
    const Emissions one{{0.0, 1e9, 0.5}};
    EXPECT_NEAR(density(one, haze(0.6, 0.2), 200.0), 0.6 * 0.5 / 0.2, 1e-9);
    EXPECT_NEAR(density(one, haze(0.6, 0.2), 5.0), 1.5 * (1.0 - std::exp(-1.0)), 1e-12);
}

TEST(Haze, DecaysByVentilationWhenTheToolStops) {
    const Emissions one{{0.0, 2.0, 1.0}};
    const HazeParameters h = haze(0.5, 0.25);
    EXPECT_NEAR(density(one, h, 6.0), density(one, h, 2.0) * std::exp(-1.0), 1e-12);
}

TEST(Haze, VentilationZeroKeepsTheSumAndIsTheLimitOfSmallOnes) {
    const Emissions two{{1.0, 3.0, 1.0}, {2.0, 4.0, 0.5}};
    EXPECT_NEAR(density(two, haze(0.1, 0.0), 100.0), 0.1 * (2.0 + 1.0), 1e-15);
    for (const double ventilation : {1e-13, 1e-10, 1.1e-9, 1e-8})
        EXPECT_NEAR(density(two, haze(0.1, ventilation), 100.0), 0.3, 1e-6) << ventilation;
}

TEST(Haze, OverlappingEmissionsAdd) {
    const HazeParameters h = haze(0.3, 0.1);
    const Emissions first{{0.0, 4.0, 1.0}}, second{{2.0, 3.0, 0.6}}, both{first[0], second[0]};
    EXPECT_NEAR(density(both, h, 5.0), density(first, h, 5.0) + density(second, h, 5.0), 1e-12);
}

TEST(Haze, WhatCannotBeGivesNone) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    const Emissions none{{1.0, 1.0, 1.0}, {3.0, 2.0, 1.0},      {0.0, 9.0, 0.0},
                         {nan, 2.0, 1.0}, {1.0, infinity, 1.0}, {1.0, 2.0, nan}};
    EXPECT_EQ(density(none, haze(1, 1), 10.0), 0.0);
    const Emissions one{{0.0, 1.0, 1.0}};
    EXPECT_EQ(density(one, haze(1, 1, 1), 9.0, {{nan, 8.0}, {5.0, 4.0}, {2.0, infinity}}),
              density(one, haze(1, 1, 1), 9.0));
}

TEST(Haze, GrowingListsGiveTheSameToTheLastBitAsFreshOnes) {
    std::mt19937 random(11);
    const auto uniform = [&] { return static_cast<double>(random() % 1000) / 1000.0; };
    const HazeParameters h = haze(0.4, 0.07, 0.5);
    Emissions emissions;
    Suctions suctions;
    HazeCurve grown;
    grown.set_parameters(h);
    double now = 0.0;
    for (int step = 0; step < 400; ++step) {
        now += 0.03;
        switch (random() % 6) {
            case 0:
                emissions.push_back({now - 0.02, now, uniform()});
                break;
            case 1:
                suctions.push_back({now - 0.01, now});
                break;
            case 2:  // something in the past is taken back
                if (emissions.size() > 5)
                    emissions.erase(emissions.begin() + static_cast<std::ptrdiff_t>(random() % 5));
                break;
            case 3:
                if (!emissions.empty()) emissions[random() % emissions.size()].power = uniform();
                break;
            default:
                if (!emissions.empty()) emissions.back().end = now;
                if (!suctions.empty()) suctions.back().end = now;
        }
        grown.set(emissions, suctions);
        HazeCurve fresh;
        set(fresh, emissions, suctions, h);
        for (const double t : {now, 0.5 * now, now + 3.0, uniform() * now})
            ASSERT_EQ(grown.density(t), fresh.density(t)) << step << " at " << t;
    }
    set(grown, emissions, suctions, haze(0.8, 0.07, 0.5));
    EXPECT_NEAR(grown.density(now), 2.0 * density(emissions, h, now, suctions), 1e-12) << "parameters are live";
}

TEST(Haze, ALongOperationAddsUpWithoutDrift) {
    // 20,000 short contacts against the closed sum of each alone.
    Emissions emissions;
    const HazeParameters h = haze(0.12, 0.05);
    double expected = 0.0;
    const double end = 20'000 * 0.15;
    for (int i = 0; i < 20'000; ++i) {
        const double start = 0.15 * i;
        emissions.push_back({start, start + 0.2, 0.1 + 0.8 * ((i * 7) % 10) / 10.0});
        const double until = std::min(end, start + 0.2);
        expected +=
            0.12 * emissions.back().power * (std::exp(-0.05 * (end - until)) - std::exp(-0.05 * (end - start))) / 0.05;
    }
    EXPECT_NEAR(density(emissions, h, end), expected, 1e-9);
}

/// The equation by the midpoint rule, with a factor on the emissions.
double integrated_with(const FactorCurve& factor, const Emissions& emissions, const HazeParameters& h, double time) {
    constexpr double step = 1.0 / 8192.0;
    double value = 0.0;
    for (double t = 0.0; t < time - step / 2.0; t += step) {
        double power = 0.0;
        for (const Emission& e : emissions)
            if (t >= e.start && t < e.end) power += e.power;
        const double source = h.accumulation * power * factor.at(t + step / 2.0);
        value += step * (source - h.ventilation * (value + 0.5 * step * (source - h.ventilation * value)));
    }
    return value;
}

TEST(Haze, AFactorOverTimeIsExact) {
    const FactorCurve factor(std::vector<CurvePoint>{{0.5, 0.0}, {1.5, 2.0}, {2.25, 0.25}, {8.125, 3.0}});
    for (const auto& parameters : {haze(0.12, 0.05), haze(1.5, 2.0), haze(0.7, 0.0), haze(0.7, 1e-6)}) {
        HazeCurve curve;
        set(curve, three, {}, parameters, factor);
        for (const double time : times)
            EXPECT_NEAR(curve.density(time), integrated_with(factor, three, parameters, time), 1e-6)
                << parameters.ventilation << " at " << time;
    }
}

TEST(Haze, AFactorMayChangeAndGo) {
    HazeCurve curve;
    const HazeParameters h = haze(0.7, 0.3);
    set(curve, three, {}, h);
    const double plain = curve.density(4.0);
    set(curve, three, {}, h, FactorCurve(std::vector<CurvePoint>{{3.0, 1.5}}));
    EXPECT_NEAR(curve.density(4.0), 1.5 * plain, 1e-12);
    set(curve, three, {}, h, FactorCurve(std::vector<CurvePoint>{{0.0, 0.0}, {9.0, 0.0}}));
    EXPECT_EQ(curve.density(4.0), 0.0);
    set(curve, three, {}, h);
    EXPECT_EQ(curve.density(4.0), plain);
}

}  // namespace
}  // namespace lapfx::smoke
