// Blood is kept for the scenes asked for before; what is told must be as if nothing were kept.
#include "match/scene/core_amounts.h"

#include <gtest/gtest.h>

#include <functional>

#include "lapfx/prepared_organ.h"
#include "support/meshes.h"

namespace lapfx::match {
namespace {

const std::shared_ptr<const PreparedOrgan>& organ() {
    static const std::shared_ptr<const PreparedOrgan> one = prepare_organ(test::plane(80.0, 40));
    return one;
}

document::Content scene() {
    document::Content tuned;
    tuned.preset.smoke.clips = {{.file = "smoke.mkv"}};  // there is no smoke without a clip; it is not opened
    tuned.scene.events = {{.action = ToolAction::cut, .time = 0.5, .duration = 0.0},
                          {.action = ToolAction::coagulate, .time = 1.0, .duration = 2.0, .position = {20.0, 0.0, 0.0}},
                          {.action = ToolAction::suction, .time = 4.0, .duration = 1.0}};
    return tuned;
}

std::vector<Amounts> anew(const document::Content& tuned, std::span<const double> times) {
    AmountsModel model(organ(), {.gravity = tuned.scene.gravity});
    model.set(tuned.preset, tuned.scene.events, tuned.scene.curves);
    std::vector<Amounts> amounts;
    for (const double time : times) amounts.push_back(model.at(time));
    return amounts;
}

void expect_same(const std::vector<Amounts>& told, const std::vector<Amounts>& expected, const std::string& of) {
    ASSERT_EQ(told.size(), expected.size()) << of;
    for (std::size_t i = 0; i < told.size(); ++i)
        for (const AmountRow& row : amount_rows)
            EXPECT_EQ(row.member.of(told[i]), row.member.of(expected[i])) << row.key << " of " << of << ", " << i;
}

TEST(CoreAmounts, WhatIsKeptIsTheSameAsWorkedOutAnew) {
    using Change = std::function<void(document::Content&)>;
    const std::vector<std::pair<std::string, Change>> changes{
        {"accumulation", [](document::Content& t) { t.preset.smoke.haze.accumulation *= 3.0; }},
        {"fat", [](document::Content& t) { t.preset.smoke.plume.fat_gain += 1.0; }},
        {"emission",
         [](document::Content& t) {
             t.scene.curves.emission = {{0.0, 0.5}};
         }},
        {"speed", [](document::Content& t) { t.preset.bleeding.speed *= 2.0; }},
        {"threshold", [](document::Content& t) { t.preset.bleeding.threshold += 1.0; }},
        {"vessels", [](document::Content& t) { t.preset.vessels.vessel_threshold = 0.0; }},
        {"heat", [](document::Content& t) { t.preset.cautery.heat_rate *= 2.0; }},
        {"power",
         [](document::Content& t) {
             t.scene.curves.cautery_power = {{0.0, 0.5}};
         }},
        {"strength",
         [](document::Content& t) {
             t.scene.curves.bleeding_strength = {{0.0, 0.3}};
         }},
        {"event", [](document::Content& t) { t.scene.events[0].time = 1.5; }},
        {"gravity",
         [](document::Content& t) {
             t.scene.gravity = {1.0, 0.0, 0.0};
         }},
    };
    const std::vector<double> times{0.4, 1.2, 2.0, 4.6, 6.0};
    CoreAmounts core(organ());
    const document::Content base = scene();
    for (const auto& [name, change] : changes) {
        document::Content changed = base;
        change(changed);
        expect_same(core.at(base, times), anew(base, times), "before " + name);
        expect_same(core.at(changed, times), anew(changed, times), name);
        expect_same(core.at(base, times), anew(base, times), "after " + name);
    }
    const std::vector<double> others{3.0, 5.0};
    expect_same(core.at(base, others), anew(base, others), "other times");
    EXPECT_EQ(core.evaluations(), 3 * static_cast<int>(changes.size()) + 1);
    EXPECT_EQ(core.worked_out(), 1 + 8 + 1) << "smoke alone is no other blood";
}

TEST(CoreAmounts, WhatIsExpectedIsTheSame) {
    std::vector<document::Content> scenes(7, scene());
    for (std::size_t i = 1; i < scenes.size(); ++i)
        scenes[i].preset.bleeding.speed *= 1.0 + 0.1 * static_cast<double>(i / 2);
    scenes[2].preset.smoke.haze.accumulation *= 2.0;
    scenes[5].preset.bleeding.speed = -1.0;
    scenes[6].scene.gravity = {0.0, 0.0, 1.0};
    const std::vector<double> times{1.0, 2.5, 5.0};
    CoreAmounts core(organ());
    core.expect(scenes, times);
    for (std::size_t i = 0; i < scenes.size(); ++i)
        if (i != 5) expect_same(core.at(scenes[i], times), anew(scenes[i], times), std::to_string(i));
    EXPECT_THROW(core.at(scenes[5], times), Error);
    EXPECT_EQ(core.worked_out(), 4) << "0 and 1, 2 and 3, 4, 6";
}

}  // namespace
}  // namespace lapfx::match
