// Wounds whose bleeding strength changes, compared with integrals by the midpoint rule.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bleeding/wound.h"

namespace lapfx::bleeding {
namespace {

const std::vector<CurvePoint> ups_and_downs{{1.0, 0.2}, {2.5, 1.8}, {3.0, 0.0}, {4.0, 0.0}, {6.0, 1.0}};

BleedingParameters bleeding(double pulse_rate, double pulse_strength) {
    BleedingParameters b;
    b.speed = 3.0;
    b.max_extent = 100.0;
    b.coagulation_time = 1.5;
    b.pulse_rate = pulse_rate;
    b.pulse_strength = pulse_strength;
    return b;
}

Strength strength_of(const BleedingParameters& b) {
    return Strength(FactorCurve(ups_and_downs), b);
}

/// mm by `time`, in small steps.
double integrated(const Wound& wound, const BleedingParameters& b, double time) {
    constexpr int steps = 200'000;
    const double step = (time - wound.start) / steps;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double t = wound.start + (i + 0.5) * step;
        const double pulse =
            1.0 + b.pulse_strength * std::sin(2.0 * std::numbers::pi * b.pulse_rate * (t - wound.start));
        const double flow = t < wound.stop ? pulse : std::max(0.0, 1.0 - (t - wound.stop) / b.coagulation_time);
        sum += step * curve_at(ups_and_downs, t) * flow;
    }
    return b.speed * wound.strength * sum;
}

TEST(Strength, FlowIsTheIntegralOfTheCurve) {
    for (const auto& b : {bleeding(0.0, 0.0), bleeding(1.25, 0.6), bleeding(0.05, 1.0), bleeding(4.0, 1.0)})
        for (const double start : {0.25, 1.7, 3.4})
            for (const double stop : {1e300, 5.1})
                for (const double elapsed : {0.1, 0.9, 2.3, 4.0, 9.0}) {
                    const Wound wound{.start = start, .strength = 0.8, .stop = stop};
                    const double time = start + elapsed;
                    EXPECT_NEAR(flow(wound, b, time, strength_of(b)), integrated(wound, b, time), 1e-4)
                        << start << ' ' << stop << ' ' << elapsed << ' ' << b.pulse_rate;
                }
}

TEST(Strength, AConstantCurveIsAFactorOnSpeed) {
    BleedingParameters b = bleeding(1.25, 0.6), twice = b;
    twice.speed *= 2.0;
    const std::vector<CurvePoint> two{{5.0, 2.0}, {8.0, 2.0}};
    const Strength strength(FactorCurve(two), b);
    const Wound wound{.start = 1.0, .stop = 6.0};
    for (double t = 0.0; t < 12.0; t += 0.37)
        EXPECT_NEAR(flow(wound, b, t, strength), flow(wound, twice, t), 1e-9) << t;
}

TEST(Strength, ZeroPausesAndNothingEverGoesBack) {
    const BleedingParameters b = bleeding(1.25, 1.0);
    const Strength strength = strength_of(b);
    const Wound wound{.start = 0.5};
    EXPECT_DOUBLE_EQ(flow(wound, b, 3.0, strength), flow(wound, b, 4.0, strength));
    EXPECT_FALSE(bleeds(wound, b, 3.5, strength));
    EXPECT_EQ(state_of(wound, b, 3.5, strength), WoundState::bleeding) << "open, and not yet at its largest";
    EXPECT_TRUE(bleeds(wound, b, 2.0, strength));
    double before = 0.0;
    for (double t = 0.0; t < 9.0; t += 0.01) {
        const double now = flow(wound, b, t, strength);
        EXPECT_GE(now, before - 1e-12) << t;
        before = now;
    }
    EXPECT_EQ(state_of(wound, b, 1e5, strength), WoundState::spent);
}

TEST(Strength, ClottingKeepsItsTime) {
    const BleedingParameters b = bleeding(0.0, 0.0);
    const Wound wound{.start = 0.5, .stop = 3.2};
    EXPECT_EQ(state_of(wound, b, 3.2 + 1.49, strength_of(b)), WoundState::clotting);
    EXPECT_EQ(state_of(wound, b, 3.2 + 1.51, strength_of(b)), WoundState::closed);
    EXPECT_DOUBLE_EQ(flow(wound, b, 4.75, strength_of(b)), flow(wound, b, 50.0, strength_of(b)));
}

}  // namespace
}  // namespace lapfx::bleeding
