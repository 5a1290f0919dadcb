// Rules for every row of the tables of presets and scenes.
#include "preset/tables.h"

#include <set>
#include <type_traits>

#include "support/count_members.h"
#include "unit/preset/full_documents.h"
#include "unit/preset/support.h"

namespace lapfx {

namespace {

using test::count_members;
using test::for_each_row;
using test::full_preset;
using test::full_scene;

/// Every member has a row or a table, except `left_out` of them.
template <class T>
void expect_complete(const Table& table, std::size_t left_out = 0) {
    EXPECT_EQ(table.rows.size() + table.tables.size() + left_out, count_members<T>()) << table.name;
    T owner;
    std::set<const void*> addresses;
    for (const Parameter& row : table.rows) addresses.insert(row.member(&owner));
    for (const Table& child : table.tables) addresses.insert(child.member(&owner));
    EXPECT_EQ(addresses.size(), table.rows.size() + table.tables.size()) << table.name;
    for (const void* address : addresses) {
        EXPECT_GE(address, &owner);
        EXPECT_LT(address, &owner + 1);
    }
}

TEST(Tables, EveryMemberOfAPresetHasItsRow) {
    const Table& preset = preset_table();
    expect_complete<Preset>(preset, 1);  // folder
    expect_complete<BleedingParameters>(*preset.find("bleeding"));
    expect_complete<CauteryParameters>(*preset.find("cautery"));
    const Table& smoke = *preset.find("smoke");
    expect_complete<SmokeParameters>(smoke);
    expect_complete<SmokeClip>(*smoke.find("clips"), 1);  // own_keying: whether `keying` exists
    expect_complete<KeyingParameters>(*smoke.find("keying"));
    expect_complete<PlumeParameters>(*smoke.find("plume"));
    expect_complete<HazeParameters>(*smoke.find("haze"));
    expect_complete<ParticleParameters>(*smoke.find("particles"));
    expect_complete<VesselParameters>(*preset.find("vessels"));
}

TEST(Tables, EveryMemberOfASceneHasItsRow) {
    const Table& scene = scene_table();
    expect_complete<Scene>(scene, 1);  // folder
    expect_complete<SceneOrgan>(*scene.find("organ"));
    expect_complete<SceneTool>(*scene.find("tool"));
    expect_complete<SceneCamera>(*scene.find("camera"));
    expect_complete<SceneLight>(*scene.find("light"));
    expect_complete<ToolContact>(*scene.find("events"));
    expect_complete<Curves>(*scene.find("curves"));
    for (const char* key : {"cautery_power", "bleeding_strength", "emission"})
        expect_complete<CurvePoint>(*scene.find("curves")->find(key));
    expect_complete<ReferenceMarks>(*scene.find("reference")->find("marks"));
    expect_complete<ReferenceLoop>(*scene.find("reference")->find("loop"));
    const Table& reference = *scene.find("reference");
    expect_complete<ReferencePlacement>(*reference.find("placement"));
    expect_complete<SceneReference>(reference);
    expect_complete<ComparedRegion>(*reference.find("regions"));
    const Table& measure = *reference.find("measure");
    expect_complete<ReferenceMeasure>(measure);
    expect_complete<BloodQualifier>(*measure.find("blood"));
    expect_complete<MeasuredRegion>(*measure.find("region"));
    expect_complete<LeftOutPart>(*measure.find("parts"));
    expect_complete<PicturePlace>(*measure.find("parts")->find("corners"));
    expect_complete<BloodStroke>(*measure.find("strokes"));
    expect_complete<PicturePlace>(*measure.find("strokes")->find("points"));
}

void expect_sound(const Table& root, void* document) {
    for_each_row(root, document, [](const Parameter& row, void* owner, const std::string& pointer) {
        SCOPED_TRACE(pointer);
        EXPECT_EQ(row.check(row.get(owner)), "") << "its default is not allowed";
        EXPECT_FALSE(row.name.empty());
        EXPECT_FALSE(row.help.empty());
        EXPECT_EQ(row.help.back(), '.');
        EXPECT_EQ(row.unit.find('.'), std::string_view::npos) << "a unit is not a sentence: " << row.unit;
        EXPECT_LE(row.unit.size(), 24U) << "a unit is short: " << row.unit;
        EXPECT_EQ(row.key.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string_view::npos);
        if (row.kind == Kind::text || row.kind == Kind::path) return;
        EXPECT_LT(row.minimum, row.maximum);
        EXPECT_GT(row.step, 0.0);
        EXPECT_LE(row.step, row.maximum - row.minimum);
        if (row.scale == Scale::logarithmic) {
            EXPECT_GT(row.minimum, 0.0);
        }
    });
}

TEST(Tables, RowsAreSoundAndDefaultsAllowed) {
    Preset preset = full_preset();
    expect_sound(preset_table(), &preset);
    EXPECT_TRUE(check(preset_table(), &preset).empty());
    Scene scene = full_scene();
    expect_sound(scene_table(), &scene);
    EXPECT_TRUE(check(scene_table(), &scene).empty());
}

void expect_unique_keys(const Table& table) {
    std::set<std::string_view> keys{"format", "version"};
    for (const Parameter& row : table.rows) EXPECT_TRUE(keys.insert(row.key).second) << row.key;
    for (const Table& child : table.tables) {
        EXPECT_TRUE(keys.insert(child.key).second) << child.key;
        expect_unique_keys(child);
    }
    for (const Rule& rule : table.rules) EXPECT_TRUE(table.find_row(rule.key)) << rule.key;
    if (table.order) {
        EXPECT_TRUE(table.list && table.find_row(table.order->key)) << table.order->key;
    }
    for (const Parameter& row : table.rows)
        if (!row.same_as.empty()) {
            ASSERT_TRUE(table.find_row(row.same_as));
            EXPECT_EQ(table.find_row(row.same_as)->kind, row.kind);
        }
}

TEST(Tables, KeysAreUniqueAndReferencesLeadToRows) {
    expect_unique_keys(preset_table());
    expect_unique_keys(scene_table());
}

TEST(Tables, BleedingRowsHoldTheirRangesAndUnits) {
    const Parameter& speed = *preset_table().find("bleeding")->find_row("speed");
    EXPECT_EQ(speed.minimum, 0.0);
    EXPECT_EQ(speed.maximum, 60.0);
    EXPECT_EQ(speed.unit, "mm/s");
    EXPECT_EQ(preset_table().find("smoke")->find("keying")->find_row("noise_drift")->unit, "clip heights/s");
    EXPECT_EQ(preset_table().find("bleeding")->find_row("noise_scale")->scale, Scale::logarithmic);
    EXPECT_EQ(preset_table().find("bleeding")->find_row("sped"), nullptr);
    EXPECT_EQ(preset_table().find("bleding"), nullptr);
}

}  // namespace

}  // namespace lapfx
