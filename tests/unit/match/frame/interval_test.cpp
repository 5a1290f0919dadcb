#include "match/frame/interval.h"

#include <gtest/gtest.h>

#include "match/frame/estimator.h"

namespace lapfx::match {
namespace {

FrameAmounts amounts_of(double blood, double smoke, unsigned flags = 0) {
    FrameAmounts a;
    a.blood.value = blood, a.veil.value = smoke, a.flags = flags, a.likeness = 1.0;
    set_intervals(a);
    return a;
}

double width(const Amount& amount) {
    return amount.high - amount.low;
}

TEST(Interval, IsWiderWhereTheFrameIsHarderToRead) {
    const FrameAmounts plain = amounts_of(0.3, 0.4);
    for (const unsigned flag : {told::tinted, told::bleached, told::motion}) {
        const FrameAmounts spoiled = amounts_of(0.3, 0.4, flag);
        EXPECT_GT(width(spoiled.blood), 1.2 * width(plain.blood)) << flag;
        EXPECT_GT(width(spoiled.veil), 1.2 * width(plain.veil)) << flag;
        EXPECT_LE(spoiled.veil.low, 0.4);
        EXPECT_GE(spoiled.veil.high, 0.4);
    }
    EXPECT_EQ(width(amounts_of(0.3, 0.4, told::cut).veil), width(plain.veil));
    EXPECT_EQ(width(amounts_of(0.3, 0.4, told::dark).veil), 1);
}

TEST(Interval, OfAVeilIsWidestInTheMiddle) {
    const double clear = amounts_of(0, 0).veil.high, half = width(amounts_of(0, 0.5).veil) / 2.0,
                 dense = 0.9 - amounts_of(0, 0.9).veil.low;
    EXPECT_NEAR(clear, 0.018, 1e-9);
    EXPECT_NEAR(half - clear, 0.34 * 0.25, 1e-9);
    EXPECT_NEAR(dense - clear, 0.34 * 0.09, 1e-9);
}

TEST(Interval, OfAPlumeIsWiderUpwardsSinceDenseOnesAreToldTooThin) {
    Amount plume{.value = 0.02};
    set_plume_interval(plume);
    EXPECT_NEAR(plume.low, 0.02 - 0.3 * 0.02 - 0.004, 1e-9);
    EXPECT_NEAR(plume.high, 0.02 + 0.8 * 0.02 + 0.004, 1e-9);
    plume = {};
    set_plume_interval(plume);
    EXPECT_EQ(plume.low, 0.0);
}

TEST(Interval, OfBloodIsWiderUpwardsBehindSmokeWhichMakesNone) {
    const FrameAmounts clear = amounts_of(0.3, 0.0), hazy = amounts_of(0.3, 0.25);
    EXPECT_NEAR(clear.blood.high - 0.3, 0.01 + 0.28 * 0.3, 1e-9);
    EXPECT_NEAR(hazy.blood.high - clear.blood.high, 0.28 * 0.25, 1e-9);
    EXPECT_EQ(hazy.blood.low, clear.blood.low);
    FrameAmounts a = clear;
    a.hidden = 0.2;
    set_intervals(a);
    EXPECT_NEAR(a.blood.high - clear.blood.high, 0.1 * 0.2, 1e-9);
    EXPECT_EQ(a.blood.low, clear.blood.low);
}

TEST(Interval, GrowsWithWhatIsLeftUnexplained) {
    FrameAmounts a = amounts_of(0.5, 0.5);
    const FrameAmounts plain = a;
    a.rest = 0.16;
    set_intervals(a);
    EXPECT_NEAR(width(a.veil) - width(plain.veil), 2 * 0.25 * 0.16, 1e-9);
    EXPECT_NEAR(width(a.blood) - width(plain.blood), 2 * 0.05 * 0.16, 1e-9);
}

TEST(Interval, OfBloodGrowsTheLessTheBaselineIsAlike) {
    FrameAmounts a = amounts_of(0.1, 0.3);
    const FrameAmounts plain = a;
    for (const double likeness : {0.9, 0.8, 0.7, 0.2}) {
        a.likeness = likeness;
        set_intervals(a);
        EXPECT_NEAR(a.blood.high - plain.blood.high, 0.1 * std::max(0.8 - likeness, 0.0), 1e-9) << likeness;
        EXPECT_EQ(width(a.veil), width(plain.veil));
    }
}

TEST(Interval, OfBloodHoldsNoneWhereTheTissueIsHardlyThere) {
    FrameAmounts a = amounts_of(0.4, 0.0);
    EXPECT_GT(a.blood.low, 0.25);
    a.likeness = 0.65;
    set_intervals(a);
    EXPECT_NEAR(a.blood.low, 0.2, 1e-9) << "half of it may be false";
    for (const double likeness : {0.5, 0.2}) {
        a.likeness = likeness;
        set_intervals(a);
        EXPECT_EQ(a.blood.low, 0.0);
        EXPECT_NEAR(a.blood.high, 0.8, 1e-9);
    }
}

AddedLight added(double gain, double light) {
    return {.light = light, .gain = gain, .of_bright_smoke = gain, .of_dim_smoke = gain, .tissue = 0.15, .known = true};
}

FrameAmounts with(const AddedLight& found, unsigned flags = 0) {
    FrameAmounts a = amounts_of(0, 0, flags);
    set_camera_intervals(a, found);
    return a;
}

TEST(Interval, OfAGainIsNarrowWhereLightExplainsIt) {
    EXPECT_NEAR(width(with(added(1.0, 0.0)).gain), 2 * 0.02, 1e-9);
    const double answer = 1.0 / (1.0 + 0.7 * 0.15 / 0.15);
    EXPECT_NEAR(with(added(0.6, 0.15)).gain.high, answer + 0.14, 1e-9);
    EXPECT_NEAR(with(added(0.6, 0.15)).gain.low, 0.6 - 0.02 * 0.6, 1e-9);
    EXPECT_EQ(with(added(0.6, 0.0)).gain.high, 1.0) << "a veil without light of its own is as dark";
    EXPECT_NEAR(with(added(1.5, 0.0)).gain.high, 1.53, 1e-9) << "no veil makes a picture brighter";
}

TEST(Interval, OfAGainHoldsWhatTheSmokeBeforeTheLeastLitPlacesMayBe) {
    AddedLight found = added(1.0, 0.05);
    found.of_bright_smoke = 0.8, found.of_dim_smoke = 1.3;
    EXPECT_NEAR(with(found).gain.low, 0.78, 1e-9);
    EXPECT_NEAR(with(found).gain.high, 1.32, 1e-9);
}

TEST(Interval, OfAddedLightGrowsWithItAndWithTheDoubtAboutTheGain) {
    const double none = width(with(added(1.0, 0.2)).light) - width(with(added(1.0, 0.1)).light);
    EXPECT_NEAR(none, 2 * 0.25 * 0.1, 1e-9);
    AddedLight apart = added(1.0, 0.2);
    apart.spread = 0.2;
    EXPECT_NEAR(width(with(apart).light) - width(with(added(1.0, 0.2)).light), 2 * 0.5 * 0.5 * 0.2 * 0.15, 1e-9);
    EXPECT_GT(width(with(apart, told::motion).light), 1.2 * width(with(apart).light));
}

TEST(Interval, OfWhatIsNotKnownHoldsEverything) {
    for (const FrameAmounts& a : {with(added(0.7, 0.1), told::bag), with(AddedLight{})}) {
        EXPECT_EQ(a.gain.value, 1.0);
        EXPECT_EQ(a.gain.low, least_gain);
        EXPECT_EQ(a.gain.high, most_gain);
        EXPECT_EQ(a.light.value, 0.0);
        EXPECT_EQ(a.light.low, 0.0);
        EXPECT_EQ(a.light.high, 1.0);
    }
}

}  // namespace
}  // namespace lapfx::match
