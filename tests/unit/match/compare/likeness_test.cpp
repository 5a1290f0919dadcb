#include "match/compare/likeness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <vector>

#include "match/frame/estimator.h"

namespace lapfx::match {
namespace {

using Course = std::function<double(double)>;

constexpr double half_width = 0.03;

struct Taken {
    double from = 0.0, to = 20.0, step = 0.04, half = half_width;
};

/// Frames whose veil and blood follow a course, with intervals that are not clipped at 0.
std::vector<FrameAmounts> frames_of(const Course& veil, const Course& blood, const Taken& taken = {}) {
    std::vector<FrameAmounts> frames;
    const auto amount = [&](double value) { return Amount{value, value - taken.half, value + taken.half}; };
    for (int i = 0; taken.from + i * taken.step <= taken.to + 1e-9; ++i) {
        const double time = taken.from + i * taken.step;
        frames.push_back({.time = time, .blood = amount(blood(time)), .veil = amount(veil(time))});
    }
    return frames;
}

std::vector<FrameAmounts> veil_of(const Course& veil, const Taken& taken = {}) {
    return frames_of(
        veil, [](double) { return 0.0; }, taken);
}

Course even(double level) {
    return [level](double) { return level; };
}

/// 0 up to `start`, a straight rise of `rise` s, then a straight fall of `fall` s.
Course tent(double height, double start, double rise = 2.0, double fall = 4.0) {
    return [=](double time) {
        if (time < start || time > start + rise + fall) return 0.0;
        return time < start + rise ? height * (time - start) / rise : height * (start + rise + fall - time) / fall;
    };
}

TEST(Likeness, OfACurveToItselfIsFull) {
    const auto frames = frames_of(tent(0.5, 4), tent(0.2, 6));
    const Likeness found = likeness_of(frames, frames, 0);
    EXPECT_NEAR(*found.overlap, 20.0, 1e-9);
    for (const AmountLikeness* a : {&found.blood, &found.veil}) {
        EXPECT_EQ(a->frames, 501);
        EXPECT_NEAR(a->seconds, 20.0, 1e-9);
        EXPECT_EQ(a->rms, 0.0);
        EXPECT_EQ(a->bias, 0.0);
        EXPECT_EQ(a->rms_over_error, 0.0);
        EXPECT_EQ(a->late, 0.0);
        EXPECT_EQ(a->peak_ratio, 1.0);
        EXPECT_EQ(a->area_ratio, 1.0);
        EXPECT_EQ(a->rise_difference, 0.0);
        EXPECT_EQ(a->decay_difference, 0.0);
        EXPECT_TRUE(a->matches());
    }
    EXPECT_EQ(in_words(found), "blood and veil match within the error of measuring");
}

TEST(Likeness, OfLevelsThatDifferIsTheirDifference) {
    const Likeness found = likeness_of(veil_of(even(0.24)), veil_of(even(0.3)), 0);
    EXPECT_NEAR(*found.veil.rms, 0.06, 1e-12);
    EXPECT_NEAR(*found.veil.bias, -0.06, 1e-12);
    EXPECT_NEAR(*found.veil.rms_over_error, 0.06 / (half_width * std::numbers::sqrt2), 1e-9);
    EXPECT_NEAR(*found.veil.peak_over_error, *found.veil.rms_over_error, 1e-9);
    EXPECT_NEAR(*found.veil.area_ratio, 0.8, 1e-9);
    EXPECT_FALSE(found.veil.late) << "neither changes";
    EXPECT_EQ(in_words(found), "veil is 20 % too thin; blood matches within the error of measuring");
}

TEST(Likeness, BiasIsLessThanTheDifferenceWhereSignsChange) {
    const auto wave = [](double time) { return 0.3 + 0.1 * std::sin(std::numbers::pi * time); };  // ten whole periods
    const Likeness found = likeness_of(veil_of(wave), veil_of(even(0.3)), 0);
    EXPECT_NEAR(*found.veil.bias, 0.0, 1e-9);
    EXPECT_NEAR(*found.veil.rms, 0.1 / std::numbers::sqrt2, 1e-9);
}

TEST(Likeness, TheHalvesOfTheIntervalsThatFaceEachOtherCount) {
    std::vector<FrameAmounts> preview = veil_of(even(0.5)), reference = veil_of(even(0.3));
    for (FrameAmounts& f : preview) f.veil.low = 0.47, f.veil.high = 0.9;
    for (FrameAmounts& f : reference) f.veil.low = 0.0, f.veil.high = 0.34;
    EXPECT_NEAR(*likeness_of(preview, reference, 0).veil.rms_over_error, 0.2 / 0.05, 1e-9) << "0.03 and 0.04";
    EXPECT_NEAR(*likeness_of(reference, preview, 0).veil.rms_over_error, 0.2 / 0.05, 1e-9);
}

TEST(Likeness, ComparesAtTheReferencesTimes) {
    // The reference starts 3 s into its video and at half the rate.
    const auto preview = veil_of(tent(0.5, 4));
    const auto reference = veil_of([](double time) { return tent(0.5, 4)(time - 3); }, {.to = 15, .step = 0.08});
    const AmountLikeness found = likeness_of(preview, reference, 3).veil;
    EXPECT_NEAR(*found.rms, 0.0, 1e-3);
    EXPECT_NEAR(*found.late, 0.0, 1e-2);
    EXPECT_NEAR(found.seconds, 12.0, 0.1) << "0 to 12 s of the scene";
    EXPECT_NEAR(*found.reference.peak_at, 6.0, 0.05) << "in the scene's time";
    EXPECT_GT(*likeness_of(preview, reference, 0).veil.rms, 0.1);
}

TEST(Likeness, TakesThePreviewOnTheLineBetweenItsFrames) {
    const auto slope = [](double time) { return 0.02 * time; };
    const AmountLikeness found =
        likeness_of(veil_of(slope, {.step = 0.5}), veil_of(slope, {.from = 0.13, .step = 0.21}), 0).veil;
    EXPECT_EQ(found.frames, 95);
    EXPECT_NEAR(*found.rms, 0.0, 1e-12);
}

TEST(Likeness, NeverLooksAcrossALongerGap) {
    const auto reference = veil_of(even(0.3));
    EXPECT_EQ(likeness_of(veil_of(even(0.3), {.step = 0.5}), reference, 0).veil.frames, 501);
    const auto sparse = veil_of(even(0.3), {.step = 0.6});
    EXPECT_EQ(likeness_of(sparse, reference, 0).veil.frames, 34) << "every fifteenth is at a time of both";
    std::vector<FrameAmounts> preview = veil_of(even(0.3));
    std::erase_if(preview, [](const FrameAmounts& f) { return f.time > 8.01 && f.time < 11.99; });
    const AmountLikeness found = likeness_of(preview, reference, 0).veil;
    EXPECT_EQ(found.frames, 501 - 99) << "8 and 12 s are compared, what lies between is not";
    EXPECT_NEAR(found.seconds, 16.0, 0.05);
    EXPECT_NEAR(*found.reference.area, 0.3 * 16.0, 0.02) << "of the times that are compared";
}

TEST(Likeness, FramesThatAreFarApartStandForTheirSurroundings) {
    const auto reference = veil_of(even(0.3), {.step = 1.0});
    const AmountLikeness found = likeness_of(veil_of(even(0.2)), reference, 0).veil;
    EXPECT_EQ(found.frames, 21);
    EXPECT_NEAR(found.seconds, 20 * longest_gap, 1e-9);
    EXPECT_NEAR(*found.bias, -0.1, 1e-12);
}

TEST(Likeness, OfExactCurvesIsExact) {
    const Taken exact{.half = 0.0};
    EXPECT_EQ(likeness_of(veil_of(tent(0.5, 4), exact), veil_of(tent(0.5, 4), exact), 0).veil.rms_over_error, 0.0);
    EXPECT_EQ(in_words(likeness_of(veil_of(even(0.299), exact), veil_of(even(0.3), exact), 0)),
              "veil differs by 0.001, 100.0 times the error of measuring; blood matches within the error of measuring");
}

TEST(Likeness, ThePeakHasTheIntervalOfItsOwnFrame) {
    // Sure where the smoke is dense, as if nothing were known elsewhere.
    const auto unsure = [](double height) {
        auto frames = veil_of(tent(height, 4), {.half = 0.01});
        for (FrameAmounts& f : frames)
            if (f.time > 19) f.veil.low = f.veil.value - 0.9, f.veil.high = f.veil.value + 0.9;
        return frames;
    };
    const AmountLikeness found = likeness_of(unsure(0.4), unsure(0.5), 0).veil;
    EXPECT_NEAR(*found.peak_over_error, 0.1 / (0.01 * std::numbers::sqrt2), 0.3);
}

TEST(Likeness, LeavesOutWhatIsNotMeasurable) {
    const auto preview = frames_of(even(0.3), even(0.1));
    auto reference = preview;
    for (FrameAmounts& f : reference) {
        if (f.time < 5) f.veil = {1, 1, 1}, f.flags = told::not_measurable;
        if (f.time > 15) f.blood = {1, 1, 1}, f.flags = told::dense;
    }
    for (const bool turned : {false, true}) {
        const Likeness found = turned ? likeness_of(reference, preview, 0) : likeness_of(preview, reference, 0);
        EXPECT_NEAR(*found.veil.rms, 0.0, 1e-12);
        EXPECT_NEAR(found.veil.seconds, 15.0, 0.05);
        EXPECT_NEAR(*found.blood.rms, 0.0, 1e-12);
        EXPECT_NEAR(found.blood.seconds, 10.0, 0.1);
    }
}

TEST(Likeness, TellsHowLateFromTheOnsets) {
    const Likeness found = likeness_of(veil_of(tent(0.35, 5.2)), veil_of(tent(0.5, 4)), 0);
    EXPECT_NEAR(*found.veil.late, 1.2, 0.02);
    EXPECT_NEAR(*found.veil.peak_ratio, 0.7, 0.005);
    EXPECT_NEAR(*found.veil.area_ratio, 0.7, 0.005);
    EXPECT_NEAR(*found.veil.rise_difference, 0.0, 0.02);
    EXPECT_EQ(in_words(found),
              "veil comes 1.2 s too late and is 30 % too thin; blood matches within the error of measuring");
    const Likeness turned = likeness_of(veil_of(tent(0.5, 4)), veil_of(tent(0.35, 5.2)), 0);
    EXPECT_NEAR(*turned.veil.late, -1.2, 0.02);
    EXPECT_EQ(in_words(turned),
              "veil comes 1.2 s too early and is 43 % too dense; blood matches within the error of measuring");
}

/// From its start on it falls to 0.1, the faster the nearer to `middle`.
Course step_down(double height, double middle) {
    return [=](double time) { return 0.1 + height / (1.0 + std::exp(2.0 * (time - middle))); };
}

TEST(Likeness, TellsHowLateByShiftingWhatHasNoOnset) {
    const AmountLikeness found = likeness_of(veil_of(step_down(0.3, 9.5)), veil_of(step_down(0.5, 8)), 0).veil;
    EXPECT_FALSE(found.reference.onset);
    ASSERT_TRUE(found.late);
    EXPECT_NEAR(*found.late, 1.5, 0.051);
    EXPECT_NEAR(*likeness_of(veil_of(step_down(0.3, 7.0)), veil_of(step_down(0.5, 8)), 0).veil.late, -1.0, 0.051);
}

TEST(Likeness, TellsNoLatenessThatTheCurvesDoNotShow) {
    // A straight line, shifted, is one that is levelled otherwise; a ripple that is late makes no fall late.
    const auto fall = [](double late) {
        return [late](double time) { return 0.8 - 0.03 * (time - late) + 0.001 * std::sin(time - late); };
    };
    const AmountLikeness found = likeness_of(veil_of(fall(2)), veil_of(fall(0)), 0).veil;
    EXPECT_TRUE(found.preview.peak_at);
    EXPECT_FALSE(found.late);
    EXPECT_FALSE(likeness_of(veil_of(even(0.3)), veil_of(step_down(0.5, 8)), 0).veil.late) << "one does not change";
    // Their ends without the event would fit when shifted by 5 s, whatever the event is.
    const auto rippled = [](double middle, double late) {
        return [=](double time) { return step_down(0.5, middle)(time) + 0.002 * std::sin(2 * (time - late)); };
    };
    EXPECT_FALSE(likeness_of(veil_of(rippled(2, 5)), veil_of(rippled(17, 0)), 0).veil.late);
    // Later than is looked for.
    const Taken minute{.to = 60};
    EXPECT_FALSE(likeness_of(veil_of(step_down(0.5, 45), minute), veil_of(step_down(0.5, 30), minute), 0).veil.late);
}

TEST(Likeness, TellsRiseAndDecay) {
    const Likeness found = likeness_of(veil_of(tent(0.5, 4, 4, 8)), veil_of(tent(0.5, 4, 2, 5)), 0);
    EXPECT_NEAR(*found.veil.rise_difference, 0.8 * 2.0, 0.1);   // 10 % to 90 %
    EXPECT_NEAR(*found.veil.decay_difference, 0.5 * 3.0, 0.1);  // half of the fall
    EXPECT_EQ(in_words(found),
              "veil rises 1.6 s too slowly and falls 1.5 s too slowly; blood matches within the error of measuring");
    const Likeness turned = likeness_of(veil_of(tent(0.5, 4, 2, 5)), veil_of(tent(0.5, 4, 4, 8)), 0);
    EXPECT_EQ(in_words(turned),
              "veil rises 1.6 s too fast and falls 1.5 s too fast; blood matches within the error of measuring");
}

TEST(Likeness, SaysNothingOfSmallDifferencesOfRiseAndDecay) {
    const auto rise = [](double preview, double reference) {
        const Taken taken{.to = 200, .half = 0.01};
        return likeness_of(veil_of(tent(0.4, 4, preview), taken), veil_of(tent(0.5, 4, reference), taken), 0);
    };
    const std::string thin = "veil is 20 % too thin; blood matches within the error of measuring";
    EXPECT_NEAR(*rise(1.4, 1.0).veil.rise_difference, 0.32, 0.05);
    EXPECT_EQ(in_words(rise(1.4, 1.0)), thin) << "a third, but of a short time";
    EXPECT_NEAR(*rise(110, 100).veil.rise_difference, 8.0, 0.1);
    EXPECT_EQ(in_words(likeness_of(veil_of(tent(0.4, 3, 110), {.to = 200, .half = 0.01}),
                                   veil_of(tent(0.5, 4, 100), {.to = 200, .half = 0.01}), 0)),
              thin)
        << "long, but a tenth of the rise";
}

TEST(Likeness, SaysWhichDoesNotChange) {
    const auto changing = veil_of([](double time) { return 0.2 + tent(0.5, 4)(time); });
    EXPECT_EQ(in_words(likeness_of(veil_of(even(0.3)), changing, 0)),
              "veil does not change in the preview; blood matches within the error of measuring");
    EXPECT_EQ(in_words(likeness_of(changing, veil_of(even(0.3)), 0)),
              "veil changes in the preview alone; blood matches within the error of measuring");
}

TEST(Likeness, WithinTheIntervalsMatches) {
    // The same difference, with intervals as wide as it and narrower.
    const auto likeness = [](double half) {
        const Taken taken{.half = half};
        return likeness_of(veil_of(tent(0.45, 4.1), taken), veil_of(tent(0.5, 4), taken), 0);
    };
    EXPECT_TRUE(likeness(0.05).veil.matches());
    EXPECT_EQ(in_words(likeness(0.05)), "blood and veil match within the error of measuring");
    EXPECT_FALSE(likeness(0.02).veil.matches());
    EXPECT_EQ(in_words(likeness(0.02)), "veil is 10 % too thin; blood matches within the error of measuring");
}

TEST(Likeness, AMatchThatTheErrorAloneMakesSaysHowFarApartItIs) {
    const auto words = [](double shown) {
        const Taken taken{.half = 0.17};
        return in_words(likeness_of(frames_of(tent(0.5, 4), tent(shown, 4), taken),
                                    frames_of(tent(0.5, 4), tent(0.5, 4), taken), 0));
    };
    EXPECT_EQ(words(0.4), "blood and veil match within the error of measuring");
    EXPECT_EQ(
        words(0.3),
        "blood matches within the error of measuring, which is large: it is measured 40 % too small; veil matches "
        "within the error of measuring");
}

TEST(Likeness, AnErrorThatLeavesNothingKnownIsNoMatch) {
    // 5 % of the view is bloody in one and 30 % in the other, each measured to 20 %.
    const auto likeness = [](double half) {
        const Taken taken{.half = half};
        return likeness_of(frames_of(tent(0.5, 4), even(0.05), taken), frames_of(tent(0.5, 4), even(0.3), taken), 0);
    };
    const Likeness wide = likeness(0.2);
    EXPECT_TRUE(wide.blood.within_error());
    EXPECT_TRUE(wide.blood.cannot_tell());
    EXPECT_FALSE(wide.blood.matches());
    EXPECT_NEAR(*wide.blood.error, 0.2 * std::numbers::sqrt2, 1e-9);
    EXPECT_NEAR(*wide.blood.larger_error, 0.2, 1e-9);
    EXPECT_TRUE(wide.blood.seen_apart()) << "0.25 is more than 0.2";
    EXPECT_FALSE(wide.veil.seen_apart());
    EXPECT_TRUE(wide.veil.cannot_tell()) << "0.28 is more than half of its peak of 0.5";
    EXPECT_EQ(in_words(wide),
              "blood is less in the preview, but how much cannot be told: the error of measuring is 28 % of the view; "
              "cannot tell whether veil matches: the error of measuring is 28 % of the view");
    const Likeness less = likeness(0.16);
    EXPECT_FALSE(less.blood.within_error()) << "0.25 is beyond 0.23";
    EXPECT_TRUE(less.veil.matches()) << "0.23 is less than half of its peak";
    EXPECT_EQ(in_words(less).substr(0, 8), "blood is");
}

TEST(Likeness, WhatIsApartByMoreThanTheLargerErrorIsMoreOrLessThough) {
    const auto blood = [](double preview, double reference, double half) {
        const Taken narrow{.half = 0.1 * half}, wide{.half = half};
        return likeness_of(frames_of(even(0.0), even(preview), wide), frames_of(even(0.0), even(reference), narrow), 0);
    };
    const Likeness more = blood(0.3, 0.1, 0.1995);
    EXPECT_NEAR(*more.blood.larger_error, 0.1995, 1e-9) << "not their sum, nor the smaller";
    EXPECT_EQ(in_words(more).substr(0, in_words(more).find(';')),
              "blood is more in the preview, but how much cannot be told: the error of measuring is 20 % of the view");
    EXPECT_TRUE(blood(0.3, 0.1, 0.205).blood.cannot_tell());
    EXPECT_FALSE(blood(0.3, 0.1, 0.205).blood.seen_apart());
    EXPECT_FALSE(blood(0.3, 0.1, 0.15).blood.seen_apart()) << "it differs, and by how much is told";
}

TEST(Likeness, WhatNeitherShowsIsNotKnownWhereTheErrorIsLarge) {
    const auto blood = [](double half) {
        return likeness_of(frames_of(even(0.3), even(0.0), {.half = half}),
                           frames_of(even(0.3), even(0.02), {.half = half}), 0)
            .blood;
    };
    EXPECT_TRUE(blood(0.06).matches()) << "to 8.5 % of the view";
    EXPECT_FALSE(blood(0.08).matches()) << "to 11 %";
    EXPECT_TRUE(blood(0.08).cannot_tell());
}

TEST(Likeness, AnErrorLargerThanBothPeaksLeavesNothingKnown) {
    // Blood that grows to a share of the view, each frame of it measured to that; the reference shows none.
    const auto blood = [](double peak, double half) {
        const Course grows = [=](double time) { return peak * time / 20.0; };
        return likeness_of(frames_of(even(0.0), grows, {.half = half}), frames_of(even(0.0), even(0.0), {.half = half}),
                           0);
    };
    const Likeness shown = blood(0.038, 0.0364);
    ASSERT_TRUE(shown.blood.within_error());
    EXPECT_NEAR(*shown.blood.error, 0.0515, 1e-4);
    EXPECT_TRUE(shown.blood.cannot_tell()) << "5 % of the view is more than the 3.8 % of its end";
    EXPECT_FALSE(shown.blood.matches());
    EXPECT_EQ(in_words(shown).substr(0, in_words(shown).find(';')),
              "cannot tell whether blood matches: the error of measuring is 5 % of the view, more than either shows");
    EXPECT_TRUE(blood(0.038, 0.025).blood.matches()) << "3.5 % is less";
    EXPECT_TRUE(blood(0.019, 0.0364).blood.matches()) << "about none in both";
    EXPECT_TRUE(blood(0.0, 0.0364).blood.matches());
}

TEST(Likeness, AShortEventIsNotLostInALongVideo) {
    const Taken minutes{.to = 300};
    const Likeness found =
        likeness_of(veil_of(tent(0.3, 100, 1, 1), minutes), veil_of(tent(0.5, 100, 1, 1), minutes), 0);
    EXPECT_LT(*found.veil.rms_over_error, 1.0);
    EXPECT_GT(*found.veil.peak_over_error, 1.0);
    EXPECT_FALSE(found.veil.matches());
}

TEST(Likeness, TellsWhatIsMissing) {
    const auto none = frames_of(even(0.01), even(0.01)), both = frames_of(tent(0.5, 4), even(0.3));
    const Likeness found = likeness_of(none, both, 0);
    EXPECT_TRUE(found.veil.missing_in_preview());
    EXPECT_TRUE(found.blood.missing_in_preview()) << "even, but above 0";
    EXPECT_FALSE(found.veil.missing_in_reference());
    EXPECT_LT(*found.veil.peak_ratio, 0.03);
    EXPECT_EQ(in_words(found), "blood is missing in the preview; veil is missing in the preview");
    const Likeness turned = likeness_of(both, none, 0);
    EXPECT_TRUE(turned.veil.missing_in_reference());
    EXPECT_FALSE(turned.veil.missing_in_preview());
    EXPECT_FALSE(turned.veil.peak_ratio) << "the reference may have none";
    EXPECT_FALSE(turned.veil.late);
    EXPECT_EQ(in_words(turned), "blood is in the preview alone; veil is in the preview alone");
}

TEST(Likeness, WhatNeitherShowsMatchesAndIsMissingInNone) {
    const AmountLikeness found = likeness_of(veil_of(even(0.0)), veil_of(even(0.01)), 0).veil;
    EXPECT_EQ(found.in_preview, Presence::none);
    EXPECT_EQ(found.in_reference, Presence::none);
    EXPECT_FALSE(found.missing_in_preview());
    EXPECT_FALSE(found.peak_ratio);
    EXPECT_TRUE(found.matches());
    auto noisy = veil_of(even(0.0));
    noisy[100].veil.value = noisy[101].veil.value = noisy[102].veil.value = 0.1;  // no frame tells it from 0
    noisy[100].veil.low = noisy[101].veil.low = noisy[102].veil.low = 0.0;
    for (FrameAmounts& f : noisy) f.veil.high = 0.12;
    EXPECT_TRUE(likeness_of(noisy, veil_of(even(0.0)), 0).veil.matches());
}

TEST(Likeness, WhatMayBeTheSameIsMissingInNone) {
    // One is above 0, the other need not be.
    const auto some = veil_of(even(0.031)), none = veil_of(even(0.0));
    for (const AmountLikeness& found : {likeness_of(some, none, 0).veil, likeness_of(none, some, 0).veil}) {
        EXPECT_NE(found.in_preview, found.in_reference);
        EXPECT_FALSE(found.missing_in_preview() || found.missing_in_reference());
        EXPECT_TRUE(found.cannot_tell()) << "0.042 is more than 0.031";
    }
}

TEST(Likeness, TellsWhatIsNotMeasurableInMostFrames) {
    const auto preview = frames_of(tent(0.5, 4), even(0.1));
    auto reference = preview;
    for (FrameAmounts& f : reference)
        if (f.time < 11) f.flags = told::dense;
    const Likeness found = likeness_of(preview, reference, 0);
    EXPECT_EQ(found.blood.in_reference, Presence::unmeasurable);
    EXPECT_EQ(found.blood.in_preview, Presence::shown);
    EXPECT_FALSE(found.blood.reference.peak);
    EXPECT_FALSE(found.blood.matches());
    EXPECT_NEAR(*found.blood.rms, 0.0, 1e-12) << "of the rest";
    EXPECT_EQ(in_words(found),
              "blood is too rarely measurable in the reference; veil matches within the error of "
              "measuring");
    EXPECT_EQ(in_words(likeness_of(reference, preview, 0)),
              "blood is too rarely measurable in the preview; veil matches within the error of "
              "measuring");
    for (FrameAmounts& f : reference) f.flags = told::dense;
    EXPECT_EQ(in_words(likeness_of(preview, reference, 0)),
              "blood is at no time measurable in both; veil matches within the error of measuring");
}

TEST(Likeness, MostIsOfTheTimeThatBothSpan) {
    // Before the scene starts the reference is not measurable, for longer than the scene is.
    auto reference = veil_of(even(0.3), {.to = 50});
    for (FrameAmounts& f : reference)
        if (f.time < 29) f.flags = told::not_measurable;
    const AmountLikeness found = likeness_of(veil_of(even(0.3)), reference, 30).veil;
    EXPECT_EQ(found.in_reference, Presence::shown);
    EXPECT_TRUE(found.matches());
    // Nor do its frames beyond the scene count.
    for (FrameAmounts& f : reference) f.flags = f.time < 29 || f.time > 51 ? 0U : unsigned{told::not_measurable};
    EXPECT_EQ(likeness_of(veil_of(even(0.3)), reference, 30).veil.frames, 0);
}

TEST(Likeness, OfTimesThatAreNotCommonIsNone) {
    const auto early = veil_of(even(0.3)), late = veil_of(even(0.3), {.from = 30, .to = 40});
    for (const Likeness& found : {likeness_of(early, late, 0), likeness_of({}, late, 0), likeness_of(early, {}, 0)}) {
        EXPECT_EQ(found.veil.frames, 0);
        EXPECT_FALSE(found.veil.rms);
        EXPECT_FALSE(found.overlap);
        EXPECT_EQ(in_words(found), "preview and reference have no time in common");
    }
    EXPECT_NEAR(*likeness_of(early, late, 25).overlap, 10.0, 1e-9);
}

TEST(Likeness, OfSinglePicturesIsTheirDifference) {
    const Taken once{.to = 0};
    const Likeness found = likeness_of(veil_of(even(0.6), once), veil_of(even(0.2), once), 0);
    EXPECT_EQ(found.veil.frames, 1);
    EXPECT_EQ(found.veil.seconds, 0.0);
    EXPECT_NEAR(*found.veil.bias, 0.4, 1e-12);
    EXPECT_EQ(in_words(found), "veil is 3.0 times too dense; blood matches within the error of measuring");
}

TEST(Likeness, OfBloodSpeaksOfItsSize) {
    const auto likeness = [](double preview, double reference) {
        const Taken taken{.half = 0.01};
        return likeness_of(frames_of(even(0), tent(preview, 4), taken), frames_of(even(0), tent(reference, 4), taken),
                           0);
    };
    EXPECT_EQ(in_words(likeness(0.1, 0.2)), "blood is 50 % too small; veil matches within the error of measuring");
    EXPECT_EQ(in_words(likeness(0.5, 0.2)), "blood is 2.5 times too large; veil matches within the error of measuring");
}

TEST(Likeness, ThatIsOffWithoutAReasonSaysHowFar) {
    // As high, as early and as long, but between rise and fall it sags.
    const Taken taken{.to = 12, .half = 0.004};
    const auto sags = [](double time) { return tent(0.5, 4)(time) * (time > 6.5 && time < 7.5 ? 0.85 : 1.0); };
    const Likeness found = likeness_of(veil_of(sags, taken), veil_of(tent(0.5, 4), taken), 0);
    char text[128];
    std::snprintf(text, sizeof text, "veil differs by %.2g, %.1f times the error of measuring; blood matches",
                  *found.veil.rms, *found.veil.rms_over_error);
    EXPECT_EQ(in_words(found).substr(0, std::string(text).size()), text);
}

}  // namespace
}  // namespace lapfx::match
