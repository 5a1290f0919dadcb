#include "ui/core/layout.h"

#include <gtest/gtest.h>

#include <random>

#include "ui/support/harness.h"
#include "ui/widgets/basic.h"

namespace lapfx::ui {
namespace {

void box(Ui& u, const char* name, Size w, Size h) {
    Node& node = u.leaf(Role::canvas, name, Sense::hover);
    node.size[0] = w, node.size[1] = h;
}

TEST(Layout, WhatIsLeftIsSharedByWeight) {
    Harness ui(
        [](Ui& u) {
            Row row(u, {.width = grow(), .height = px(50), .gap = 0});
            box(u, "A", px(100), px(10));
            box(u, "B", grow(1), px(10));
            box(u, "C", grow(3), px(10));
        },
        {500, 300});
    EXPECT_EQ(ui.rect("B"), (Rect{100, 0, 100, 10}));
    EXPECT_EQ(ui.rect("C"), (Rect{200, 0, 300, 10}));
}

TEST(Layout, CentresAndAligns) {
    Harness ui(
        [](Ui& u) {
            Row row(
                u, {.width = grow(), .height = px(50), .gap = 0, .cross = ChildAlign::center, .main = ChildAlign::end});
            box(u, "A", px(100), px(10));
            box(u, "B", px(100), px(20));
        },
        {500, 300});
    EXPECT_EQ(ui.rect("A"), (Rect{300, 20, 100, 10}));
    EXPECT_EQ(ui.rect("B"), (Rect{400, 15, 100, 20}));
}

TEST(Layout, AColumnThatFitsIsAsLargeAsItsChildren) {
    Harness ui([](Ui& u) {
        Row row(u);
        {
            Column column(u, {.gap = 0, .padding = 1});
            box(u, "A", px(30), px(10));
            box(u, "B", px(70), px(15));
        }
        box(u, "C", px(10), px(10));
    });
    EXPECT_EQ(ui.rect("B"), (Rect{14, 24, 70, 15}));
    EXPECT_EQ(ui.rect("C").x, 14 + 70 + 14 + std::round(0.4F * 14));
}

TEST(Layout, TooLittleRoomIsTakenFromWhatCanShrinkDownToItsLeast) {
    Harness ui([](Ui& u) {
        Row row(u, {.width = px(200), .height = px(20), .gap = 0});
        box(u, "Rigid", px(120), px(10));
        box(u, "Soft", px(120), px(10));
        u.last().rigid = false;
        u.last().minimum[0] = 90;
    });
    EXPECT_EQ(ui.rect("Rigid").w, 120);
    EXPECT_EQ(ui.rect("Soft").w, 90);
}

TEST(Layout, WhatGrowsHasItsLeastAndTheOthersShareTheRest) {
    Harness ui([](Ui& u) {
        Row row(u, {.width = px(100), .height = px(20), .gap = 0});
        box(u, "A", grow(), px(10));
        u.last().minimum[0] = 80;
        box(u, "B", grow(), px(10));
    });
    EXPECT_EQ(ui.rect("A"), (Rect{0, 0, 80, 10}));
    EXPECT_EQ(ui.rect("B"), (Rect{80, 0, 20, 10}));
}

TEST(Layout, SoftChildrenGiveWayToTheLeastOfWhatGrows) {
    Harness ui([](Ui& u) {
        Row row(u, {.width = px(100), .height = px(20), .gap = 0});
        box(u, "Soft", px(80), px(10));
        u.last().rigid = false;
        box(u, "Grows", grow(), px(10));
        u.last().minimum[0] = 50;
    });
    EXPECT_EQ(ui.rect("Soft").w, 50);
    EXPECT_EQ(ui.rect("Grows"), (Rect{50, 0, 50, 10}));
}

TEST(Layout, AWrappedTextIsAsHighAsItsLines) {
    Harness ui(
        [](Ui& u) {
            label(u, "one two three four five six seven eight nine ten eleven twelve thirteen", {.wrap = true});
            box(u, "Below", px(10), px(10));
        },
        {160, 400});
    const float line = Harness::fonts().metrics(ui.ui().text_style()).height;
    EXPECT_EQ(std::fmod(ui.rect("Below").y, line), 0);
    EXPECT_GE(ui.rect("Below").y, 3 * line);
    EXPECT_LE(ui.rect("Below").y, 5 * line);
}

TEST(Layout, APlacedChildTakesNoRoomFromTheOthers) {
    Harness ui([](Ui& u) {
        Column column(u, {.width = px(100), .height = px(100), .gap = 1});
        box(u, "A", px(10), px(10));
        box(u, "Handle", px(8), px(8));
        u.last().placed = true;
        u.last().placement = u.arena().make(Placement{.fraction = {1, 0.5F}, .offset = {-3, 0}, .pivot = {0.5F, 0.5F}});
        box(u, "B", px(10), px(10));
    });
    EXPECT_EQ(ui.rect("B"), (Rect{0, 24, 10, 10}));
    EXPECT_EQ(ui.rect("Handle"), (Rect{93, 46, 8, 8}));
}

/// Random trees: children do not begin before their parents, neighbours never overlap, and everything is on whole px.
class RandomTree {
  public:
    explicit RandomTree(unsigned seed) : seed_(seed) {}
    void build(Ui& u) {
        random_.seed(seed_);
        count_ = 0;
        add(u, 0);
    }

  private:
    int pick(int below) { return static_cast<int>(random_() % static_cast<unsigned>(below)); }
    Size size() {
        const int kind = pick(3);
        return kind == 0 ? px(static_cast<float>(pick(60))) : kind == 1 ? fit() : grow(static_cast<float>(1 + pick(3)));
    }
    void add(Ui& u, int depth) {
        const int children = depth > 3 ? 0 : pick(5);
        ++count_;
        Node& node = u.open(Role::group, "n" + std::to_string(count_), pick(2) == 0 ? Axis::x : Axis::y);
        node.size[0] = size(), node.size[1] = size();
        node.gap = static_cast<float>(pick(5));
        node.rigid = false;
        node.main = static_cast<ChildAlign>(pick(3));
        node.cross = static_cast<ChildAlign>(pick(4));
        for (std::uint8_t& p : node.padding) p = static_cast<std::uint8_t>(pick(4));
        for (int i = 0; i < children; ++i) add(u, depth + 1);
        u.close();
    }
    unsigned seed_;
    std::mt19937 random_;
    int count_ = 0;
};

TEST(Layout, RandomTreesNeverOverlap) {
    for (unsigned seed = 0; seed < 400; ++seed) {
        RandomTree tree(seed);
        Harness ui([&](Ui& u) { tree.build(u); }, {800, 600});
        const auto all = ui.ui().tree();
        for (const Node& node : all) {
            for (const float v : {node.at[0], node.at[1], node.extent[0], node.extent[1]})
                ASSERT_EQ(v, std::round(v)) << seed;
            ASSERT_GE(node.extent[0], 0);
            if (node.parent == no_node) continue;
            const Node& parent = all[node.parent];
            const int a = static_cast<int>(parent.axis);
            ASSERT_GE(node.at[a], parent.at[a] + parent.padding[a]) << seed << ui.dump();
            if (node.next != no_node) {
                ASSERT_GE(all[node.next].at[a], node.at[a] + node.extent[a]) << seed << ui.dump();
            }
        }
    }
}

}  // namespace
}  // namespace lapfx::ui
