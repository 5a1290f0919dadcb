// Hidden presets, found again in the curves that a made-up camera sees of them.
#include "match/fit/fit.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/match/fit/made_up_camera.h"

namespace lapfx::match {
namespace {

using namespace made_up;

TEST(Fit, FindsAHiddenPreset) {
    for (const document::Content& truth :
         {hidden(7.0, 8.0, 0.3, 0.15), hidden(2.0, 20.0, 0.05, 0.3), hidden(4.0, 12.0, 0.12, 0.05)}) {
        const FitResult found = found_for({.hidden = truth});
        const BleedingParameters& b = found.tuned.preset.bleeding;
        const HazeParameters& h = found.tuned.preset.smoke.haze;
        EXPECT_NEAR(b.speed, truth.preset.bleeding.speed, 0.03 * truth.preset.bleeding.speed);
        EXPECT_NEAR(b.max_extent, truth.preset.bleeding.max_extent, 0.03 * truth.preset.bleeding.max_extent);
        EXPECT_NEAR(h.accumulation, truth.preset.smoke.haze.accumulation, 0.05 * truth.preset.smoke.haze.accumulation);
        EXPECT_NEAR(h.ventilation, truth.preset.smoke.haze.ventilation, 0.1 * truth.preset.smoke.haze.ventilation);
        EXPECT_LT(*found.blood_after, 0.001);
        EXPECT_LT(*found.veil_after, 0.005);
        EXPECT_LE(found.curves, 7);
        for (const FittedParameter& p : found.parameters) EXPECT_TRUE(p.determined) << p.parameter.key << ": " << p.why;
    }
}

TEST(Fit, SpeedOfBloodBehindSmokeIsFoundButNotKnown) {
    const double truth = 7.0;
    Camera camera;
    FitInput input = input_of({.hidden = hidden(truth, 8.0, 0.12, 0.05)}, camera);
    const FittedParameter clear = of(fit(input), "bleeding.speed");
    EXPECT_TRUE(clear.determined) << clear.why;
    for (TargetPoint& aim : input.target) aim.hidden_blood = 0.05;
    const FittedParameter behind_smoke = of(fit(input), "bleeding.speed");
    EXPECT_NEAR(behind_smoke.after, truth, 0.03 * truth) << "not that of the preset before, 4";
    EXPECT_FALSE(behind_smoke.determined);
    EXPECT_TRUE(behind_smoke.why.starts_with("smoke may hide blood")) << behind_smoke.why;
    EXPECT_LT(behind_smoke.low, 0.5 * clear.low);
    EXPECT_GT(behind_smoke.high, 2.0 * clear.high);
}

/// How fast it clears and how dense the plume is does to a few seconds of veil what the haze itself does: unknown, and
/// held, they leave the haze to be known.
TEST(Fit, HoldsOneAfterTheOther) {
    const FitResult found = found_for(
        {.hidden = hidden(4.0, 12.0, 0.4, 0.05),
         .keys = {"smoke.haze.accumulation", "smoke.haze.ventilation", "smoke.plume.density", "events.1.power"},
         .noise = 0.05,
         .until = 3.0});
    const FittedParameter& accumulation = of(found, "smoke.haze.accumulation");
    EXPECT_TRUE(accumulation.determined) << accumulation.why;
    EXPECT_NEAR(accumulation.after, 0.4, 0.08);
    EXPECT_GT(accumulation.high, 2.0 * accumulation.after) << "what is held is not certain";
    for (const FittedParameter& p : found.parameters) {
        if (p.parameter.key == accumulation.parameter.key) continue;
        EXPECT_FALSE(p.determined) << p.parameter.key;
        EXPECT_EQ(p.after, p.before) << p.parameter.key;
    }
    EXPECT_LT(*found.veil_after, 0.3 * *found.veil_before);
}

/// Blood that spreads farther than it could before, and still spreads: how far it would go is not known, but the value
/// before is not it.
TEST(Fit, AValueThatTheCurvesRuleOutIsNotKept) {
    const FitResult found =
        found_for({.hidden = hidden(2.0, 60.0, 0.12, 0.05), .keys = {"bleeding.speed", "bleeding.max_extent"}});
    const FittedParameter& extent = of(found, "bleeding.max_extent");
    EXPECT_FALSE(extent.determined) << extent.low << " " << extent.after << " " << extent.high;
    EXPECT_GT(extent.after, 20.0);
    EXPECT_EQ(extent.after, extent.parameter.get(found.tuned));
    EXPECT_NE(extent.why.find("still spreads"), std::string::npos) << extent.why;
    EXPECT_NE(extent.why.find("rule out the value before"), std::string::npos) << extent.why;
    EXPECT_LT(*found.blood_after, 0.003);
}

TEST(Fit, FindsWhatTheCoreKnowsNothingOf) {
    document::Content truth = scene();
    truth.preset.smoke.plume.density = 1.2;
    const FitResult found = found_for({.hidden = truth, .keys = {"smoke.plume.density", "smoke.haze.accumulation"}});
    EXPECT_NEAR(found.tuned.preset.smoke.plume.density, 1.2, 0.1);
    EXPECT_NEAR(found.tuned.preset.smoke.haze.accumulation, 0.12, 0.01);
}

TEST(Fit, FindsWhenAToolBegins) {
    document::Content truth = scene();
    truth.scene.events[0].time = 3.4, truth.scene.events[1].time = 0.7;
    const FitResult found = found_for({.hidden = truth, .keys = {"events.0.time", "events.1.time"}});
    EXPECT_NEAR(found.tuned.scene.events[0].time, 3.4, 0.1);
    EXPECT_NEAR(found.tuned.scene.events[1].time, 0.7, 0.1);
    EXPECT_LE(found.curves, 7) << "the core knows what an event does: no curve is drawn to learn it";
}

TEST(Fit, IsTheSameEachTime) {
    const Known known{.hidden = hidden(7.0, 8.0, 0.3, 0.15), .noise = 0.02, .seed = 5};
    const FitResult once = found_for(known), again = found_for(known);
    EXPECT_EQ(write_preset(once.tuned.preset), write_preset(again.tuned.preset));
    for (std::size_t k = 0; k < once.parameters.size(); ++k) {
        EXPECT_EQ(once.parameters[k].low, again.parameters[k].low);
        EXPECT_EQ(once.parameters[k].high, again.parameters[k].high);
    }
}

TEST(Fit, IntervalsHoldTheTruth) {
    int held = 0, all = 0;
    for (std::uint32_t seed = 1; seed <= 6; ++seed) {
        const document::Content truth = hidden(6.0, 9.0, 0.2, 0.12);
        const FitResult found = found_for({.hidden = truth, .noise = 0.02, .seed = seed});
        for (const FittedParameter& p : found.parameters) {
            const double value = p.parameter.get(truth);
            EXPECT_LT(p.low, p.high) << p.parameter.key;
            EXPECT_LT(p.high, 2.0 * p.low) << p.parameter.key << ": as wide as that says nothing";
            ++all, held += p.low <= value && value <= p.high ? 1 : 0;
        }
    }
    EXPECT_GE(held, all * 8 / 10) << "of " << all;
}

TEST(Fit, WhatTheReferenceDoesNotTellKeepsItsValue) {
    // Ends while it still smokes and while blood still spreads.
    const FitResult found = found_for({.hidden = hidden(2.0, 30.0, 0.1, 0.08), .noise = 0.02, .until = 5.0});
    const FittedParameter& extent = of(found, "bleeding.max_extent");
    EXPECT_FALSE(extent.determined);
    EXPECT_EQ(found.tuned.preset.bleeding.max_extent, 12.0);
    EXPECT_NE(extent.why.find("still spreads"), std::string::npos) << extent.why;
    const FittedParameter& ventilation = of(found, "smoke.haze.ventilation");
    EXPECT_FALSE(ventilation.determined);
    EXPECT_NE(ventilation.why.find("still smokes"), std::string::npos) << ventilation.why;
    EXPECT_TRUE(of(found, "bleeding.speed").determined);
    EXPECT_NEAR(found.tuned.preset.bleeding.speed, 2.0, 0.1);
    EXPECT_LE(found.curves, 7) << "what is not told is held at once, not searched for first";
}

TEST(Fit, WhatItShowsIsWhatItGives) {
    // Too little smoke to tell how much; what is proposed is a little nearer all the same.
    Camera camera;
    const document::Content truth = hidden(4.0, 12.0, 0.004, 0.05);
    FitInput input = input_of({.hidden = truth, .keys = {"smoke.haze.accumulation"}}, camera);
    input.start = hidden(4.0, 12.0, 0.009, 0.05);
    input.proposed = truth;
    const FitResult found = fit(input);
    EXPECT_FALSE(found.parameters.front().determined);
    EXPECT_EQ(found.tuned.preset.smoke.haze.accumulation, 0.009);
    ASSERT_EQ(found.after.size(), found.before.size());
    for (std::size_t i = 0; i < found.after.size(); ++i)
        EXPECT_EQ(found.after[i].veil.value, found.before[i].veil.value) << "it is the same scene";
    EXPECT_EQ(found.veil_after, found.veil_before);
}

TEST(Fit, WithoutBloodSaysSo) {
    document::Content truth = scene();
    truth.scene.events.erase(truth.scene.events.begin());
    const FitResult found = found_for({.hidden = truth, .keys = {"smoke.haze.accumulation"}});
    EXPECT_NEAR(found.tuned.preset.smoke.haze.accumulation, 0.12, 0.01);
    document::Content smokeless = scene();
    smokeless.scene.events.pop_back();
    const FitResult other = found_for({.hidden = smokeless, .keys = {"bleeding.speed", "smoke.haze.suction"}});
    EXPECT_FALSE(of(other, "smoke.haze.suction").determined);
    EXPECT_NE(of(other, "smoke.haze.suction").why.find("shows no veil"), std::string::npos);
}

TEST(Fit, LeavesBleedingAsItIsWhereNoneIsSeen) {
    document::Content truth = hidden(4.0, 12.0, 0.3, 0.15);
    truth.scene.events.erase(truth.scene.events.begin());
    Camera camera;
    FitInput input = input_of({.hidden = truth}, camera);
    for (TargetPoint& aim : input.target)
        if (aim.time > 4.9 && aim.time < 5.7) aim.blood = Amount{0.2, 0.15, 0.25};  // it is mistaken for some moments
    const FitResult found = fit(input);
    EXPECT_EQ(found.tuned.preset.bleeding.speed, scene().preset.bleeding.speed);
    EXPECT_EQ(found.tuned.preset.bleeding.max_extent, scene().preset.bleeding.max_extent);
    for (const char* key : {"bleeding.speed", "bleeding.max_extent"}) {
        EXPECT_FALSE(of(found, key).determined);
        EXPECT_EQ(of(found, key).why, "no bleeding is seen, left as it is");
    }
    EXPECT_NEAR(found.tuned.preset.smoke.haze.accumulation, 0.3, 0.015);
    input.weights.veil = 0.0;
    try {
        fit(input);
        ADD_FAILURE() << "there is nothing to fit to";
    } catch (const Error& e) {
        EXPECT_EQ(e.failure(), Failure::bad_input);
        EXPECT_STREQ(e.what(),
                     "no bleeding is seen in the reference, and its veil does not count or is not measurable: nothing "
                     "to fit to");
    }
}

TEST(Fit, SmokeThatTheReferenceHasNotIsTakenDown) {
    Camera camera;
    FitInput input = input_of({.hidden = hidden(4.0, 12.0, 0.01, 0.05), .keys = {"smoke.haze.accumulation"}}, camera);
    input.start = hidden(4.0, 12.0, 0.3, 0.05);
    const FitResult found = fit(input);
    EXPECT_LT(found.tuned.preset.smoke.haze.accumulation, 0.03);
    EXPECT_LT(*found.veil_after, 0.1 * *found.veil_before);
}

TEST(Fit, FindsHowDenseThePlumeIsByWhatStandsOut) {
    document::Content truth = hidden(4.0, 12.0, 0.2, 0.05);
    truth.preset.smoke.plume.density = 0.8;
    const std::vector<std::string> keys = {"smoke.haze.accumulation", "smoke.haze.ventilation", "smoke.plume.density"};
    const FitResult found = found_for({.hidden = truth, .keys = keys, .plume_share = 0.5, .plume_in_mean = false});
    EXPECT_NEAR(found.tuned.preset.smoke.plume.density, 0.8, 0.06);
    EXPECT_TRUE(of(found, "smoke.plume.density").determined) << of(found, "smoke.plume.density").why;
    EXPECT_LT(of(found, "smoke.plume.density").low, 0.8);
    EXPECT_GT(of(found, "smoke.plume.density").high, 0.8);
    EXPECT_NEAR(found.tuned.preset.smoke.haze.accumulation, 0.2, 0.02);
    const FitResult without = found_for({.hidden = truth, .keys = keys, .plume_in_mean = false});
    EXPECT_EQ(without.tuned.preset.smoke.plume.density, scene().preset.smoke.plume.density);
    EXPECT_FALSE(of(without, "smoke.plume.density").determined);
}

TEST(Fit, FindsHowLargeThePlumeIsByWhatStandsOut) {
    document::Content truth = scene();
    truth.preset.smoke.plume.size = 180.0;
    const FitResult found =
        found_for({.hidden = truth, .keys = {"smoke.haze.accumulation", "smoke.plume.size"}, .plume_share = 0.5});
    EXPECT_NEAR(found.tuned.preset.smoke.plume.size, 180.0, 15.0);
    EXPECT_TRUE(of(found, "smoke.plume.size").determined) << of(found, "smoke.plume.size").why;
}

TEST(Fit, APlumeThatTheReferenceHasNotIsTakenDown) {
    document::Content truth = scene();
    truth.preset.smoke.plume.density = 0.02;
    Camera camera;
    FitInput input = input_of({.hidden = truth, .keys = {"smoke.plume.density"}, .plume_share = 0.5}, camera);
    input.start.preset.smoke.plume.density = 1.2;
    EXPECT_LT(fit(input).tuned.preset.smoke.plume.density, 0.12);
}

TEST(Fit, KeepsWithinItsBounds) {
    const FitResult found =
        found_for({.hidden = hidden(9.0, 12.0, 0.12, 0.05), .keys = {"bleeding.speed=3..6", "bleeding.max_extent"}});
    EXPECT_EQ(found.tuned.preset.bleeding.speed, 6.0);
    EXPECT_TRUE(of(found, "bleeding.speed").at_bound);
    EXPECT_FALSE(of(found, "bleeding.max_extent").at_bound);
}

TEST(Fit, GoesOnWithTheColoursThatAreMatchedAmidstIt) {
    document::Content truth = hidden(7.0, 8.0, 0.3, 0.15);
    truth.preset.smoke.haze.color.r = 0.5 * scene().preset.smoke.haze.color.r;
    Camera reference{.takes_bright_for_dense = true}, camera{.takes_bright_for_dense = true};
    FitInput input = input_of({}, camera);
    input.target = target_of(reference.see(truth, all_times()), {.to = seconds});
    const FitResult without = fit(input);
    EXPECT_NEAR(without.tuned.preset.smoke.haze.accumulation, 0.15, 0.02) << "half as bright, so half as dense";
    std::vector<double> asked;
    input.match_colors = [&](const document::Content& tuned) {
        asked.push_back(tuned.preset.smoke.haze.accumulation);
        document::Content matched = tuned;
        matched.preset.smoke.haze.color = truth.preset.smoke.haze.color;
        matched.preset.smoke.haze.ventilation = 9.0;  // no colour
        return std::optional(matched);
    };
    const FitResult found = fit(input);
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_GT(asked[0], 1.1 * scene().preset.smoke.haze.accumulation) << "after a first search";
    EXPECT_EQ(found.tuned.preset.smoke.haze.color, truth.preset.smoke.haze.color);
    EXPECT_NEAR(found.tuned.preset.smoke.haze.accumulation, 0.3, 0.015);
    EXPECT_NEAR(found.tuned.preset.smoke.haze.ventilation, 0.15, 0.015);
    EXPECT_LT(*found.veil_after, 0.005);
}

TEST(Fit, WhatTheCoreKnowsNothingOfIsLearntWhereTheColoursWereMatched) {
    document::Content truth = hidden(7.0, 8.0, 0.3, 0.15);
    truth.preset.smoke.plume.density = 1.0;
    truth.preset.smoke.plume.size = 180.0;
    Camera camera;
    FitInput input = input_of({.hidden = truth,
                               .keys = {"bleeding.speed", "bleeding.max_extent", "smoke.haze.accumulation",
                                        "smoke.haze.ventilation", "smoke.plume.size"}},
                              camera);
    input.start.preset.smoke.plume.density = 1.0;
    std::vector<document::Content> drawn;
    const auto draw = input.draw;
    input.draw = [&](const document::Content& tuned, std::span<const double> times) {
        drawn.push_back(tuned);
        return draw(tuned, times);
    };
    std::size_t matched_at = 0;
    input.match_colors = [&](document::Content tuned) {
        matched_at = drawn.size();
        tuned.preset.smoke.haze.color.b *= 0.9;  // which this camera does not see
        return std::optional(std::move(tuned));
    };
    const FitResult found = fit(input);
    ASSERT_GT(drawn.size(), matched_at + 1);
    const Preset &stands = drawn[matched_at].preset, &moved = drawn[matched_at + 1].preset;
    EXPECT_NE(moved.smoke.plume.size, stands.smoke.plume.size);
    EXPECT_EQ(moved.smoke.haze.accumulation, stands.smoke.haze.accumulation) << "one parameter moves";
    EXPECT_EQ(moved.bleeding.speed, stands.bleeding.speed);
    EXPECT_NEAR(found.tuned.preset.smoke.plume.size, 180.0, 15.0);
    EXPECT_NEAR(found.tuned.preset.smoke.haze.accumulation, 0.3, 0.02);
}

TEST(Fit, EndsEarlyWhereTheColoursDo) {
    Camera camera;
    FitInput input = input_of({.hidden = hidden(7.0, 8.0, 0.3, 0.15)}, camera);
    input.match_colors = [](const document::Content&) { return std::optional<document::Content>(); };
    const FitResult found = fit(input);
    EXPECT_TRUE(found.ended_early);
    EXPECT_EQ(found.curves, 2) << "the start, and what the first search found";
    EXPECT_LT(*found.veil_after, *found.veil_before);
    input.match_colors = [](const document::Content& tuned) { return std::optional(tuned); };
    EXPECT_FALSE(fit(input).ended_early) << "nothing to change";
}

TEST(Fit, EndedBeforeTheColoursWereDrawnGivesWhatWasDrawn) {
    Camera camera;
    FitInput input = input_of({.hidden = hidden(7.0, 8.0, 0.3, 0.15)}, camera);
    bool matched = false;
    const auto draw = input.draw;
    input.draw = [&](const document::Content& tuned, std::span<const double> times) {
        return matched ? std::optional<std::vector<FrameAmounts>>() : draw(tuned, times);
    };
    input.match_colors = [&](document::Content tuned) {
        matched = true;
        tuned.preset.smoke.haze.color.r *= 0.5;
        return std::optional(std::move(tuned));
    };
    const FitResult found = fit(input);
    EXPECT_TRUE(matched);
    EXPECT_TRUE(found.ended_early);
    EXPECT_EQ(found.tuned.preset.smoke.haze.color, scene().preset.smoke.haze.color);
}

/// The highest temperature allowed is a step away: the other side tells the slope, and the others are found all the
/// same.
TEST(Fit, ARuleBetweenValuesIsNoEnd) {
    Camera camera;
    Known known{.hidden = hidden(7.0, 12.0, 0.3, 0.05),
                .keys = {"bleeding.speed", "smoke.haze.accumulation", "cautery.coagulation_temperature"}};
    FitInput input = input_of(known, camera);
    input.start.preset.cautery.coagulation_temperature = 60.0, input.start.preset.cautery.char_temperature = 61.0;
    const FitResult found = fit(input);
    EXPECT_NEAR(found.tuned.preset.bleeding.speed, 7.0, 0.2);
    EXPECT_TRUE(of(found, "bleeding.speed").determined);
    const FittedParameter& temperature = of(found, "cautery.coagulation_temperature");
    EXPECT_FALSE(temperature.determined) << temperature.low << " " << temperature.high;
    EXPECT_LT(of(found, "bleeding.speed").low, of(found, "bleeding.speed").high);
}

TEST(Fit, WhatCannotMoveBesideTheOthersIsHeld) {
    Known known{.hidden = hidden(4.0, 12.0, 0.3, 0.05), .keys = {"smoke.haze.accumulation", "smoke.keying.chroma_low"}};
    ASSERT_EQ(scene().preset.smoke.keying.chroma_high, 0.0) << "chroma_low may not be above it";
    const FitResult found = found_for(known);
    EXPECT_FALSE(of(found, "smoke.keying.chroma_low").determined);
    EXPECT_EQ(found.tuned.preset.smoke.keying.chroma_low, scene().preset.smoke.keying.chroma_low);
    EXPECT_NEAR(found.tuned.preset.smoke.haze.accumulation, 0.3, 0.02);
}

TEST(Fit, AnAmountWithoutWeightIsLeftOut) {
    Camera camera;
    FitInput input = input_of({.hidden = hidden(7.0, 8.0, 0.3, 0.15)}, camera);
    input.weights.blood = 0.0;
    const FitResult found = fit(input);
    EXPECT_EQ(of(found, "bleeding.speed").why, "blood does not count, its weight is 0");
    EXPECT_EQ(found.tuned.preset.bleeding.speed, scene().preset.bleeding.speed);
    EXPECT_NEAR(found.tuned.preset.smoke.haze.accumulation, 0.3, 0.02);
    input.weights.veil = 0.0;
    EXPECT_THROW(fit(input), Error);
}

TEST(Fit, ThatIsCancelledGivesTheBestSoFar) {
    const document::Content truth = hidden(7.0, 8.0, 0.3, 0.15);
    Camera camera;
    FitInput input = input_of({.hidden = truth}, camera);
    int drawn = 0;
    const auto draw = input.draw;
    input.draw = [&](const document::Content& tuned, std::span<const double> times) {
        return ++drawn > 2 ? std::optional<std::vector<FrameAmounts>>() : draw(tuned, times);
    };
    const FitResult found = fit(input);
    EXPECT_TRUE(found.ended_early);
    EXPECT_EQ(found.curves, 2);
    EXPECT_LT(*found.veil_after, *found.veil_before) << "one search was drawn";
    ASSERT_EQ(found.parameters.size(), 4U);
    for (const FittedParameter& p : found.parameters) {
        EXPECT_EQ(p.after, p.parameter.get(found.tuned)) << "what is told is what is there";
        EXPECT_FALSE(p.determined);
    }
    input.progress = [](const FitProgress&) { return false; };
    drawn = 0;
    const FitResult none = fit(input);
    EXPECT_TRUE(none.ended_early);
    EXPECT_EQ(write_preset(none.tuned.preset), write_preset(scene().preset));
}

TEST(Fit, ProgressGrowsAndShowsTheBest) {
    Camera camera;
    FitInput input = input_of({.hidden = hidden(7.0, 8.0, 0.3, 0.15)}, camera);
    double last = 0.0;
    bool shown = false;
    input.progress = [&](const FitProgress& progress) {
        EXPECT_GE(progress.share, last);
        EXPECT_LE(progress.share, 1.0);
        last = progress.share, shown = shown || progress.best != nullptr;
        return true;
    };
    fit(input);
    EXPECT_TRUE(shown);
    EXPECT_GT(last, 0.2);
}

TEST(Fit, ProgressNeverGoesBackWhereTheSceneWithoutTheProposalIsSearchedToo) {
    Camera camera;
    FitInput input = input_of({.hidden = hidden(7.0, 8.0, 0.3, 0.15)}, camera);
    input.before = input.start;
    input.start.scene.events[1].time += 0.5;
    // One that the core's amounts do not depend on costs a curve more, and it exists beside the proposal only.
    for (FreeParameter& p : free_parameters(input.start, std::vector<std::string>{"bleeding.noise_scale"}))
        input.parameters.push_back(std::move(p));
    input.of_proposal = 1;
    double last = 0.0, next = 0.0;
    input.progress = [&](const FitProgress& progress) {
        EXPECT_GE(progress.share, last);
        EXPECT_GE(progress.next, next);
        last = progress.share, next = progress.next;
        return true;
    };
    fit(input);
    EXPECT_GT(last, 0.2);
}

TEST(Fit, TellsTheValuesThatAreThere) {
    for (const double until : {5.0, seconds}) {
        const FitResult found = found_for({.hidden = hidden(2.0, 30.0, 0.1, 0.08), .noise = 0.02, .until = until});
        ASSERT_EQ(found.parameters.size(), 4U);
        for (const FittedParameter& p : found.parameters) EXPECT_EQ(p.after, p.parameter.get(found.tuned));
    }
}

TEST(Fit, WhatIsNotDeterminedGoesBackToWhatWasThereBeforeTheProposal) {
    Camera camera;
    FitInput input = input_of({.hidden = hidden(2.0, 30.0, 0.1, 0.08), .noise = 0.02, .until = 5.0}, camera);
    input.before = input.start;
    input.start.preset.smoke.haze.ventilation = 0.2;
    const FitResult found = fit(input);
    const FittedParameter& ventilation = of(found, "smoke.haze.ventilation");
    EXPECT_FALSE(ventilation.determined);
    EXPECT_EQ(ventilation.before, 0.05);
    EXPECT_EQ(ventilation.after, 0.05);
    EXPECT_EQ(found.tuned.preset.smoke.haze.ventilation, 0.05);
}

/// Blood of the reference is there from the beginning, and all the time as much: it tells no speed and no extent.
FitInput input_with_even_blood(double share, Camera& camera) {
    FitInput input = input_of({.keys = {"bleeding.speed", "bleeding.max_extent"}}, camera);
    for (TargetPoint& aim : input.target) aim.blood = Amount{share, share - 0.005, share + 0.005};
    return input;
}

TEST(Fit, WhatEvenBloodDoesNotTellIsNotPutBackWhereThatIsFarther) {
    Camera camera;
    FitInput input = input_with_even_blood(0.02, camera);
    double nearest = 1.0;
    const auto draw = input.draw;
    input.draw = [&](const document::Content& tuned, std::span<const double> times) {
        auto frames = draw(tuned, times);
        nearest = std::min(nearest, misfit(input.target, *frames, &TargetPoint::blood).value());
        return frames;
    };
    const FitResult found = fit(input);
    EXPECT_LT(nearest, 0.2 * *found.blood_before);
    EXPECT_LE(*found.blood_after, 1.05 * nearest);
    const FittedParameter& extent = of(found, "bleeding.max_extent");
    EXPECT_LT(extent.after, 8.0) << "12 before";
    EXPECT_FALSE(extent.determined);
    EXPECT_EQ(extent.why,
              "the blood of the reference does not change beyond the error of measuring; put back together with "
              "the others, the value before makes the curves farther: this is one of many that fit");
}

TEST(Fit, WhatEvenBloodDoesNotTellKeepsItsValueWhereThatIsAsNear) {
    Camera camera;
    FitInput input = input_with_even_blood(0.084, camera);
    input.start.scene.events[0].time = 0.0, input.start.preset.bleeding.speed = 60.0;
    const FitResult found = fit(input);
    for (const FittedParameter& p : found.parameters) {
        EXPECT_EQ(p.after, p.before) << p.parameter.key;
        EXPECT_EQ(p.why, "the blood of the reference does not change beyond the error of measuring");
    }
}

/// With a second cut it is nearer as long as each spreads less, and farther once that has its value again.
TEST(Fit, NoProposalIsFartherThanTheSceneAsItWas) {
    Camera camera;
    FitInput input = input_with_even_blood(0.08, camera);
    input.before = input.start;
    ToolContact second = input.start.scene.events[0];
    second.time = 0.0, second.position = second.to = {-25.0, 0.0, 0.0};
    input.start.scene.events.push_back(second);
    const FitResult found = fit(input);
    EXPECT_LE(*found.blood_after, *found.blood_before);
}

TEST(Fit, RefusesASceneThatCannotBeMeasured) {
    Camera camera;
    FitInput input = input_of({}, camera);
    const auto draw = input.draw;
    unsigned flags = told::not_measurable;
    input.draw = [&](const document::Content& tuned, std::span<const double> times) {
        auto frames = draw(tuned, times);
        for (FrameAmounts& frame : *frames) frame.flags = flags;
        return frames;
    };
    EXPECT_THROW(fit(input), Error);
    flags = told::dense;  // no blood, but veil
    const FitResult found = fit(input);
    EXPECT_FALSE(of(found, "bleeding.speed").determined);
    EXPECT_FALSE(found.blood_after);
}

TEST(Fit, RefusesAReferenceThatTellsNothing) {
    Camera camera;
    const FitInput good = input_of({}, camera);
    FitInput input = good;
    input.target.clear();
    EXPECT_THROW(fit(input), Error);
    input = good, input.parameters.clear();
    EXPECT_THROW(fit(input), Error);
    input = good;
    for (TargetPoint& aim : input.target) aim.blood.reset(), aim.veil.reset();
    EXPECT_THROW(fit(input), Error);
}

}  // namespace
}  // namespace lapfx::match
