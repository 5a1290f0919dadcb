#include "lapfx/authoring/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "bleeding/bleed_cpu.h"
#include "lapfx/amounts.h"
#include "lapfx/authoring/keying.h"
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
    EXPECT_EQ(difference(preset_table(), &a, &b), redo::picture | redo::smoke | redo::keyed_frame);
    a = b;
    b.smoke.clips[0].weight = 2;
    EXPECT_EQ(difference(preset_table(), &a, &b), redo::picture | redo::smoke) << "its amounts are the same";
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
    AmountsModel kept(organ, {.gravity = {0.3, -1, 0}});
    const auto amounts_of = [&](AmountsModel& model, const Preset& of) {
        model.set(of, contacts, {});
        std::vector<double> all;
        for (const double time : {0.4, 1.7, 2.8, 5.0, 6.6, 8.5, 10.0}) {
            const Amounts a = model.at(time);
            for (const AmountRow& row : amount_rows) all.push_back(row.member.of(a));
        }
        return all;
    };
    const std::vector<double> before = amounts_of(kept, preset);
    int changing = 0;
    const Table& table = preset_table();
    Preset changed = preset;
    for_each_value(table, &changed, "", [&](const std::string& place, const Parameter& row, void* owner) {
        if (row.kind == Kind::text || row.kind == Kind::path) return;
        const Value value = row.get(owner);
        row.set(owner, other(row, owner));
        if (check(table, &changed).empty()) {
            AmountsModel fresh(organ, {.gravity = {0.3, -1, 0}});
            const std::vector<double> after = amounts_of(fresh, changed);
            EXPECT_EQ(amounts_of(kept, changed), after) << place << ": what is kept is as if it were new";
            if (after != before) {
                ++changing;
                EXPECT_NE(difference(table, &preset, &changed) & redo::amounts, 0U) << place;
            }
        }
        row.set(owner, value);
    });
    EXPECT_GT(changing, 15);
}

/// Two sheets with a fold along z, one behind the other and 1.2 mm apart.
Organ folded_sheets() {
    Organ sheet = test::plane(30.0, 30);
    for (glm::vec3& p : sheet.positions) p.y = 0.6f * std::abs(p.x);
    return test::joined(sheet, sheet, {0.0f, 0.0f, 31.2f});
}

/// The rows say themselves what a bleed field keeps: after a change of any it is as if it were new.
TEST(Compare, AKeptBleedFieldIsLikeANewOneWhateverChanges) {
    const Surface surface(folded_sheets());
    const std::vector<Wound> wounds = {{.position = {2, 1.2, 13}}, {.position = {-6, 3.6, 0}, .stop = 0.5}};
    BleedingParameters before;
    before.speed = 4;
    before.max_extent = 7;
    before.pulse_rate = 1.3;
    before.pulse_strength = 0.4;
    before.bridge_gap = 0.5;
    before.coagulation_time = 1;
    const auto seen = [](bleeding::BleedField& field, double time) {
        field.update(time);
        const bleeding::BloodAmount amount = field.amount();
        std::vector<double> all{amount.area, amount.volume, field.dry()};
        for (const glm::vec2& value : field.values()) all.insert(all.end(), {value.x, value.y});
        return all;
    };
    std::vector<std::string> changing;
    for (const Parameter& row : preset_table().find("bleeding")->rows) {
        BleedingParameters after = before;
        row.set(&after, other(row, &after));
        bool changes = false;
        for (const double time : {1.1, 3.2, 12.0}) {  // all is settled at the last one
            const glm::dvec3 down = glm::normalize(glm::dvec3(0.3, -1, 0));
            bleeding::BleedField kept(surface, down), fresh(surface, down);
            kept.set(wounds, before);
            const std::vector<double> first = seen(kept, time);
            kept.set(wounds, after);
            fresh.set(wounds, after);
            const std::vector<double> wanted = seen(fresh, time);
            EXPECT_TRUE(seen(kept, time) == wanted) << row.key << " at " << time << " s";
            changes |= wanted != first;
        }
        if (changes) changing.emplace_back(row.key);
    }
    EXPECT_THAT(changing,
                testing::UnorderedElementsAre("speed", "max_extent", "threshold", "noise_strength", "noise_octaves",
                                              "rivulets", "gravity_bias", "crease_bias", "bridge_gap", "pulse_rate",
                                              "pulse_strength", "coagulation_time", "deep_at", "thickness"))
        << "or the test would not see that one is missing";
}

/// Grey and greenish pixels of every luma.
KeyingFrame frame_of_all() {
    KeyingFrame frame{.size = {48, 32}, .luma = {}, .cb = {}, .cr = {}, .opacity = {}};
    for (int y = 0; y < frame.size.y; ++y)
        for (int x = 0; x < frame.size.x; ++x) {
            frame.luma.push_back(static_cast<float>((5 * x + 40 * (y % 3)) % 256));
            frame.cb.push_back(static_cast<float>(-y));
            frame.cr.push_back(static_cast<float>(-2 * (y % 16)));
        }
    return frame;
}

/// The rows say themselves what a keyed frame is made of.
TEST(Compare, AKeyedFrameChangesWithNoValueThatDoesNotSaySo) {
    const KeyingFrame frame = frame_of_all();
    const auto pictures = [&](const KeyingLook& look) {
        std::vector<float> opacity;
        keyed_opacity(frame, look.keying, look.clip, opacity);
        std::vector<std::uint8_t> all = matte_picture(frame.size, opacity).pixels;
        for (const Image& image :
             {keyed_picture(frame, look, opacity), composite_picture(frame, look, opacity, Image())})
            all.insert(all.end(), image.pixels.begin(), image.pixels.end());
        return all;
    };
    KeyingLook before;
    before.keying = {.luma_low = 20,
                     .luma_high = 180,
                     .key_color = {0.1, 0.7, 0.1},
                     .chroma_low = 5,
                     .chroma_high = 90,
                     .spill = 0.3,
                     .choke = 1,
                     .feather = 1};
    before.clip.file = "clip.mkv";
    before.clip.edge_fade = 0.2;
    before.clip.masks.push_back({.x = 0.2, .y = 0.2, .width = 0.2, .height = 0.2});
    const std::vector<std::uint8_t> first = pictures(before);
    std::vector<std::string> changing;
    KeyingLook after = before;
    const auto look_at = [&](const Table& table, const void* old, void* changed, const std::string& name) {
        for_each_value(table, changed, name, [&](const std::string& place, const Parameter& row, void* owner) {
            if (place.find("/keying/") != std::string::npos) return;  // KeyingLook has one of its own
            const Value value = row.get(owner);
            row.set(owner, other(row, owner));
            if (pictures(after) != first) {
                changing.push_back(place);
                EXPECT_NE(difference(table, old, changed) & redo::keyed_frame, 0U) << place;
            }
            row.set(owner, value);
        });
    };
    const Table& smoke = *preset_table().find("smoke");
    look_at(*smoke.find("keying"), &before.keying, &after.keying, "keying");
    before.clip.own_keying = after.clip.own_keying = true;  // as for_each_value() makes it
    look_at(*smoke.find("clips"), &before.clip, &after.clip, "clip");
    EXPECT_THAT(changing, testing::IsSupersetOf(
                              {"keying/luma_low",    "keying/luma_high", "keying/key_color",   "keying/chroma_low",
                               "keying/chroma_high", "keying/spill",     "keying/choke",       "keying/feather",
                               "clip/polarity",      "clip/source_x",    "clip/source_y",      "clip/edge_fade",
                               "clip/crop/left",     "clip/crop/top",    "clip/crop/right",    "clip/crop/bottom",
                               "clip/masks/0/x",     "clip/masks/0/y",   "clip/masks/0/width", "clip/masks/0/height"}))
        << "or the test would not see that one is missing";
}

}  // namespace
}  // namespace lapfx
