// Known scenes, told from their curves alone.
#include "match/fit/proposal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lapfx/prepared_organ.h"
#include "match/scene/core_amounts.h"
#include "match/scene/view_share.h"
#include "support/meshes.h"

namespace lapfx::match {
namespace {

constexpr double seconds = 16.0, aspect = 1.25;

/// A cut and a burn on a plane, seen from above.
document::Content scene() {
    document::Content tuned;
    BleedingParameters& b = tuned.preset.bleeding;
    b.speed = 4.0, b.max_extent = 12.0;
    b.noise_strength = b.gravity_bias = b.crease_bias = b.rivulets = 0.0;
    tuned.preset.smoke.clips = {{.file = "smoke.mkv"}};
    tuned.scene.organ.file = "plane.obj";
    tuned.scene.duration = seconds;
    tuned.scene.camera = {.eye = {0.0, 60.0, 0.0}, .target = {0.0, 0.0, 0.0}, .up = {0.0, 0.0, -1.0}};
    tuned.scene.events = {
        {.action = ToolAction::cut, .time = 0.0, .duration = 0.0},
        {.action = ToolAction::cauterise, .time = 0.0, .duration = 1.0, .position = {28, 0, 0}, .to = {28, 0, 4}}};
    return tuned;
}

const std::shared_ptr<const PreparedOrgan>& organ() {
    static const std::shared_ptr<const PreparedOrgan> one = prepare_organ(test::plane(90.0, 60));
    return one;
}

Amount around(double value, double half) {
    return {value, value - half, value + half};
}

/// As an ideal camera sees the scene.
std::vector<TargetPoint> seen(const document::Content& tuned, double haze_offset = 0.0) {
    std::vector<double> times;
    for (double time = 0.0; time <= seconds; time += 0.2) times.push_back(time);
    const double share = share_per_mm2(tuned.scene.camera, aspect, {0, 0, 0}, {0, 1, 0});
    std::vector<TargetPoint> target;
    const auto amounts = CoreAmounts(organ()).at(tuned, times);
    for (std::size_t i = 0; i < times.size(); ++i)
        target.push_back({.time = times[i],
                          .blood = around(share * amounts[i].blood_area, 0.004),
                          .veil = around(1.0 - std::exp(-amounts[i].haze - haze_offset), 0.03)});
    return target;
}

document::Content hidden() {
    document::Content tuned = scene();
    tuned.scene.events[0].time = 5.0;
    tuned.scene.events[1].time = 2.0, tuned.scene.events[1].duration = 4.0, tuned.scene.events[1].strength = 0.0;
    tuned.preset.bleeding.speed = 2.5, tuned.preset.bleeding.max_extent = 9.0;
    tuned.preset.smoke.haze.accumulation = 0.25, tuned.preset.smoke.haze.ventilation = 0.2;
    return tuned;
}

Proposal of(const std::vector<TargetPoint>& target) {
    return propose(scene(), organ(), target, {.aspect = aspect});
}

TEST(Proposal, TellsToolsAndPreset) {
    const Proposal found = of(seen(hidden()));
    const std::vector<ToolContact>& events = found.tuned.scene.events;
    ASSERT_EQ(events.size(), 2U) << testing::PrintToString(texts_of(found.lines));
    EXPECT_EQ(events[0].action, ToolAction::cut);
    EXPECT_NEAR(events[0].time, 5.0, 0.2);
    EXPECT_EQ(events[1].action, ToolAction::cauterise);
    EXPECT_NEAR(events[1].time, 2.0, 0.2);
    EXPECT_NEAR(events[1].end(), 6.0, 0.3);
    EXPECT_EQ(events[1].position, scene().scene.events[1].position);
    EXPECT_EQ(events[1].strength, 0.0);
    const Preset& preset = found.tuned.preset;
    EXPECT_NEAR(preset.bleeding.speed, 2.5, 0.25);
    EXPECT_NEAR(preset.bleeding.max_extent, 9.0, 0.9);
    EXPECT_NEAR(preset.smoke.haze.accumulation, 0.25, 0.025);
    EXPECT_NEAR(preset.smoke.haze.ventilation, 0.2, 0.03);
    EXPECT_TRUE(found.tuned.scene.curves.emission.empty());
    EXPECT_TRUE(check(preset_table(), &preset).empty());
    for (const Fault& fault : check(scene_table(), &found.tuned.scene)) ADD_FAILURE() << fault.place << fault.reason;
}

TEST(Proposal, SetsOnlyWhatItMay) {
    const Proposal found = propose(scene(), organ(), seen(hidden()), {.aspect = aspect, .keys = {"bleeding.speed"}});
    EXPECT_NEAR(found.tuned.preset.bleeding.speed, 2.5, 0.25);
    EXPECT_EQ(found.tuned.preset.bleeding.max_extent, scene().preset.bleeding.max_extent);
    EXPECT_EQ(found.tuned.preset.smoke.haze.accumulation, scene().preset.smoke.haze.accumulation);
    EXPECT_EQ(found.tuned.preset.smoke.haze.ventilation, scene().preset.smoke.haze.ventilation);
    EXPECT_THAT(texts_of(found.lines), testing::Not(testing::Contains(testing::HasSubstr("smoke.haze."))));
}

TEST(Proposal, LeavesWhatLiesBeyondTheReference) {
    document::Content start = scene();
    const ToolContact late{.action = ToolAction::cauterise, .time = 30.0, .position = {-28, 0, 0}, .to = {-28, 0, 0}};
    const ToolContact cut{
        .action = ToolAction::cut, .time = 31.0, .duration = 0.0, .position = {0, 0, 28}, .to = {0, 0, 28}};
    start.scene.events.push_back(late), start.scene.events.push_back(cut);
    start.scene.curves.emission = {{.time = 3.0, .value = 0.2}, {.time = 29.0, .value = 0.5}};
    const Proposal found = propose(start, organ(), seen(hidden()), {.aspect = aspect});
    const std::vector<ToolContact>& events = found.tuned.scene.events;
    ASSERT_EQ(events.size(), 4U);
    EXPECT_EQ(events[2], late);
    EXPECT_EQ(events[3], cut);
    EXPECT_NEAR(events[0].time, 5.0, 0.3);
    ASSERT_EQ(found.tuned.scene.curves.emission.size(), 1U);
    EXPECT_EQ(found.tuned.scene.curves.emission[0].value, 0.5);
}

TEST(Proposal, SmokeThatIsThereAtFirstCameBefore) {
    std::vector<TargetPoint> target = seen(hidden());
    std::erase_if(target, [](const TargetPoint& aim) { return aim.time < 4.0; });
    ASSERT_GT(target.front().veil->value, 0.25);
    const Proposal found = of(target);
    EXPECT_THAT(found.tuned.scene.events, testing::Contains(testing::Truly([](const ToolContact& event) {
                    return event.hot() && event.power > 0.0 && event.time >= 2.0 && event.time < 3.6;
                })));
    std::vector<double> times;
    for (const TargetPoint& aim : target) times.push_back(aim.time);
    const std::vector<Amounts> amounts = CoreAmounts(organ()).at(found.tuned, times);
    for (std::size_t i = 0; i < times.size(); ++i)
        EXPECT_NEAR(1.0 - std::exp(-amounts[i].haze), target[i].veil->value, 0.04) << times[i] << " s";
}

TEST(Proposal, ABurstTakesTheNearestStroke) {
    document::Content start = scene();
    start.scene.events[1].time = 12.0;
    start.scene.events.push_back(
        {.action = ToolAction::coagulate, .time = 2.5, .duration = 1.0, .position = {-28, 0, 0}, .to = {-28, 0, 0}});
    const Proposal found = propose(start, organ(), seen(hidden()), {.aspect = aspect});
    EXPECT_NEAR(found.tuned.scene.events[2].time, 2.0, 0.3);
    EXPECT_EQ(found.tuned.scene.events[2].power, 1.0);
    EXPECT_EQ(found.tuned.scene.events[1].power, 0.0);
    EXPECT_THAT(texts_of(found.lines),
                testing::Contains("tools: event 2 is silenced, power and strength 0: the smoke of the "
                                  "reference is explained without"));
}

TEST(Proposal, WhatAHotStrokeOpensStaysWhereNoBleedingIsSeen) {
    document::Content start = scene(), clear = hidden();
    start.scene.events[1].action = ToolAction::cauterise, start.scene.events[1].strength = 0.7;
    clear.scene.events.erase(clear.scene.events.begin());
    const Proposal found = propose(start, organ(), seen(clear), {.aspect = aspect});
    EXPECT_NEAR(found.tuned.scene.events[1].time, 2.0, 0.3);
    EXPECT_EQ(found.tuned.scene.events[1].strength, 0.7);
    EXPECT_EQ(propose(start, organ(), seen(hidden()), {.aspect = aspect}).tuned.scene.events[1].strength, 0.0)
        << "but where blood is seen, cuts explain it";
}

TEST(Proposal, AddsToolsInViewAndTakesAwayOthers) {
    document::Content truth = hidden();
    truth.scene.events.push_back(
        {.action = ToolAction::coagulate, .time = 11.0, .duration = 2.0, .position = {-28, 0, 0}, .to = {-28, 0, 0}});
    const Proposal more = of(seen(truth));
    ASSERT_EQ(more.tuned.scene.events.size(), 3U) << testing::PrintToString(texts_of(more.lines));
    const ToolContact& added = more.tuned.scene.events[2];
    EXPECT_TRUE(added.hot());
    EXPECT_NEAR(added.time, 11.0, 0.3);
    EXPECT_NEAR(added.end(), 13.0, 0.4);
    for (const ToolContact& event : scene().scene.events)
        EXPECT_GE(glm::distance(added.position, event.position), 15.0);

    document::Content clear = scene();
    clear.scene.events.clear();
    const Proposal none = of(seen(clear));
    EXPECT_EQ(none.tuned.scene.events[0], scene().scene.events[0]) << "nothing tells of blood";
    EXPECT_EQ(none.tuned.scene.events[1].power, 0.0);
    EXPECT_THAT(texts_of(none.lines), testing::Contains(testing::HasSubstr("no smoke")));
    EXPECT_THAT(texts_of(none.lines), testing::Contains("blood: no bleeding is seen, it stays as it is"));
}

TEST(Proposal, BloodOfAMomentIsNoWound) {
    document::Content clear = hidden();
    clear.scene.events.erase(clear.scene.events.begin());
    std::vector<TargetPoint> target = seen(clear);
    for (TargetPoint& aim : target)
        if (aim.time > 4.9 && aim.time < 5.7) aim.blood = around(0.06, 0.02);  // as an instrument's red glare
    const Proposal found = propose(clear, organ(), target, {.aspect = aspect});
    EXPECT_THAT(texts_of(found.lines), testing::Contains("blood: no bleeding is seen, it stays as it is"));
    ASSERT_EQ(found.tuned.scene.events.size(), 1U);
    EXPECT_EQ(found.tuned.preset.bleeding.max_extent, clear.preset.bleeding.max_extent);
    for (TargetPoint& aim : target)
        if (aim.time > 4.9) aim.blood = around(0.06, 0.02);
    EXPECT_GT(propose(clear, organ(), target, {.aspect = aspect}).tuned.scene.events.size(), 1U) << "but this is one";
}

TEST(Proposal, SeesThroughAHazyBaseline) {
    const Proposal found = of(seen(hidden(), 0.03));
    EXPECT_NEAR(found.veil_offset, 0.03, 0.016);
    EXPECT_NEAR(found.tuned.scene.events[1].time, 2.0, 0.3);
    EXPECT_NEAR(found.tuned.preset.smoke.haze.accumulation, 0.25, 0.04);
}

TEST(Proposal, SaysWhatIsNotDetermined) {
    document::Content truth = hidden();
    truth.scene.events[1].duration = 10.0;
    std::vector<TargetPoint> target = seen(truth);
    std::erase_if(target, [](const TargetPoint& aim) { return aim.time > 7.6; });
    const Proposal found = of(target);
    EXPECT_EQ(found.tuned.preset.smoke.haze.ventilation, scene().preset.smoke.haze.ventilation);
    EXPECT_THAT(texts_of(found.lines), testing::Contains(testing::HasSubstr("smoke.haze.ventilation: not determined")));
    EXPECT_THAT(texts_of(found.lines), testing::Contains(testing::HasSubstr("bleeding.max_extent: not determined")));
}

TEST(Proposal, LeavesWhatIsNotMeasurable) {
    std::vector<TargetPoint> target = seen(hidden());
    for (TargetPoint& aim : target) aim.blood.reset(), aim.veil.reset();
    const Proposal found = of(target);
    EXPECT_EQ(found.tuned.scene.events, scene().scene.events);
    EXPECT_EQ(write_preset(found.tuned.preset), write_preset(scene().preset));
    EXPECT_EQ(found.lines.size(), 2U);
}

/// What a proposal says of the offset; empty: nothing.
std::string of_offset(const Proposal& found) {
    for (const ProposalLine& line : found.lines)
        if (line.about == About::offset) return line.text;
    return {};
}

TEST(Proposal, NamesTheOffsetWhereTheReferenceIsTheSceneShifted) {
    const document::Content start = hidden();
    document::Content later = start;
    for (ToolContact& event : later.scene.events) event.time += 1.6;
    EXPECT_EQ(of_offset(propose(start, organ(), seen(later), {.aspect = aspect})),
              "reference.offset: blood and veil of the reference come 1.6 s later than the scene's: an offset that is "
              "1.6 s more brings them together instead of moving tools");
    EXPECT_EQ(of_offset(propose(later, organ(), seen(start), {.aspect = aspect})),
              "reference.offset: blood and veil of the reference come 1.6 s earlier than the scene's: an offset that "
              "is 1.6 s less brings them together instead of moving tools");
    EXPECT_EQ(of_offset(propose(start, organ(), seen(start), {.aspect = aspect})), "");
    EXPECT_EQ(of_offset(of(seen(hidden()))), "") << "blood comes later by more than smoke does";
}

TEST(Proposal, SaysThatAnEvenReferenceTellsNoOffset) {
    std::vector<TargetPoint> target = seen(scene());
    for (TargetPoint& aim : target) aim.blood = around(0.06, 0.004), aim.veil = around(0.0, 0.03);
    EXPECT_EQ(of_offset(of(target)),
              "reference.offset: not determined, blood of the reference does not change beyond the error of measuring, "
              "so any fits as well; hold a frame of the reference and align it by eye");
    for (TargetPoint& aim : target) aim.blood = around(0.0, 0.004);
    EXPECT_EQ(of_offset(of(target)), "") << "nothing is seen that could be late";
}

FitInput fit_of(const document::Content& start, const document::Content& truth, std::vector<std::string> keys) {
    return {.start = start,
            .parameters = free_parameters(start, keys),
            .target = seen(truth),
            .organ = organ(),
            .aspect = aspect};
}

std::vector<std::string> keys_of(const FitInput& input) {
    std::vector<std::string> keys;
    for (const FreeParameter& p : input.parameters) keys.push_back(p.key);
    return keys;
}

TEST(BeginWithProposal, WhenMovedToolsWorkIsFoundMoreExactly) {
    FitInput input = fit_of(scene(), hidden(), {"bleeding.speed", "events.0.time"});
    const std::vector<std::string> lines = texts_of(begin_with_proposal(input));
    EXPECT_THAT(keys_of(input),
                testing::UnorderedElementsAre("bleeding.speed", "events.0.time", "events.1.time", "events.1.duration"));
    EXPECT_EQ(input.before->scene.events, scene().scene.events);
    EXPECT_NEAR(input.start.scene.events[1].time, 2.0, 0.3);
    EXPECT_THAT(lines, testing::Contains(testing::HasSubstr("smoke: from")));
}

TEST(BeginWithProposal, StrokesOfSeveralContactsStayTogether) {
    document::Content start = scene();
    const ToolContact& burn = start.scene.events[1];
    start.scene.events.push_back(
        {.action = burn.action, .time = burn.end(), .duration = 1.0, .position = burn.to, .to = {28, 0, 8}});
    FitInput input = fit_of(start, hidden(), {"bleeding.speed"});
    begin_with_proposal(input);
    EXPECT_THAT(keys_of(input), testing::UnorderedElementsAre("bleeding.speed", "events.0.time"));
}

TEST(BeginWithProposal, ToolsStayWhereTheyMayNotMove) {
    FitInput input = fit_of(scene(), hidden(), {"smoke.haze.accumulation"});
    const std::vector<std::string> lines = texts_of(begin_with_proposal(input, false));
    EXPECT_THAT(keys_of(input), testing::ElementsAre("smoke.haze.accumulation"));
    EXPECT_EQ(input.start.scene.events, scene().scene.events);
    EXPECT_THAT(lines, testing::Contains("tools: stay as they are"));
    EXPECT_FALSE(input.before);
    ASSERT_TRUE(input.proposed);
    EXPECT_EQ(input.proposed->scene.events, scene().scene.events);
    EXPECT_NE(input.proposed->preset.smoke.haze.accumulation, input.start.preset.smoke.haze.accumulation);
    document::Content more = scene();
    more.scene.events.push_back(
        {.action = ToolAction::coagulate, .time = 12.0, .position = {-28, 0, 0}, .to = {-28, 0, 0}});
    FitInput of_more = fit_of(more, hidden(), {"smoke.haze.accumulation"});
    EXPECT_THAT(texts_of(begin_with_proposal(of_more, false)),
                testing::Not(testing::Contains(testing::HasSubstr("silenced"))));
}

std::vector<double> times_of(const FitInput& input) {
    std::vector<double> times;
    for (const TargetPoint& aim : input.target) times.push_back(aim.time);
    return times;
}

DrawCurve ideal_camera() {
    return
        [core = std::make_shared<CoreAmounts>(organ())](const document::Content& tuned, std::span<const double> times) {
            const std::vector<Amounts> amounts = core->at(tuned, times);
            const double share = share_per_mm2(tuned.scene.camera, aspect, {0, 0, 0}, {0, 1, 0});
            std::vector<FrameAmounts> frames;
            for (std::size_t i = 0; i < times.size(); ++i)
                frames.push_back({.time = times[i],
                                  .blood = around(share * amounts[i].blood_area, 0.004),
                                  .veil = around(1.0 - std::exp(-amounts[i].haze), 0.03)});
            return std::optional(frames);
        };
}

TEST(BeginWithProposal, AToolThatWasNotThereHasNoValueBefore) {
    document::Content start = scene();
    start.scene.events.pop_back();
    document::Content truth = hidden();
    truth.preset = start.preset;
    FitInput input = fit_of(start, truth, {"smoke.haze.accumulation"});
    begin_with_proposal(input);
    ASSERT_EQ(input.start.scene.events.size(), 2U);
    input.draw = ideal_camera();
    const FitResult found = fit(input);
    const auto at = std::find_if(found.parameters.begin(), found.parameters.end(),
                                 [](const FittedParameter& p) { return p.parameter.key == "events.1.time"; });
    ASSERT_NE(at, found.parameters.end());
    EXPECT_EQ(at->before, input.start.scene.events[1].time);
    EXPECT_NEAR(at->after, 2.0, 0.05);
    EXPECT_NEAR(found.tuned.scene.events[1].duration, 4.0, 0.15);
}

/// Two burns with a short rest between look like one.
TEST(BeginWithProposal, ToolsThatAreNearerThanTheProposedStay) {
    document::Content truth = hidden();
    ToolContact again = truth.scene.events[1];
    truth.scene.events[1].duration = 1.7, truth.scene.events[1].strength = 1.0;
    again.time = 4.1, again.position = again.to = {-28, 0, 0}, again.duration = 1.9;
    truth.scene.events.push_back(again);
    document::Content start = truth;
    start.preset = scene().preset;
    const std::vector<std::string> keys = {"bleeding.speed", "bleeding.max_extent", "smoke.haze.accumulation",
                                           "smoke.haze.ventilation"};
    FitInput input = fit_of(start, truth, keys);
    begin_with_proposal(input);
    EXPECT_NE(input.start.scene.events, start.scene.events);
    EXPECT_GT(input.of_proposal, 0U);
    input.draw = ideal_camera();
    const FitResult found = fit(input);
    EXPECT_TRUE(found.proposal_left);
    EXPECT_EQ(found.tuned.scene.events, start.scene.events);
    EXPECT_EQ(found.parameters.size(), keys.size());
    EXPECT_NEAR(found.tuned.preset.bleeding.speed, truth.preset.bleeding.speed, 0.1);
    EXPECT_NEAR(found.tuned.preset.smoke.haze.ventilation, truth.preset.smoke.haze.ventilation, 0.02);
    EXPECT_EQ(found.before.size(), input.target.size());
}

TEST(BeginWithProposal, BloodThatIsNotSeenMovesNothingFromTheFirstSearchOn) {
    FitInput input = fit_of(scene(), hidden(), {"bleeding.speed", "bleeding.max_extent", "smoke.haze.accumulation"});
    for (TargetPoint& aim : input.target) aim.blood = around(0.02 * aim.time / seconds, 0.05);  // never above nothing
    begin_with_proposal(input);
    for (const int most : {1000, 2}) {  // to its end, and ended early
        int drawn = 0;
        input.draw = [&drawn, most, camera = ideal_camera()](const document::Content& tuned,
                                                             std::span<const double> times) {
            return ++drawn > most ? std::optional<std::vector<FrameAmounts>>() : camera(tuned, times);
        };
        const FitResult found = fit(input);
        EXPECT_EQ(found.ended_early, most == 2);
        EXPECT_EQ(found.tuned.preset.bleeding.speed, scene().preset.bleeding.speed) << most;
        EXPECT_EQ(found.tuned.preset.bleeding.max_extent, scene().preset.bleeding.max_extent) << most;
        EXPECT_NE(found.tuned.preset.smoke.haze.accumulation, scene().preset.smoke.haze.accumulation) << most;
    }
}

TEST(BeginWithProposal, ASceneThatIsTheReferenceStaysAsItIs) {
    FitInput input = fit_of(hidden(), hidden(), {"bleeding.speed", "bleeding.threshold", "smoke.haze.ventilation"});
    begin_with_proposal(input);
    input.start.scene.events[1].time += 0.3;  // as a worse proposal would have it
    input.draw = ideal_camera();
    const FitResult found = fit(input);
    EXPECT_TRUE(found.proposal_left);
    EXPECT_EQ(found.tuned.scene.events, hidden().scene.events);
    EXPECT_EQ(found.tuned.preset.bleeding.threshold, hidden().preset.bleeding.threshold);
    EXPECT_NEAR(found.tuned.preset.bleeding.speed, hidden().preset.bleeding.speed, 0.05);
    EXPECT_LE(found.curves, 4) << "two beginnings, and little to learn";
}

TEST(BeginWithProposal, ToolsThatAreFartherThanTheProposedMove) {
    FitInput input = fit_of(scene(), hidden(), {"bleeding.speed", "smoke.haze.accumulation", "smoke.haze.ventilation"});
    begin_with_proposal(input);
    input.draw = ideal_camera();
    const FitResult found = fit(input);
    EXPECT_FALSE(found.proposal_left);
    EXPECT_NEAR(found.tuned.scene.events[1].time, 2.0, 0.1);
    EXPECT_EQ(found.parameters.size(), input.parameters.size());
    EXPECT_EQ(found.blood_before,
              misfit(input.target, ideal_camera()(scene(), times_of(input)).value(), &TargetPoint::blood));
}

}  // namespace
}  // namespace lapfx::match
