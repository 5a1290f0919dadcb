#include "bleeding/wound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lapfx::bleeding {
namespace {

BleedingParameters venous() {
    BleedingParameters b;
    b.speed = 4.0;
    b.max_extent = 16.0;
    b.coagulation_time = 1.5;
    b.pulse_rate = b.pulse_strength = 0.0;
    return b;
}

TEST(Wound, GrowsWithSpeedTimesStrengthFromItsStart) {
    const Wound wound{.start = 2.0, .strength = 0.5};
    const BleedingParameters b = venous();
    EXPECT_EQ(source_value(wound, b, 0.0), 0.0);
    EXPECT_EQ(source_value(wound, b, 2.0), 0.0);
    EXPECT_DOUBLE_EQ(source_value(wound, b, 3.0), 2.0);
    EXPECT_DOUBLE_EQ(source_value(wound, b, 5.25), 6.5);
}

TEST(Wound, NeverBeyondMaxExtent) {
    const Wound wound{.start = 1.0};
    const BleedingParameters b = venous();
    EXPECT_DOUBLE_EQ(source_value(wound, b, 5.0), 16.0);
    EXPECT_DOUBLE_EQ(source_value(wound, b, 1e6), 16.0);
    EXPECT_TRUE(bleeds(wound, b, 4.99));
    EXPECT_FALSE(bleeds(wound, b, 5.01));
    EXPECT_FALSE(bleeds(wound, b, 0.5));
}

TEST(Wound, PulseKeepsTheMean) {
    BleedingParameters b = venous();
    b.max_extent = 200.0;
    const Wound wound{.start = 0.5};
    b.pulse_rate = 1.25;
    b.pulse_strength = 0.6;
    for (int beat = 1; beat <= 8; ++beat) {
        const double elapsed = beat / b.pulse_rate;
        EXPECT_NEAR(source_value(wound, b, 0.5 + elapsed), b.speed * elapsed, 1e-9) << beat;
    }
    // Between beats it runs ahead by the integral of strength * sin.
    const double ahead = b.pulse_strength / (std::numbers::pi * b.pulse_rate);
    EXPECT_NEAR(source_value(wound, b, 0.5 + 0.4), b.speed * (0.4 + ahead), 1e-9);
}

TEST(Wound, APulseOfStrengthOneStopsBetweenBeatsButNeverRunsBack) {
    BleedingParameters b = venous();
    b.max_extent = 200.0;
    b.pulse_rate = 1.0;
    b.pulse_strength = 1.0;
    double before = 0.0;
    for (int i = 1; i <= 400; ++i) {
        const double value = source_value({}, b, i * 0.01);
        EXPECT_GE(value, before - 1e-12) << i;
        before = value;
    }
    EXPECT_NEAR(source_value({}, b, 0.76) - source_value({}, b, 0.74), 0.0, 1e-3) << "the flow stands at 3/4 of a beat";
}

TEST(Wound, CoagulationDiesDownLinearly) {
    const BleedingParameters b = venous();
    const Wound wound{.start = 0.0, .stop = 1.0};
    const auto speed_at = [&](double t) {
        return (source_value(wound, b, t + 1e-4) - source_value(wound, b, t - 1e-4)) / 2e-4;
    };
    EXPECT_NEAR(speed_at(0.5), 4.0, 1e-6);
    EXPECT_NEAR(speed_at(1.0 + 0.375), 3.0, 1e-6);
    EXPECT_NEAR(speed_at(1.0 + 0.75), 2.0, 1e-6);
    EXPECT_NEAR(speed_at(1.0 + 1.125), 1.0, 1e-6);
    EXPECT_NEAR(speed_at(3.0), 0.0, 1e-6);
    EXPECT_DOUBLE_EQ(source_value(wound, b, 2.5), 4.0 + 4.0 * 0.75) << "half of the dying time counts";
    EXPECT_DOUBLE_EQ(source_value(wound, b, 100.0), 7.0);
    EXPECT_TRUE(bleeds(wound, b, 2.4));
    EXPECT_FALSE(bleeds(wound, b, 2.6));
}

TEST(Wound, WithoutCoagulationTimeItStopsAtOnce) {
    BleedingParameters b = venous();
    b.coagulation_time = 0.0;
    const Wound wound{.start = 0.0, .stop = 1.0};
    EXPECT_DOUBLE_EQ(source_value(wound, b, 1.0), 4.0);
    EXPECT_DOUBLE_EQ(source_value(wound, b, 9.0), 4.0);
    EXPECT_FALSE(bleeds(wound, b, 1.1));
}

TEST(Wound, ClosedBeforeItOpensNeverBleeds) {
    const Wound wound{.start = 2.0, .stop = 1.5};
    EXPECT_EQ(source_value(wound, venous(), 10.0), 0.0);
    EXPECT_FALSE(bleeds(wound, venous(), 2.5));
}

TEST(Wound, NoSpeedOrNoStrengthNeverBleeds) {
    BleedingParameters b = venous();
    EXPECT_EQ(source_value({.strength = 0.0}, b, 10.0), 0.0);
    EXPECT_FALSE(bleeds({.strength = 0.0}, b, 1.0));
    b.speed = 0.0;
    EXPECT_EQ(source_value({}, b, 10.0), 0.0);
    EXPECT_FALSE(bleeds({}, b, 1.0));
}

}  // namespace
}  // namespace lapfx::bleeding
