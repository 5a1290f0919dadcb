#include "document/words.h"

#include <gmock/gmock.h>

#include "document/tables.h"

namespace lapfx::document {
namespace {

Step step(std::string name, const Content& before, const Content& after) {
    Step made{.id = 1, .name = std::move(name), .change = {}, .scene = {}, .preset = {}};
    made.change = change_of(made.name, before, after);
    return made;
}

Content content() {
    Content c;
    c.preset.smoke.clips = {{.file = "plume.mp4"}, {.file = "haze.mp4", .role = ClipRole::haze}};
    c.scene.events = {{.action = ToolAction::cauterise, .time = 0.8}, {.action = ToolAction::cut, .time = 3}};
    return c;
}

TEST(Words, AStepSaysOldAndNewValueWithTheUnitOnce) {
    const Content before = content();
    Content after = before;
    after.preset.bleeding.speed = 8.3;
    EXPECT_EQ(title_of(step("Speed", before, after)), "Speed: 4 to 8.3 mm/s");
    EXPECT_EQ(title_of(step("Fit", before, after)), "Fit: Speed 4 to 8.3 mm/s");
    after.preset.bleeding.max_extent = 20;
    after.preset.smoke.keying.luma_low = 20;
    EXPECT_EQ(title_of(step("Randomise", before, after)), "Randomise: 3 values");
    EXPECT_EQ(title_of(step("Nothing", before, before)), "Nothing");
}

TEST(Words, AFaultOfAClipNamesIt) {
    const Preset preset = content().preset;
    EXPECT_EQ(fault_text({"", "/smoke/clips/1/file", "no such file"}, preset), "smoke clip 2, haze.mp4: no such file");
    EXPECT_EQ(fault_text({"", "/smoke/clips/0/edge_fade", "2 is more than 1"}, preset),
              "smoke clip 1, plume.mp4, edge fade: 2 is more than 1");
    EXPECT_EQ(fault_text({"a.json", "/smoke/clips/7", "odd"}, preset), "a.json: /smoke/clips/7: odd");
    EXPECT_EQ(fault_text({"", "/bleeding/speed", "odd"}, preset), "/bleeding/speed: odd");
}

TEST(Words, EventsAndClipsAreNamedByWhatTheyAre) {
    const Content before = content();
    Content after = before;
    after.scene.events[0].time = 1.2;
    EXPECT_EQ(title_of(step("Move event", before, after)), "Move event: cauterise, Time 0.8 to 1.2 s");
    after = before;
    after.preset.smoke.clips.push_back({.file = "clips/third.mp4"});
    EXPECT_EQ(title_of(step("Add clip", before, after)), "Add clip: third.mp4 added");
    after.preset.smoke.clips.erase(after.preset.smoke.clips.begin());
    EXPECT_EQ(title_of(step("Replace", before, after)), "Replace: 2 changes");
    after = before;
    std::swap(after.preset.smoke.clips[0], after.preset.smoke.clips[1]);
    EXPECT_EQ(title_of(step("Clip up", before, after)), "Clip up: in another order");
}

TEST(Words, WhatIsTakenOutOfTheMiddleIsOneDifference) {
    Content before = content();
    for (int i = 0; i < 6; ++i) before.scene.events.push_back({.time = 4.0 + i});
    Content after = before;
    after.scene.events.erase(after.scene.events.begin() + 3);
    const auto all = differences(before, after);
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].kind, Difference::Kind::removed);
    EXPECT_EQ(all[0].before_at, "/events/3");
    EXPECT_EQ(all[0].name, "Event 4 (cauterise)");
    EXPECT_TRUE(all[0].scene);
}

TEST(Words, NamesSayWhereAValueStands) {
    const Content before = content();
    Content after = before;
    after.preset.smoke.keying.luma_low = 17;
    after.preset.smoke.clips[1].weight = 0.25;
    after.preset.smoke.clips[0].own_keying = true;
    after.preset.bleeding.color_thin = {1, 0, 0};
    std::vector<std::string> words;
    for (const Difference& d : differences(before.preset, after.preset))
        words.push_back(d.name + ": " + change_text(d));
    EXPECT_THAT(words, testing::UnorderedElementsAre(
                           "Keying: Luma low: 16 to 17 levels", "Clip 2 (haze.mp4): Weight: 1 to 0.25",
                           "Clip 1 (plume.mp4): Own keying: off to on", testing::StartsWith("Bleeding: ")));
}

/// For any two presets: taking back every difference, the last first, makes them equal.
TEST(Words, EveryDifferenceCanBeTakenBack) {
    for (int variant = 0; variant < 8; ++variant) {
        const Preset before = content().preset;
        Preset after = before;
        if (variant & 1) after.bleeding.speed = 9;
        if (variant & 2) after.smoke.clips.push_back({.file = "new.mp4", .weight = 0.5, .own_keying = true});
        if (variant & 4) after.smoke.clips.erase(after.smoke.clips.begin());
        if (variant == 7) after.smoke.clips[0].own_keying = true;
        for (int round = 0; round < 10 && write_preset(after) != write_preset(before); ++round) {
            const auto all = differences(before, after);
            ASSERT_FALSE(all.empty());
            ASSERT_TRUE(take_back(after, before, all.back())) << all.back().name;
        }
        EXPECT_EQ(write_preset(after), write_preset(before)) << variant;
    }
}

TEST(Words, AReorderedListIsTakenBack) {
    const Preset before = content().preset;
    Preset after = before;
    std::swap(after.smoke.clips[0], after.smoke.clips[1]);
    const auto all = differences(before, after);
    ASSERT_EQ(all.size(), 1U);
    ASSERT_TRUE(take_back(after, before, all[0]));
    EXPECT_EQ(write_preset(after), write_preset(before));
}

TEST(Tables, WhatCanBeReadIsRead) {
    Preset preset;
    const auto told = read_what_can_be(preset_table(), &preset, R"({"format": "lapfx.preset", "version": 1, "name": 3,
        "bleeding": {"speed": 6, "max_extent": -1, "color_thin": "#ff0000", "nonsense": 1},
        "smoke": {"clips": [{"file": "../elsewhere/a.mp4", "keying": {"luma_low": 250, "luma_high": 10}}]}})");
    EXPECT_EQ(preset.bleeding.speed, 6);
    EXPECT_EQ(preset.bleeding.max_extent, BleedingParameters{}.max_extent);
    EXPECT_EQ(preset.bleeding.color_thin, glm::dvec3(1, 0, 0));
    ASSERT_EQ(preset.smoke.clips.size(), 1U);
    EXPECT_EQ(preset.smoke.clips[0].file, "../elsewhere/a.mp4");
    EXPECT_TRUE(preset.smoke.clips[0].own_keying);
    EXPECT_EQ(preset.smoke.clips[0].keying.luma_low, 250) << "rules between values do not matter here";
    EXPECT_THAT(told, testing::UnorderedElementsAre(testing::StartsWith("/name: "),
                                                    testing::StartsWith("/bleeding/max_extent: -1"),
                                                    testing::StartsWith("/bleeding/nonsense: ")));
    EXPECT_THAT(read_what_can_be(preset_table(), &preset, "[[[["), testing::ElementsAre("not JSON"));
}

TEST(Words, AStrokeOfManyContactsIsOneEvent) {
    const Content before = content();
    Content after = before;
    const auto stroke = [&](double start, double x) {
        for (int i = 0; i < 8; ++i)
            after.scene.events.push_back({.action = ToolAction::cauterise,
                                          .time = start + 0.25 * i,
                                          .duration = 0.25,
                                          .position = {x + i, 0, 0},
                                          .to = {x + i + 1, 0, 0}});
    };
    stroke(10, 0);
    EXPECT_EQ(title_of(step("Cauterise", before, after)), "Cauterise: cauterise added");
    EXPECT_EQ(title_of(step("Delete", after, before)), "Delete: cauterise removed");
    stroke(20, 50);
    EXPECT_EQ(title_of(step("Paste", before, after)), "Paste: 2 events added");
}

}  // namespace
}  // namespace lapfx::document
