// Areas of blood that the core makes of known wounds, and the wounds found in them.
#include "match/explain/wounds.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "lapfx/amounts.h"
#include "lapfx/authoring/prepared_scene.h"
#include "support/folders.h"
#include "support/meshes.h"

namespace lapfx::match {
namespace {

constexpr double share_per_mm2 = 1e-4;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr glm::dvec3 left{-22.0, 0.0, 0.0}, right{22.0, 0.0, 0.0};

std::shared_ptr<const PreparedOrgan> flat() {
    static const auto one = prepare_organ(test::plane(90.0, 90));
    return one;
}

/// Discs on a plane: no noise, no bias; every cut bleeds equally.
Preset plain(double speed, double max_extent) {
    Preset preset;
    BleedingParameters& b = preset.bleeding;
    b.speed = speed, b.max_extent = max_extent;
    b.noise_strength = b.gravity_bias = b.crease_bias = b.rivulets = 0.0;
    return preset;
}

ToolContact cut(double time, glm::dvec3 place, double strength = 1.0) {
    return {
        .action = ToolAction::cut, .time = time, .duration = 0.0, .position = place, .to = place, .strength = strength};
}

Scene scene_of(std::vector<ToolContact> events, Curves curves = {}) {
    Scene scene;
    scene.events = std::move(events);
    scene.curves = std::move(curves);
    return scene;
}

struct Shown {
    double from = 0.0, to = 12.0;  // s
    double noise = 0.002;          // share of the view
    double step = 0.1;             // s
};

std::vector<BloodPoint> measured(const Scene& scene, const Preset& preset, const Shown& shown = {}) {
    AmountsModel model(flat(), {.gravity = scene.gravity});
    model.set(preset, scene.events, scene.curves);
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, 1.0);
    std::vector<BloodPoint> points;
    for (double time = shown.from; time <= shown.to; time += shown.step)
        points.push_back({time, share_per_mm2 * model.at(time).blood_area + shown.noise * noise(random),
                          std::max(shown.noise, 1e-3)});
    return points;
}

WoundsFound found_in(std::span<const BloodPoint> points, const Scene& scene, const Preset& preset,
                     std::span<const glm::dvec3> elsewhere = {}, double error_lasts = 0.1) {
    return wounds_of(points, {.scene = scene,
                              .preset = preset,
                              .organ = flat(),
                              .share_per_mm2 = share_per_mm2,
                              .elsewhere = elsewhere,
                              .error_lasts = error_lasts});
}

/// The curve of what was found, by the core.
void expect_explained(const WoundsFound& found, Preset preset, const Scene& scene, std::span<const BloodPoint> points,
                      double within) {
    preset.bleeding.speed = found.speed, preset.bleeding.max_extent = found.max_extent;
    AmountsModel model(flat(), {.gravity = scene.gravity});
    model.set(preset, found.events, scene.curves);
    for (const BloodPoint& p : points)
        EXPECT_NEAR(share_per_mm2 * model.at(p.time).blood_area, p.blood, within) << p.time;
}

TEST(Wounds, OneThatEndsIsFound) {
    const Scene truth = scene_of({cut(2.0, left)});
    const auto points = measured(truth, plain(5.0, 14.0));
    const WoundsFound found = found_in(points, scene_of({cut(7.0, left)}), plain(3.0, 20.0));
    ASSERT_EQ(found.wounds.size(), 1U);
    EXPECT_NEAR(found.wounds[0].start, 2.0, 0.2);
    EXPECT_EQ(found.wounds[0].strength, 1.0) << "as the scene has it";
    EXPECT_TRUE(found.wounds[0].start_is_known);
    EXPECT_NEAR(found.wounds[0].start, 2.0, 3.0 * found.wounds[0].start_error);
    EXPECT_LT(found.wounds[0].start_error, 0.1);
    EXPECT_NEAR(found.speed, 5.0, 0.5);
    EXPECT_NEAR(found.speed, 5.0, 3.0 * found.speed_error * found.speed);
    EXPECT_LT(found.speed_error, 0.1);
    EXPECT_TRUE(found.speed_is_known);
    EXPECT_NEAR(found.max_extent, 14.0, 0.3);
    EXPECT_TRUE(found.max_extent_is_known);
    EXPECT_FALSE(found.strengths_differ);
    EXPECT_NEAR(found.error, 1.0, 0.15);
    ASSERT_EQ(found.events.size(), 1U);
    EXPECT_NEAR(found.events[0].time, 2.0, 0.2);
    EXPECT_EQ(found.events[0].position, left);
    expect_explained(found, plain(3.0, 20.0), truth, points, 0.02);
}

TEST(Wounds, SpeedIsOfStrengthOneAtTheStrengthOfTheScene) {
    const auto points = measured(scene_of({cut(2.0, left)}), plain(5.0, 14.0));
    const WoundsFound found = found_in(points, scene_of({cut(2.0, left, 2.0)}), plain(3.0, 20.0));
    ASSERT_EQ(found.wounds.size(), 1U);
    EXPECT_EQ(found.wounds[0].strength, 2.0);
    EXPECT_NEAR(found.speed, 2.5, 0.25);
}

TEST(Wounds, OneThatStillGrowsTellsOnlyTheLeastExtent) {
    const auto points = measured(scene_of({cut(4.0, left)}), plain(2.0, 30.0));
    const WoundsFound more = found_in(points, scene_of({cut(1.0, left)}), plain(4.0, 25.0));
    ASSERT_EQ(more.wounds.size(), 1U);
    EXPECT_FALSE(more.max_extent_is_known);
    EXPECT_NEAR(more.at_least, 16.0, 0.8);
    EXPECT_EQ(more.max_extent, 25.0) << "enough: it is kept";
    EXPECT_NEAR(more.speed, 2.0, 0.2);
    EXPECT_NEAR(more.wounds[0].start, 4.0, 0.3);
    const WoundsFound less = found_in(points, scene_of({cut(1.0, left)}), plain(4.0, 9.0));
    EXPECT_FALSE(less.max_extent_is_known);
    EXPECT_EQ(less.max_extent, less.at_least) << "9 mm are too little";
}

TEST(Wounds, BloodThatNeverGrowsTellsOnlyTheExtent) {
    const auto points = measured(scene_of({cut(1.0, left)}), plain(5.0, 10.0), {.from = 6.0, .to = 14.0});
    const WoundsFound found = found_in(points, scene_of({cut(3.0, left)}), plain(4.0, 16.0));
    ASSERT_EQ(found.wounds.size(), 1U);
    EXPECT_FALSE(found.wounds[0].start_is_known);
    EXPECT_FALSE(found.speed_is_known);
    EXPECT_NEAR(found.speed, 4.0, 1.0) << "about the preset's";
    EXPECT_TRUE(found.max_extent_is_known);
    EXPECT_NEAR(found.max_extent, 10.0, 0.3);
    EXPECT_LT(found.wounds[0].start + 10.0 / found.speed, 6.5) << "it is there from the beginning";
}

TEST(Wounds, TwoAtDifferentTimesAreFound) {
    const Scene truth = scene_of({cut(1.5, left), cut(6.0, right)});
    const auto points = measured(truth, plain(4.0, 12.0));
    const WoundsFound found =
        found_in(points, scene_of({cut(9.0, right), cut(3.0, left)}), plain(6.0, 16.0), std::vector{right});
    ASSERT_EQ(found.wounds.size(), 2U);
    EXPECT_NEAR(found.wounds[0].start, 1.5, 0.2);
    EXPECT_NEAR(found.wounds[1].start, 6.0, 0.2);
    EXPECT_EQ(found.wounds[0].event, 1U) << "the earlier event has the earlier wound";
    EXPECT_EQ(found.wounds[0].position, left);
    EXPECT_NEAR(found.speed, 4.0, 0.4);
    EXPECT_NEAR(found.max_extent, 12.0, 0.4);
    EXPECT_FALSE(found.strengths_differ);
    EXPECT_EQ(found.events.size(), 2U) << "none is added";
    expect_explained(found, plain(6.0, 16.0), truth, points, 0.02);
}

TEST(Wounds, ThatDifferHaveStrengths) {
    const Scene truth = scene_of({cut(1.0, left), cut(5.0, right, 0.4)});
    const auto points = measured(truth, plain(5.0, 12.0), {.to = 14.0});
    const WoundsFound found = found_in(points, scene_of({cut(1.0, left), cut(2.0, right)}), plain(5.0, 16.0));
    ASSERT_EQ(found.wounds.size(), 2U);
    EXPECT_TRUE(found.strengths_differ);
    EXPECT_EQ(found.wounds[0].strength, 1.0) << "that of the first stays";
    EXPECT_NEAR(found.wounds[1].strength, 0.4, 0.05);
    EXPECT_EQ(found.events[1].strength, found.wounds[1].strength);
    EXPECT_NEAR(found.wounds[1].start, 5.0, 0.3);
    EXPECT_NEAR(found.speed, 5.0, 0.5);
}

TEST(Wounds, ThatRunIntoOneAnotherAreFound) {
    const std::vector<glm::dvec3> near{{-6.0, 0.0, 0.0}, {6.0, 0.0, 0.0}};
    const Scene truth = scene_of({cut(1.0, near[0]), cut(5.0, near[1])});
    const auto points = measured(truth, plain(4.0, 13.0), {.noise = 0.002});
    const WoundsFound found = found_in(points, scene_of({cut(2.0, near[0]), cut(3.0, near[1])}), plain(6.0, 20.0));
    ASSERT_EQ(found.wounds.size(), 2U);
    EXPECT_NEAR(found.wounds[0].start, 1.0, 0.2);
    EXPECT_NEAR(found.wounds[1].start, 5.0, 0.3);
    EXPECT_NEAR(found.max_extent, 13.0, 0.6);
    expect_explained(found, plain(6.0, 20.0), truth, points, 0.012);
}

TEST(Wounds, ThatTheSceneHasNoStrokeForAreCutsElsewhere) {
    const auto points = measured(scene_of({cut(1.5, left), cut(6.0, right)}), plain(4.0, 12.0));
    const WoundsFound found = found_in(points, scene_of({cut(3.0, left)}), plain(4.0, 12.0), std::vector{right});
    ASSERT_EQ(found.wounds.size(), 2U);
    ASSERT_EQ(found.events.size(), 2U);
    EXPECT_FALSE(found.wounds[0].added);
    EXPECT_TRUE(found.wounds[1].added);
    EXPECT_EQ(found.wounds[1].event, 1U);
    EXPECT_EQ(found.events[1].action, ToolAction::cut);
    EXPECT_EQ(found.events[1].position, right);
    EXPECT_NEAR(found.events[1].time, 6.0, 0.2);
    EXPECT_EQ(found_in(points, scene_of({cut(3.0, left)}), plain(4.0, 12.0)).wounds.size(), 1U) << "nowhere else";
}

TEST(Wounds, StrokesThatAreTooManyDoNotBleed) {
    const auto points = measured(scene_of({cut(2.0, left)}), plain(5.0, 14.0));
    std::vector events{cut(1.0, left), cut(3.0, right),
                       ToolContact{.action = ToolAction::suction, .time = 30.0, .position = right, .to = right}};
    const WoundsFound found = found_in(points, scene_of(events), plain(5.0, 14.0));
    ASSERT_EQ(found.wounds.size(), 1U);
    EXPECT_EQ(found.events[1].strength, 0.0);
    EXPECT_EQ(found.events[1].time, 3.0);
    EXPECT_EQ(found.events[2], events[2]);
}

TEST(Wounds, AStrokeStaysWhole) {
    ToolContact first = cut(4.0, left, 0.5), second = cut(5.0, left + glm::dvec3(0, 0, 6), 1.0);
    first.duration = second.duration = 1.0;
    first.to = second.position;
    second.to = left + glm::dvec3(0, 0, 12);
    const Preset preset = plain(4.0, 12.0);
    const auto points = measured(scene_of({first, second}), preset);
    ToolContact early = first, late = second;
    early.time = 1.0, late.time = 2.0;
    const WoundsFound found = found_in(points, scene_of({late, early}), preset);
    ASSERT_EQ(found.wounds.size(), 1U);
    EXPECT_EQ(found.wounds[0].event, 1U);
    EXPECT_NEAR(found.events[1].time, 4.0, 0.2);
    EXPECT_NEAR(found.events[0].time - found.events[1].time, 1.0, 1e-9);
    EXPECT_EQ(found.events[1].strength, 0.5);
    EXPECT_EQ(found.events[0].strength, 1.0);
    EXPECT_NEAR(found.speed, 4.0, 0.4);
    EXPECT_NEAR(found.max_extent, 12.0, 0.6);
}

TEST(Wounds, StrokesThatOpenNoneAreTold) {
    const auto points = measured(scene_of({cut(2.0, left)}), plain(5.0, 14.0));
    const glm::dvec3 beside{0.0, 60.0, 0.0};
    const WoundsFound found = found_in(points, scene_of({cut(1.0, beside), cut(3.0, left)}), plain(5.0, 14.0));
    EXPECT_EQ(found.open_nothing, std::vector<std::size_t>{0});
    EXPECT_EQ(found.events[0], cut(1.0, beside));
    ASSERT_EQ(found.wounds.size(), 1U);
    EXPECT_EQ(found.wounds[0].event, 1U);
    EXPECT_NEAR(found.wounds[0].start, 2.0, 0.2);
}

TEST(Wounds, OneThatOnlyBleedsIntoBloodIsNotProposed) {
    const auto points = measured(scene_of({cut(1.5, left), cut(6.0, right)}), plain(4.0, 12.0));
    // Another wound counts for the one; the other one opens within blood that is there.
    for (const double aside : {0.3, 2.0}) {
        const std::vector<glm::dvec3> elsewhere{left + glm::dvec3(aside, 0, 0), right};
        const WoundsFound found = found_in(points, scene_of({cut(3.0, left)}), plain(4.0, 12.0), elsewhere);
        ASSERT_EQ(found.wounds.size(), 2U) << aside;
        EXPECT_EQ(found.wounds[1].position, right) << aside;
        EXPECT_NEAR(found.wounds[1].start, 6.0, 0.2) << aside;
        EXPECT_EQ(found.events.size(), 2U) << aside;
    }
}

TEST(Wounds, HeatThatDoesNotDivideOpensNone) {
    const ToolContact gentle{
        .action = ToolAction::cauterise, .time = 1.0, .duration = 2.0, .position = right, .to = right, .power = 0.1};
    const auto points = measured(scene_of({cut(2.0, left)}), plain(5.0, 14.0));
    const WoundsFound found = found_in(points, scene_of({gentle, cut(8.0, left)}), plain(5.0, 14.0));
    EXPECT_EQ(found.open_nothing, std::vector<std::size_t>{0});
    EXPECT_EQ(found.events[0], gentle);
    ASSERT_EQ(found.wounds.size(), 1U);
    EXPECT_EQ(found.wounds[0].event, 1U);
}

TEST(Wounds, OneThatAClipHoldsIsNotProposed) {
    const ToolContact clip{.action = ToolAction::clip, .time = 0.0, .duration = 0.0, .position = left, .to = left};
    const auto points = measured(scene_of({cut(2.0, right)}), plain(5.0, 14.0));
    const WoundsFound found = found_in(points, scene_of({clip, cut(1.0, left), cut(8.0, right)}), plain(5.0, 14.0));
    EXPECT_EQ(found.open_nothing, std::vector<std::size_t>{1}) << "alone it would open one";
    EXPECT_EQ(found.events[1], cut(1.0, left));
    ASSERT_EQ(found.wounds.size(), 1U);
    EXPECT_EQ(found.wounds[0].event, 2U);
    EXPECT_NEAR(found.wounds[0].start, 2.0, 0.2);
}

TEST(Wounds, ThatTheSceneCoagulatesGrowNoFarther) {
    const ToolContact coagulate{
        .action = ToolAction::coagulate, .time = 5.0, .duration = 2.0, .position = left, .to = left};
    const Preset preset = plain(3.0, 20.0);
    const auto points = measured(scene_of({cut(2.0, left), coagulate}), preset);
    const WoundsFound found = found_in(points, scene_of({cut(3.5, left), coagulate}), plain(5.0, 20.0));
    ASSERT_EQ(found.wounds.size(), 1U);
    EXPECT_NEAR(found.wounds[0].start, 2.0, 0.2);
    EXPECT_NEAR(found.speed, 3.0, 0.3);
    EXPECT_EQ(found.events[1], coagulate);
    expect_explained(found, preset, scene_of({}), points, 0.012);
}

TEST(Wounds, AStaircaseHasOneForEachStep) {
    const std::vector<glm::dvec3> places{{-25, 0, -25}, {25, 0, -25}, {-25, 0, 25}, {25, 0, 25}};
    std::vector<ToolContact> events, before;
    for (std::size_t i = 0; i < places.size(); ++i) {
        events.push_back(cut(2.0 + 6.0 * static_cast<double>(i), places[i]));
        before.push_back(cut(1.0 + static_cast<double>(i), places[i]));
    }
    const Scene truth = scene_of(events);
    const auto points = measured(truth, plain(6.0, 12.0), {.to = 28.0});
    const WoundsFound found = found_in(points, scene_of(before), plain(4.0, 16.0));
    ASSERT_EQ(found.wounds.size(), 4U) << "one slow wound is not enough, and two are no better";
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found.wounds[i].start, events[i].time, 0.25) << i;
    EXPECT_NEAR(found.max_extent, 12.0, 0.3);
    expect_explained(found, plain(4.0, 16.0), truth, points, 0.012);
}

TEST(Wounds, OfHeatOpenLaterThanTheirEventBegins) {
    Preset preset = plain(4.0, 12.0);
    const ToolContact burn{.action = ToolAction::cauterise, .time = 3.0, .duration = 2.0, .position = left, .to = left};
    const auto points = measured(scene_of({burn}), preset);
    ToolContact early = burn;
    early.time = 1.0;
    const WoundsFound found = found_in(points, scene_of({early}), preset);
    AmountsModel model(flat());
    model.set(preset, std::vector{burn});
    model.at(10.0);
    ASSERT_EQ(model.wounds().size(), 1U);
    ASSERT_EQ(found.wounds.size(), 1U);
    EXPECT_GT(model.wounds()[0].wound.start, 3.3);
    EXPECT_NEAR(found.wounds[0].start, model.wounds()[0].wound.start, 0.2);
    EXPECT_NEAR(found.events[0].time, 3.0, 0.2);
}

TEST(Wounds, FollowTheFactorOfTheScene) {
    Curves halting;
    halting.bleeding_strength = {{3.0, 1.0}, {4.0, 0.0}, {6.0, 0.0}, {7.0, 1.0}};
    const auto points = measured(scene_of({cut(2.0, left)}, halting), plain(4.0, 12.0));
    const WoundsFound found = found_in(points, scene_of({cut(1.0, left)}, halting), plain(6.0, 16.0));
    ASSERT_EQ(found.wounds.size(), 1U) << "that it goes on growing is no second wound";
    EXPECT_NEAR(found.wounds[0].start, 2.0, 0.2);
    EXPECT_NEAR(found.speed, 4.0, 0.4);
    EXPECT_NEAR(found.max_extent, 12.0, 0.4);
}

/// Folds, vessels, heat, a stroke that opens several wounds, and three that run into one another.
TEST(Wounds, OfTheSampleSceneExplainItsBlood) {
    const Scene truth = load_scene(test::source_folder() / "samples/lagb.scene.json");
    const Preset preset = load_preset(test::source_folder() / "presets/gastric_banding.json");
    const auto organ = prepare_organ(truth, preset.vessels);
    const double share = share_per_mm2 / 2.0;
    const auto curve = [&](const Preset& of, const std::vector<ToolContact>& events) {
        AmountsModel model(organ, {.gravity = truth.gravity});
        model.set(of, events);
        std::vector<BloodPoint> points;
        for (double time = 0.0; time < 20.0; time += 0.2)
            points.push_back({time, share * model.at(time).blood_area, 0.003});
        return points;
    };
    const std::vector<BloodPoint> points = curve(preset, truth.events);
    Scene scene = truth;
    for (ToolContact& event : scene.events) event.time *= 0.3;
    Preset other = preset;
    other.bleeding.speed *= 0.6, other.bleeding.max_extent *= 1.4;
    const WoundsFound found =
        wounds_of(points, {.scene = scene, .preset = other, .organ = organ, .share_per_mm2 = share});
    EXPECT_LT(found.error, 2.0);
    EXPECT_NEAR(found.speed, preset.bleeding.speed, 1.2);
    EXPECT_NEAR(found.max_extent, preset.bleeding.max_extent, 1.5);
    EXPECT_LT(found.evaluations, 40);
    other.bleeding.speed = found.speed, other.bleeding.max_extent = found.max_extent;
    const std::vector<BloodPoint> again = curve(other, found.events);
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_NEAR(again[i].blood, points[i].blood, 0.015) << points[i].time;
}

TEST(Wounds, AreNotThereWithoutBlood) {
    const Scene scene = scene_of({cut(3.0, left), cut(5.0, right)});
    const auto points = measured(scene_of({}), plain(4.0, 12.0), {.noise = 0.02});
    const WoundsFound found = found_in(points, scene, plain(4.0, 12.0));
    EXPECT_TRUE(found.wounds.empty());
    EXPECT_EQ(found.speed, 4.0);
    EXPECT_EQ(found.max_extent, 12.0);
    for (const ToolContact& event : found.events) EXPECT_EQ(event.strength, 0.0);
    EXPECT_NEAR(found.error, 1.0, 0.15);
}

TEST(Wounds, AreNoMoreThanErrorsThatHangTogetherTell) {
    // From 8 s on the measurement reads a little more, by about its error.
    auto points = measured(scene_of({cut(2.0, left)}), plain(5.0, 14.0), {.noise = 0.0});
    for (BloodPoint& p : points) p.blood += p.time > 8.0 ? 0.01 : 0.0, p.error = 0.008;
    const auto found = [&](double error_lasts) {
        return found_in(points, scene_of({cut(1.0, left)}), plain(5.0, 14.0), std::vector{right}, error_lasts);
    };
    EXPECT_EQ(found(0.1).wounds.size(), 2U) << "forty points say so";
    EXPECT_EQ(found(1.0).wounds.size(), 1U) << "four points do not";
    EXPECT_NEAR(found(1.0).max_extent, 14.0, 0.8);
}

TEST(Wounds, NeedTwoPointsAndAShare) {
    const Scene scene = scene_of({cut(3.0, left)});
    const std::vector<BloodPoint> one{{3.0, 0.2, 0.01}};
    for (const std::span<const BloodPoint> few : {std::span<const BloodPoint>(), std::span<const BloodPoint>(one)}) {
        const WoundsFound found = found_in(few, scene, plain(4.0, 12.0));
        EXPECT_TRUE(found.wounds.empty());
        EXPECT_EQ(found.events, scene.events) << "as they were";
        EXPECT_EQ(found.evaluations, 0);
    }
    const auto points = measured(scene, plain(4.0, 12.0));
    const Preset preset = plain(4.0, 12.0);
    EXPECT_TRUE(wounds_of(points, {.scene = scene, .preset = preset, .organ = flat()}).wounds.empty());
}

TEST(Wounds, PointsThatAreNoneAreLeftOut) {
    const Scene scene = scene_of({cut(3.0, left)});
    const auto points = measured(scene_of({cut(2.0, left)}), plain(5.0, 14.0));
    std::vector<BloodPoint> mixed;
    for (const BloodPoint& p : points) {
        mixed.push_back(p);
        mixed.push_back({p.time - 1.0, 0.9, 0.004});
        mixed.push_back({p.time, 0.9, 0.004});
        mixed.push_back({nan, 0.9, 0.004});
        mixed.push_back({p.time + 0.01, nan, 0.004});
        mixed.push_back({p.time + 0.01, 0.9, nan});
        mixed.push_back({p.time + 0.01, 0.9, 0.0});
    }
    const WoundsFound found = found_in(points, scene, plain(3.0, 20.0));
    const WoundsFound same = found_in(mixed, scene, plain(3.0, 20.0));
    ASSERT_EQ(same.wounds.size(), 1U);
    EXPECT_EQ(same.wounds[0].start, found.wounds[0].start);
    EXPECT_EQ(same.speed, found.speed);
    EXPECT_EQ(same.max_extent, found.max_extent);
    EXPECT_EQ(same.error, found.error);
}

TEST(Wounds, APresetThatIsNotAllowedThrows) {
    const Scene scene = scene_of({cut(3.0, left)});
    const auto points = measured(scene, plain(4.0, 12.0));
    EXPECT_THROW(found_in(points, scene, plain(-1.0, 12.0)), Error);
}

}  // namespace
}  // namespace lapfx::match
