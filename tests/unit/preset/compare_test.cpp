#include "lapfx/authoring/compare.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "lapfx/amounts.h"
#include "lapfx/preset.h"
#include "lapfx/scene.h"
#include "support/meshes.h"

namespace lapfx {
namespace {

/// Another value that the row allows as well.
Value other(const Parameter& row, const void* owner) {
    const Value value = row.get(owner);
    switch (row.kind) {
        case Kind::number: {
            const double now = std::get<double>(value), step = 0.37 * (row.maximum - row.minimum);
            return now + step <= row.maximum ? now + step : now - step;
        }
        case Kind::integer:
        case Kind::choice: {
            const int now = std::get<int>(value);
            return now + 1 <= row.maximum ? now + 1 : now - 1;
        }
        case Kind::boolean:
            return !std::get<bool>(value);
        case Kind::color:
        case Kind::vector: {
            glm::dvec3 v = std::get<glm::dvec3>(value);
            v.x += v.x < row.maximum ? 0.3 * (row.maximum - v.x) : -0.3 * (v.x - row.minimum);
            return v;
        }
        default:
            return std::get<std::string>(value) + "x";
    }
}

using Visit = std::function<void(const std::string& place, const Parameter& row, void* owner)>;

/// Every value of a document; lists have one element each.
void for_each_value(const Table& table, void* owner, const std::string& place, const Visit& visit) {
    for (const Parameter& row : table.rows) visit(place + '/' + std::string(row.key), row, owner);
    for (const Table& child : table.tables) {
        const std::string below = place + '/' + std::string(child.key);
        void* member = child.member(owner);
        if (child.present != nullptr) *child.present(owner) = true;
        if (child.list == nullptr) {
            for_each_value(child, member, below, visit);
            continue;
        }
        if (child.list->size(member) == 0) child.list->resize(member, 1);
        for_each_value(child, child.list->at(member, 0), below + "/0", visit);
    }
}

template <class Document>
Document filled(const Table& table) {
    Document document;
    for_each_value(table, &document, "", [](const std::string&, const Parameter& row, void* owner) {
        if (!row.check(row.get(owner)).empty()) row.set(owner, std::string("file"));  // required, and not there
    });
    return document;
}

template <class Document>
void every_value_is_seen(const Table& table) {
    const Document before = filled<Document>(table);
    Document after = before;
    EXPECT_TRUE(equal(table, &before, &after));
    EXPECT_EQ(difference(table, &before, &after), 0U);
    int count = 0;
    for_each_value(table, &after, "", [&](const std::string& place, const Parameter& row, void* owner) {
        const Value value = row.get(owner);
        row.set(owner, other(row, owner));
        EXPECT_FALSE(equal(table, &before, &after)) << place;
        EXPECT_EQ(difference(table, &before, &after) & (redo::picture | row.redo), redo::picture | row.redo) << place;
        row.set(owner, value);
        EXPECT_TRUE(equal(table, &before, &after)) << place;
        ++count;
    });
    EXPECT_GT(count, 30);
}

TEST(Compare, EveryValueOfAPresetAndOfASceneIsSeen) {
    every_value_is_seen<Preset>(preset_table());
    every_value_is_seen<Scene>(scene_table());
}

TEST(Compare, ListsThatGrowAndPartsThatComeAreSeen) {
    Preset a, b;
    b.smoke.clips.resize(1);
    EXPECT_EQ(difference(preset_table(), &a, &b) & (redo::clips | redo::amounts), redo::clips | redo::amounts)
        << "without clips there is no haze";
    a = b;
    b.smoke.clips[0].keying.luma_low = 77;
    EXPECT_TRUE(equal(preset_table(), &a, &b)) << "an object that is not there has no values";
    b.smoke.clips[0].own_keying = true;
    EXPECT_NE(difference(preset_table(), &a, &b) & redo::clips, 0U);
    a = b;
    b.smoke.clips[0].weight = 2;
    EXPECT_EQ(difference(preset_table(), &a, &b), redo::picture | redo::clips) << "its amounts are the same";
    Scene c, d;
    d.events.resize(1);
    EXPECT_EQ(difference(scene_table(), &c, &d), redo::picture | redo::amounts);
    d = c;
    d.camera.exposure = 2;
    EXPECT_EQ(difference(scene_table(), &c, &d), unsigned{redo::picture});
}

TEST(Compare, ValuesThatNoRowAllowsAreComparedToo) {
    Preset a, b;
    a.bleeding.speed = b.bleeding.speed = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(equal(preset_table(), &a, &b)) << "the same";
    b.bleeding.speed = 1;
    EXPECT_FALSE(equal(preset_table(), &a, &b));
    a.bleeding.speed = 0.0, b.bleeding.speed = -0.0;
    EXPECT_TRUE(equal(preset_table(), &a, &b)) << "a file has one zero";
}

/// The rows say what amounts depend on: every row that changes them says so.
TEST(Compare, AmountsChangeWithNoValueThatDoesNotSaySo) {
    const Organ organ = test::plane(60.0, 40);
    Preset preset = filled<Preset>(preset_table());
    preset.smoke.clips[0].file = "smoke.mkv";
    preset.bleeding.pulse_rate = 1.0;
    preset.bleeding.pulse_strength = 0.5;
    preset.smoke.haze.accumulation = 0.3;
    const std::vector<ToolContact> contacts = {
        {.action = ToolAction::cut, .time = 0.0, .duration = 0.5, .position = {0, 0, 0}, .to = {6, 0, 0}},
        {.action = ToolAction::cauterise, .time = 1.0, .duration = 2.0, .position = {-9, 0, 0}, .to = {-6, 0, 3}},
        {.action = ToolAction::coagulate, .time = 3.0, .duration = 3.0, .position = {2, 0, 0}, .to = {2, 0, 0}},
        {.action = ToolAction::suction, .time = 6.0, .duration = 1.0, .position = {4, 0, 0}, .to = {4, 0, 0}},
        {.action = ToolAction::irrigation, .time = 7.5, .duration = 0.5, .position = {6, 0, 5}, .to = {6, 0, 5}}};
    AmountsModel model(organ, {.gravity = {0.3, -1, 0}});
    const auto amounts = [&](const Preset& of) {
        model.set(of, contacts, {});
        std::vector<double> all;
        for (const double time : {0.4, 1.7, 2.8, 5.0, 6.6, 8.5, 10.0}) {
            const Amounts a = model.at(time);
            for (const double value : {a.blood_area, a.blood_volume, a.haze, a.emission, a.burnt_area, double(a.wounds),
                                       double(a.bleeding_wounds)})
                all.push_back(value);
        }
        return all;
    };
    const std::vector<double> before = amounts(preset);
    int changing = 0;
    const Table& table = preset_table();
    Preset changed = preset;
    for_each_value(table, &changed, "", [&](const std::string& place, const Parameter& row, void* owner) {
        if (row.kind == Kind::text || row.kind == Kind::path) return;
        const Value value = row.get(owner);
        row.set(owner, other(row, owner));
        if (check(table, &changed).empty() && amounts(changed) != before) {
            ++changing;
            EXPECT_NE(difference(table, &preset, &changed) & redo::amounts, 0U) << place;
        }
        row.set(owner, value);
    });
    EXPECT_GT(changing, 15);
}

}  // namespace
}  // namespace lapfx
