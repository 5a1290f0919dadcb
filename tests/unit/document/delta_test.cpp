#include "document/delta.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "document/document.h"

namespace lapfx::document {
namespace {

using Random = std::mt19937;

/// Any value, also one that the row does not allow: a document may be out of order while it is edited.
void disturb(const Parameter& row, void* owner, Random& random) {
    const auto number = [&] { return std::uniform_real_distribution(row.minimum - 1, row.maximum + 1)(random); };
    void* value = row.member(owner);
    switch (row.kind) {
        case Kind::number:
            *static_cast<double*>(value) = random() % 8 == 0 ? -0.0 : number();
            break;
        case Kind::integer:
            *static_cast<int*>(value) = static_cast<int>(number());
            break;
        case Kind::choice: {
            const int index = static_cast<int>(random() % row.choices.size());
            std::memcpy(value, &index, sizeof index);
            break;
        }
        case Kind::boolean:
            *static_cast<bool*>(value) = random() % 2 == 0;
            break;
        case Kind::color:
        case Kind::vector:
            *static_cast<glm::dvec3*>(value) = {number(), number(), number()};
            break;
        case Kind::text:
        case Kind::path:
            *static_cast<std::string*>(value) = std::string(random() % 40, static_cast<char>('a' + random() % 26));
            break;
    }
}

/// With the chance of 1 in `rarely`: each value, part and list.
void disturb(const Table& table, void* owner, Random& random, unsigned rarely) {
    for (const Parameter& row : table.rows)
        if (random() % rarely == 0) disturb(row, owner, random);
    for (const Table& child : table.tables) {
        if (child.present != nullptr && random() % rarely == 0) *child.present(owner) = !*child.present(owner);
        void* member = child.member(owner);
        if (child.list == nullptr) {
            disturb(child, member, random, rarely);
            continue;
        }
        if (random() % rarely == 0) child.list->resize(member, random() % 6);
        for (std::size_t i = 0; i < child.list->size(member); ++i)
            disturb(child, child.list->at(member, i), random, rarely);
    }
}

/// Puts an element in or takes one out, anywhere.
template <class Element>
void shift(std::vector<Element>& list, Random& random) {
    const auto at = list.begin() + static_cast<std::ptrdiff_t>(random() % (list.size() + 1));
    if (random() % 2 == 0)
        list.insert(at, Element{});
    else if (at != list.end())
        list.erase(at);
}

void edit(Content& c, Random& random) {
    const unsigned rarely = random() % 3 == 0 ? 3 : 60;
    if (random() % 4 != 0) disturb(preset_table(), &c.preset, random, rarely);
    if (random() % 4 != 0) disturb(scene_table(), &c.scene, random, rarely);
    if (random() % 4 == 0) shift(c.scene.events, random);
    if (random() % 4 == 0) shift(c.preset.smoke.clips, random);
    if (!c.preset.smoke.clips.empty() && random() % 4 == 0) shift(c.preset.smoke.clips.front().masks, random);
    if (random() % 8 == 0) c.preset.folder = random() % 2 == 0 ? "/a" : "/b";
}

/// Every letter of what a file would say, and what it would not.
struct Written {
    explicit Written(const Content& c)
        : text(write_scene(c.scene) + write_preset(c.preset)),
          folders(c.scene.folder.string() + '\n' + c.preset.folder.string()) {}
    std::string text, folders;
    friend bool operator==(const Written&, const Written&) = default;
};

TEST(Delta, UndoAndRedoGiveBackEveryLetter) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        Random random(seed);
        Document document;
        std::vector<Written> states;
        for (int i = 0; i < 60; ++i) {
            document.change("Edit", [&](Content& c) {
                edit(c, random);
                c.scene.preset.clear();  // no part of what is undone
            });
            if (document.done() + 1 > states.size()) {
                if (states.empty()) states.emplace_back(Content{});
                if (document.done() + 1 > states.size()) states.emplace_back(document.content());
            }
            ASSERT_EQ(document.done() + 1, states.size());
        }
        ASSERT_GT(document.done(), 40U) << "most edits change something";
        for (int round = 0; round < 2; ++round) {
            while (document.done() > 0) {
                document.undo();
                ASSERT_TRUE(Written(document.content()) == states[document.done()]) << seed << ' ' << document.done();
            }
            while (document.can_redo()) {
                document.redo();
                ASSERT_TRUE(Written(document.content()) == states[document.done()]) << seed << ' ' << document.done();
            }
        }
        const std::size_t at = random() % states.size();
        document.go_to(at);
        document.begin("Given up");
        document.edit([&](Content& c) {
            edit(c, random);
            c.scene.preset.clear();
        });
        document.cancel();
        ASSERT_TRUE(Written(document.content()) == states[at]) << seed;
    }
}

TEST(Delta, NothingIsEmpty) {
    Preset a, b;
    a.bleeding.speed = b.bleeding.speed = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(Delta(preset_table(), a, b).empty());
    b.folder = "/b";
    EXPECT_FALSE(Delta(preset_table(), a, b).empty());
    b = a;
    b.bleeding.speed = -0.0, a.bleeding.speed = 0.0;
    const Delta delta(preset_table(), a, b);
    EXPECT_FALSE(delta.empty()) << "a file tells them apart";
    delta.redo(a);
    EXPECT_TRUE(std::signbit(a.bleeding.speed));
    EXPECT_TRUE(Delta().empty());
    Delta().undo(a);
}

/// What a part holds while it is off is there again when it is switched on.
TEST(Delta, PartsThatAreOffKeepTheirValues) {
    Preset on;
    on.smoke.clips.resize(1);
    on.smoke.clips[0].own_keying = true;
    on.smoke.clips[0].keying.luma_low = 77;
    Preset off = on;
    off.smoke.clips[0].own_keying = false;
    off.smoke.clips[0].keying = {};
    const Delta delta(preset_table(), on, off);
    EXPECT_TRUE(delta.changes("/smoke/clips/0/keying"));
    Preset now = on;
    delta.redo(now);
    EXPECT_FALSE(now.smoke.clips[0].own_keying);
    delta.undo(now);
    EXPECT_TRUE(now.smoke.clips[0].own_keying);
    EXPECT_EQ(now.smoke.clips[0].keying.luma_low, 77);
}

TEST(Delta, OfAListItHoldsWhatLiesBetweenEqualEnds) {
    Scene before;
    before.events.resize(1000);
    for (std::size_t i = 0; i < 1000; ++i) before.events[i].time = static_cast<double>(i);
    Scene after = before;
    after.events.erase(after.events.begin() + 300, after.events.begin() + 310);
    after.events[300].power = 0.5;
    const Delta delta(scene_table(), before, after);
    EXPECT_LT(delta.memory(), 14 * sizeof(ToolContact) + 400) << "11 events, and the one that they became";
    Scene now = before;
    delta.redo(now);
    EXPECT_EQ(now.events, after.events);
    delta.undo(now);
    EXPECT_EQ(now.events, before.events);
}

TEST(Delta, ATextIsReplacedOnBothSides) {
    Preset before, after;
    before.name = "old", after.name = "new";
    Delta delta(preset_table(), before, after);
    delta.replace("/name", "new", "newer");
    delta.redo(before);
    EXPECT_EQ(before.name, "newer");
    delta.replace("/name", "newer", "old");
    EXPECT_TRUE(delta.empty()) << "both are called the same now";
}

}  // namespace
}  // namespace lapfx::document
