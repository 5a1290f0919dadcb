// The reference's amounts at the scene's times.
#include "match/fit/target.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lapfx::match {
namespace {

/// Blood grows by 0.01 a second, veil by 0.02; 25 frames a second.
std::vector<FrameAmounts> rising(double seconds) {
    std::vector<FrameAmounts> frames;
    for (int i = 0; i <= static_cast<int>(25.0 * seconds); ++i) {
        FrameAmounts& frame = frames.emplace_back();
        frame.time = i / 25.0;
        frame.blood = {0.01 * frame.time, 0.01 * frame.time - 0.005, 0.01 * frame.time + 0.005};
        frame.veil = {0.02 * frame.time, 0.0, 0.5};
    }
    return frames;
}

TEST(Target, IsTheMeanAroundEachTime) {
    const auto target = target_of(rising(10.0), {.from = 1.0, .to = 5.0, .step = 0.5});
    ASSERT_EQ(target.size(), 9U);
    for (std::size_t i = 0; i < target.size(); ++i) {
        EXPECT_NEAR(target[i].time, 1.0 + 0.5 * static_cast<double>(i), 1e-12);
        ASSERT_TRUE(target[i].blood && target[i].veil);
        EXPECT_NEAR(target[i].blood->value, 0.01 * target[i].time, 2e-4);
        EXPECT_NEAR(target[i].blood->high - target[i].blood->low, 0.01, 1e-9);
        EXPECT_NEAR(target[i].veil->value, 0.02 * target[i].time, 4e-4);
    }
}

TEST(Target, HasThePlumeWhereItIsTold) {
    auto frames = rising(10.0);
    for (FrameAmounts& frame : frames)
        if (frame.time < 3.05) frame.plume = Amount{0.01 * frame.time, 0.0, 0.1};
    for (const TargetPoint& aim : target_of(frames, {.from = 1.0, .to = 5.0, .step = 0.5})) {
        ASSERT_EQ(aim.plume.has_value(), aim.time < 3.1) << aim.time;
        if (aim.time < 2.6) {
            EXPECT_NEAR(aim.plume->value, 0.01 * aim.time, 2e-4);
        }
    }
}

TEST(Target, IsOffsetFromTheScene) {
    const auto target = target_of(rising(10.0), {.offset = 2.0, .from = 0.0, .to = 4.0});
    ASSERT_FALSE(target.empty());
    EXPECT_NEAR(target.front().veil->value, 0.02 * 2.0, 4e-4);
    EXPECT_NEAR(target.back().veil->value, 0.02 * 6.0, 4e-4);
}

TEST(Target, LeavesOutWhatTheReferenceDoesNotHave) {
    auto frames = rising(3.0);
    for (FrameAmounts& frame : frames)
        if (frame.time > 1.5) frame.flags = told::dense;
    const auto target = target_of(frames, {.from = 0.0, .to = 10.0});
    ASSERT_FALSE(target.empty());
    EXPECT_LE(target.back().time, 3.2);
    for (const TargetPoint& aim : target) {
        EXPECT_EQ(aim.blood.has_value(), aim.time < 1.5) << aim.time;
        EXPECT_TRUE(aim.veil) << aim.time;
    }
}

TEST(Target, OfOneMomentOrNoneIsNothing) {
    EXPECT_TRUE(target_of(rising(5.0), {.offset = 20.0}).empty());
    EXPECT_TRUE(target_of(rising(5.0), {.from = 3.0, .to = 3.0}).empty());
    EXPECT_TRUE(target_of({}, {}).empty());
    EXPECT_TRUE(target_of(rising(0.0), {.step = 0.5}).empty());
}

TEST(Target, HasNoMoreTimesThanAreWanted) {
    const auto target = target_of(rising(100.0), {.from = 0.0, .to = 100.0, .step = 0.2, .most = 50});
    EXPECT_EQ(target.size(), 50U);
    EXPECT_EQ(target.back().time, 100.0);
}

TEST(Target, ErrorsWithinAVideoAreThoseOfTheIntervalWithinBounds) {
    const auto error = [](double value, double half, const CourseError& course) {
        return course_error({value, value - half, value + half}, course);
    };
    EXPECT_DOUBLE_EQ(error(0.0, 0.1, veil_course), 0.03);
    EXPECT_DOUBLE_EQ(error(0.5, 0.1, veil_course), 0.03);
    EXPECT_NEAR(error(0.2, 0.0329, veil_course), 0.02, 1e-12);  // half a 90 % interval is 1.645 standard errors
    EXPECT_DOUBLE_EQ(error(0.2, 0.001, veil_course), 0.01);
    EXPECT_DOUBLE_EQ(error(0.0, 0.1, blood_course), 0.002);
    EXPECT_DOUBLE_EQ(error(0.02, 0.1, blood_course), 0.004);
    EXPECT_DOUBLE_EQ(error(0.3, 0.1, blood_course), 0.006);
    EXPECT_DOUBLE_EQ(error(0.3, 0.001, blood_course), 0.002);
}

TEST(Target, SmokeHidesBloodTheMoreTheThickerItIsAndTheLessTextureIsLeft) {
    auto frames = rising(4.0);
    for (FrameAmounts& frame : frames) {
        frame.veil.value = frame.time < 2.0 ? 0.0 : 0.3;
        frame.likeness = frame.time < 3.0 ? 0.75 : 0.5;
    }
    const auto target = target_of(frames, {.from = 0.5, .to = 3.5, .step = 1.0});
    ASSERT_EQ(target.size(), 4U);
    EXPECT_EQ(target[0].hidden_blood, 0.0);
    EXPECT_EQ(target[1].hidden_blood, 0.0);
    EXPECT_NEAR(target[2].hidden_blood, 0.1 * 0.3, 1e-12);
    EXPECT_NEAR(target[3].hidden_blood, 0.1 * 0.3 * 2.0, 1e-12);
}

TEST(Target, HiddenBloodIsTheMeanAroundEachTime) {
    auto frames = rising(4.0);
    for (FrameAmounts& frame : frames) frame.veil.value = 0.1 * frame.time, frame.likeness = 0.75;
    for (const TargetPoint& aim : target_of(frames, {.from = 1.0, .to = 3.0, .step = 0.5}))
        EXPECT_NEAR(aim.hidden_blood, 0.01 * aim.time, 1e-4) << aim.time;
}

/// Moments of which each has its lower end of blood; nothing: not measurable.
std::vector<TargetPoint> bleeding(double step, const std::vector<std::optional<double>>& lows) {
    std::vector<TargetPoint> target;
    for (std::size_t i = 0; i < lows.size(); ++i) {
        target.push_back({.time = step * static_cast<double>(i), .blood = {}, .veil = {}});
        if (lows[i]) target.back().blood = Amount{*lows[i] + 0.02, *lows[i], *lows[i] + 0.04};
    }
    return target;
}

TEST(Target, BloodIsSeenWhereItStaysAboveNothingForASecond) {
    EXPECT_FALSE(shows_blood({}));
    EXPECT_FALSE(shows_blood(bleeding(0.2, std::vector<std::optional<double>>(50, 0.0))));
    const auto seen_for = [](int moments) {
        std::vector<std::optional<double>> lows(20, 0.0);
        std::fill_n(lows.begin() + 7, moments, 0.01);
        return shows_blood(bleeding(0.2, lows));
    };
    EXPECT_FALSE(seen_for(5)) << "0.8 s";
    EXPECT_TRUE(seen_for(6));
    EXPECT_FALSE(shows_blood(bleeding(0.2, {0.1, 0.1, 0.1, 0.0, 0.1, 0.1, 0.1, 0.0, 0.1}))) << "not at a stretch";
    EXPECT_TRUE(shows_blood(bleeding(2.0, {0.1, 0.1})));
}

TEST(Target, WhatLiesBetweenTwoMomentsWithBloodIsNoBleedingOfThatLength) {
    std::vector<std::optional<double>> lows(40);
    EXPECT_FALSE(shows_blood(bleeding(0.2, lows)));
    lows[3] = lows[30] = 0.01;
    EXPECT_FALSE(shows_blood(bleeding(0.2, lows))) << "5.4 s apart, and nothing is known of what is between";
    std::fill_n(lows.begin() + 3, 3, 0.01);
    std::fill_n(lows.begin() + 30, 3, 0.01);
    EXPECT_FALSE(shows_blood(bleeding(0.2, lows))) << "0.4 s each";
    std::fill_n(lows.begin() + 30, 4, 0.01);
    EXPECT_TRUE(shows_blood(bleeding(0.2, lows)));
    lows[20] = 0.0;
    EXPECT_FALSE(shows_blood(bleeding(0.2, lows))) << "there is none between";
}

TEST(Target, MisfitIsTheRootMeanSquare) {
    const auto target = target_of(rising(10.0), {.from = 0.0, .to = 4.0, .step = 1.0});
    std::vector<FrameAmounts> shown(target.size());
    for (std::size_t i = 0; i < shown.size(); ++i) {
        shown[i].veil.value = target[i].veil->value + (i % 2 == 0 ? 0.03 : -0.03);
        shown[i].blood.value = target[i].blood->value + 0.5;
    }
    EXPECT_NEAR(*misfit(target, shown, &TargetPoint::veil), 0.03, 1e-12);
    shown[0].blood.value = target[0].blood->value;
    for (std::size_t i = 2; i < shown.size(); ++i) shown[i].flags = told::dense;
    EXPECT_NEAR(*misfit(target, shown, &TargetPoint::blood), 0.5 / std::sqrt(2.0), 1e-12);
    for (FrameAmounts& frame : shown) frame.flags = told::dense;
    EXPECT_FALSE(misfit(target, shown, &TargetPoint::blood));
}

}  // namespace
}  // namespace lapfx::match
