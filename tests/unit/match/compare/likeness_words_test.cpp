// Each part of the line in words leads to what mends it.
#include "match/compare/likeness_words.h"

#include <gtest/gtest.h>

namespace lapfx::match {
namespace {

/// Of an amount that is measurable, shown and the same in both; what a test changes differs.
AmountLikeness alike() {
    Episode episode;
    episode.peak = 0.3, episode.onset = 4.0, episode.rise = 2.0, episode.peak_at = 7.0, episode.decay = 3.0;
    AmountLikeness a;
    a.frames = 100, a.rms = 0.0, a.rms_over_error = 0.0, a.peak_over_error = 0.0;
    a.in_preview = a.in_reference = Presence::shown;
    a.preview = a.reference = episode;
    a.late = 0.0, a.peak_ratio = 1.0, a.rise_difference = 0.0, a.decay_difference = 0.0;
    return a;
}
AmountLikeness different() {
    AmountLikeness a = alike();
    a.rms = 0.1, a.rms_over_error = 3.0, a.peak_over_error = 3.0;
    return a;
}

const std::vector<ToolContact> events = {{.action = ToolAction::cut, .time = 1.0},
                                         {.action = ToolAction::coagulate, .time = 2.0},
                                         {.action = ToolAction::suction, .time = 4.0},
                                         {.action = ToolAction::coagulate, .time = 4.5},
                                         {.action = ToolAction::cut, .time = 3.5, .strength = 0.0}};

std::vector<Clause> told(const AmountLikeness& blood, const AmountLikeness& veil) {
    return clauses({.overlap = 10.0, .blood = blood, .veil = veil}, events);
}
/// Of the one clause that differs.
Clause of_veil(const AmountLikeness& veil) {
    const std::vector<Clause> all = told(alike(), veil);
    EXPECT_EQ(all.size(), 2U);
    EXPECT_EQ(all.back().what, Said::match);
    return all.front();
}
Clause of_blood(const AmountLikeness& blood) {
    const std::vector<Clause> all = told(blood, alike());
    EXPECT_EQ(all.size(), 2U);
    return all.front();
}
void expect(const Clause& clause, std::string_view sentence, Said what, std::string_view key) {
    EXPECT_EQ(clause.sentence(), sentence);
    EXPECT_EQ(clause.what, what) << sentence;
    EXPECT_EQ(clause.key, key) << sentence;
}

TEST(LikenessWords, TooMuchAndTooLittleLeadToHowMuchIsMade) {
    AmountLikeness a = different();
    a.peak_ratio = 0.7;
    expect(of_veil(a), "veil is 30 % too thin", Said::size, "smoke.haze.accumulation");
    expect(of_blood(a), "blood is 30 % too small", Said::size, "bleeding.max_extent");
}

TEST(LikenessWords, LateLeadsToTheEventThatBeginsIt) {
    AmountLikeness a = different();
    a.late = 1.2;
    expect(of_veil(a), "veil comes 1.2 s too late", Said::timing, "events.3.time");
    a.preview.onset = 1.4;
    expect(of_veil(a), "veil comes 1.2 s too late", Said::timing, "events.1.time");
    expect(of_blood(a), "blood comes 1.2 s too late", Said::timing, "events.0.time");
    a.preview.onset.reset();
    expect(of_veil(a), "veil comes 1.2 s too late", Said::timing, "events.3.time");
    const std::vector<Clause> without = clauses({.overlap = 10.0, .blood = alike(), .veil = a});
    expect(without.front(), "veil comes 1.2 s too late", Said::timing, "");
}

TEST(LikenessWords, RiseAndFall) {
    AmountLikeness a = different();
    a.rise_difference = 1.5;
    expect(of_blood(a), "blood rises 1.5 s too slowly", Said::rise, "bleeding.speed");
    expect(of_veil(a), "veil rises 1.5 s too slowly", Said::rise, "events.3.duration");
    a.rise_difference = 0.0, a.decay_difference = -1.5;
    expect(of_veil(a), "veil falls 1.5 s too fast", Said::fall, "smoke.haze.ventilation");
    expect(of_blood(a), "blood falls 1.5 s too fast", Said::fall, "");
}

TEST(LikenessWords, MissingLeadsToTheEventThatShouldMakeIt) {
    AmountLikeness a = different();
    a.in_preview = Presence::none, a.preview = {};
    expect(of_veil(a), "veil is missing in the preview", Said::missing, "events.3.time");
    expect(of_blood(a), "blood is missing in the preview", Said::missing, "events.4.strength");
    const std::vector<Clause> without = clauses({.overlap = 10.0, .blood = alike(), .veil = a}, {events.data(), 1});
    expect(without.front(), "veil is missing in the preview", Said::missing, "");
    AmountLikeness even = different();
    even.preview.peak_at.reset();
    expect(of_veil(even), "veil does not change in the preview", Said::missing, "events.3.time");
}

TEST(LikenessWords, WhatIsInThePreviewAloneLeadsToWhatSilencesIt) {
    AmountLikeness a = different();
    a.in_reference = Presence::none, a.reference = {};
    expect(of_veil(a), "veil is in the preview alone", Said::surplus, "events.3.power");
    a.preview.onset = 0.8;
    expect(of_blood(a), "blood is in the preview alone", Said::surplus, "events.0.strength");
}

TEST(LikenessWords, WhatIsMeasuredHigherIsNotMissingThough) {
    AmountLikeness a = different();
    a.in_reference = Presence::none, a.reference = {}, a.reference.peak = 0.5;
    a.late.reset(), a.peak_ratio.reset(), a.rise_difference.reset(), a.decay_difference.reset();
    expect(of_veil(a), "veil differs by 0.1, 3.0 times the error of measuring", Said::course,
           "smoke.haze.accumulation");
    a.reference.peak = 0.2;
    expect(of_veil(a), "veil is in the preview alone", Said::surplus, "events.3.power");
    std::swap(a.preview, a.reference), std::swap(a.in_preview, a.in_reference);
    expect(of_veil(a), "veil is missing in the preview", Said::missing, "events.3.time");
    a.preview.peak = 0.5;
    expect(of_veil(a), "veil differs by 0.1, 3.0 times the error of measuring", Said::course,
           "smoke.haze.accumulation");
}

TEST(LikenessWords, SeveralOfOneAmountAreOneClauseEach) {
    AmountLikeness a = different(), b = different();
    a.late = -1.0, a.peak_ratio = 2.5, a.decay_difference = 2.0;
    const std::vector<Clause> all = told(b, a);
    ASSERT_EQ(all.size(), 4U);
    expect(all[0], "blood differs by 0.1, 3.0 times the error of measuring", Said::course, "bleeding.max_extent");
    expect(all[1], "veil comes 1.0 s too early", Said::timing, "events.3.time");
    expect(all[2], "veil is 2.5 times too dense", Said::size, "smoke.haze.accumulation");
    expect(all[3], "veil falls 2.0 s too slowly", Said::fall, "smoke.haze.ventilation");
    EXPECT_EQ(in_words({.overlap = 10.0, .blood = b, .veil = a}),
              "blood differs by 0.1, 3.0 times the error of measuring; veil comes 1.0 s too early, is 2.5 times too "
              "dense and falls 2.0 s too slowly");
}

TEST(LikenessWords, PeaksWithinALargeErrorAreToldThough) {
    AmountLikeness a = alike();
    a.in_preview = a.in_reference = Presence::none;
    a.peak_ratio.reset(), a.area_ratio.reset();
    a.preview.peak = 0.04, a.reference.peak = 0.06;
    expect(of_blood(a), "blood matches within the error of measuring", Said::match, "");
    a.reference.peak = 0.1;
    expect(of_blood(a),
           "blood matches within the error of measuring, which is large: its peak is 4 % of the view, in the reference "
           "10 %",
           Said::rough_match, "");
    EXPECT_EQ(in_words({.overlap = 10.0, .blood = a, .veil = alike()}),
              "blood matches within the error of measuring, which is large: its peak is 4 % of the view, in the "
              "reference 10 %; veil matches within the error of measuring");
}

TEST(LikenessWords, APeakThatIsHalfIsToldThoughTheAreasAreAlike) {
    AmountLikeness a = alike();
    a.area_ratio = 0.9;
    a.preview.peak = 0.23, a.reference.peak = 0.43;
    expect(told(alike(), a).back(),
           "veil matches within the error of measuring, which is large: its peak is 23 % of the view, in the reference "
           "43 %",
           Said::rough_match, "");
    a.preview.peak = 0.3;
    expect(told(alike(), a).back(), "veil matches within the error of measuring", Said::match, "");
}

TEST(LikenessWords, WhatIsSeenInOneAloneIsSaidThoughItIsWithinTheError) {
    AmountLikeness a = alike();
    a.in_reference = Presence::none, a.reference.peak = 0.05;
    a.peak_ratio.reset(), a.area_ratio.reset();
    expect(of_veil(a), "veil is seen in the preview alone, though by no more than the error of measuring",
           Said::surplus, "events.3.power");
    a.preview.onset = 0.8;
    expect(of_blood(a), "blood is seen in the preview alone, though by no more than the error of measuring",
           Said::surplus, "events.0.strength");
    std::swap(a.preview, a.reference), std::swap(a.in_preview, a.in_reference);
    expect(of_veil(a), "veil is seen in the reference alone, though by no more than the error of measuring",
           Said::missing, "events.1.time");
    a.preview.peak = 0.4;
    expect(told(alike(), a).back(),
           "veil matches within the error of measuring, which is large: its peak is 40 % of the view, in the reference "
           "30 %",
           Said::rough_match, "");
}

TEST(LikenessWords, WhatIsAboutNoneIsSeenInNeither) {
    AmountLikeness a = alike();
    a.in_reference = Presence::none, a.reference.peak = 0.0;
    a.peak_ratio.reset(), a.area_ratio.reset();
    a.preview.peak = told_peak + 0.001, a.preview.onset = 0.8;
    expect(of_blood(a), "blood is seen in the preview alone, though by no more than the error of measuring",
           Said::surplus, "events.0.strength");
    a.preview.peak = told_peak;
    expect(of_blood(a), "blood matches within the error of measuring", Said::match, "");
    std::swap(a.preview, a.reference), std::swap(a.in_preview, a.in_reference);
    expect(told(alike(), a).back(), "veil matches within the error of measuring", Said::match, "");
}

TEST(LikenessWords, WhatComesMuchTooEarlyIsSaidThoughItIsWithinTheError) {
    AmountLikeness a = alike();
    a.late = -0.9;
    expect(told(alike(), a).back(), "veil matches within the error of measuring", Said::match, "");
    a.late = -2.4;
    const std::vector<Clause> all = told(alike(), a);
    ASSERT_EQ(all.size(), 3U);
    expect(all[0], "veil comes 2.4 s too early", Said::timing, "events.3.time");
    EXPECT_EQ(in_words({.overlap = 10.0, .blood = alike(), .veil = a}),
              "veil comes 2.4 s too early and matches within the error of measuring otherwise; blood matches within "
              "the error of measuring");
}

TEST(LikenessWords, WhatDiffersIsSaidBeforeWhatNobodyCanTellAndThatBeforeAMatch) {
    AmountLikeness unknown = alike(), thin = different();
    unknown.error = 0.21, unknown.preview.peak = 0.3, unknown.reference.peak = 0.1;
    thin.peak_ratio = 0.7;
    expect(of_blood(unknown), "cannot tell whether blood matches: the error of measuring is 21 % of the view",
           Said::cannot_tell, "");
    EXPECT_EQ(in_words({.overlap = 10.0, .blood = unknown, .veil = thin}),
              "veil is 30 % too thin; cannot tell whether blood matches: the error of measuring is 21 % of the view");
    EXPECT_EQ(in_words({.overlap = 10.0, .blood = alike(), .veil = unknown}),
              "cannot tell whether veil matches: the error of measuring is 21 % of the view; blood matches within the "
              "error of measuring");
    unknown.larger_error = 0.15, unknown.bias = -0.16;
    expect(of_blood(unknown),
           "blood is less in the preview, but how much cannot be told: the error of measuring is 21 % of the view",
           Said::seen_apart, "bleeding.max_extent");
    unknown.bias = 0.14;
    EXPECT_EQ(of_blood(unknown).what, Said::cannot_tell);
    unknown.error = 0.09;
    expect(
        of_blood(unknown),
        "blood matches within the error of measuring, which is large: its peak is 30 % of the view, in the reference "
        "10 %",
        Said::rough_match, "");
}

TEST(LikenessWords, WhatCannotBeMendedHasNoKey) {
    const std::vector<Clause> same = told(alike(), alike());
    ASSERT_EQ(same.size(), 2U);
    expect(same[0], "blood matches within the error of measuring", Said::match, "");
    expect(same[1], "veil matches within the error of measuring", Said::match, "");
    AmountLikeness a = different();
    a.in_reference = Presence::unmeasurable;
    expect(of_veil(a), "veil is too rarely measurable in the reference", Said::unmeasurable, "");
    a.frames = 0;
    expect(of_veil(a), "veil is at no time measurable in both", Said::unmeasurable, "");
    const std::vector<Clause> apart = clauses({}, events);
    ASSERT_EQ(apart.size(), 1U);
    expect(apart.front(), "preview and reference have no time in common", Said::no_time, "");
}

}  // namespace
}  // namespace lapfx::match
