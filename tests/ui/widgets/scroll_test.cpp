#include "ui/widgets/scroll.h"

#include <gmock/gmock.h>

#include <random>
#include <set>

#include "ui/core/node.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"
#include "ui/widgets/basic.h"

namespace lapfx::ui {
namespace {

constexpr float row = 25;  // px at scale 1

/// A panel of 40 buttons in a window that shows 10.
struct Forty {
    Forty() : ui([](Ui& u) { build(u); }, {200, 250}) {}
    static void build(Ui& u) {
        ScrollArea area(u, "List");
        for (int i = 0; i < 40; ++i) {
            u.push_seed(static_cast<std::uint64_t>(i));
            button(u, "Button " + std::to_string(i), {.quiet = true});
            u.pop_seed();
        }
    }
    float offset() { return -ui.rect("List/Button 0").y; }
    Harness ui;
};

TEST(ScrollArea, ShowsABarOnlyWhenThereIsSomethingToScroll) {
    int rows = 3;
    Harness ui(
        [&](Ui& u) {
            ScrollArea area(u, "List");
            for (int i = 0; i < rows; ++i) button(u, "Row##" + std::to_string(i));
        },
        {200, 250});
    EXPECT_FALSE(ui.exists("List/vertical scroll bar"));
    rows = 30;
    ui.frame();
    EXPECT_TRUE(ui.exists("List/vertical scroll bar")) << "in the very frame that needs it";
    EXPECT_FALSE(ui.exists("List/horizontal scroll bar"));
    EXPECT_EQ(ui.node("List/vertical scroll bar").number->maximum, 30 * row - 250);
    rows = 0;
    ui.frame();
    EXPECT_FALSE(ui.exists("List/vertical scroll bar"));
}

TEST(ScrollArea, TheWheelScrollsThreeRowsANotchAndStopsAtTheEnds) {
    Forty t;
    t.ui.wheel("List", {0, -1});
    EXPECT_EQ(t.offset(), 3 * row);
    t.ui.wheel("List", {0, 1}).wheel("List", {0, 5});
    EXPECT_EQ(t.offset(), 0);
    t.ui.wheel("List", {0, -100});
    EXPECT_EQ(t.offset(), 40 * row - 250);
}

TEST(ScrollArea, TheWheelMovesOnlyAlongAxesThatScroll) {
    Forty t;
    t.ui.wheel("List", {-3, 0}).wheel("List", {0, -1}, Mods::shift);
    EXPECT_EQ(t.ui.rect("List/Button 0").x, 0);
    EXPECT_EQ(t.offset(), 0);
}

TEST(ScrollArea, AnInnerAreaAtItsEndHandsTheWheelToTheOneAround) {
    Harness ui(
        [](Ui& u) {
            ScrollArea outer(u, "Outer");
            {
                ScrollArea inner(u, "Inner", {.height = px(100)});
                for (int i = 0; i < 5; ++i) button(u, "In##" + std::to_string(i));
            }
            for (int i = 0; i < 40; ++i) button(u, "Out##" + std::to_string(i));
        },
        {200, 250});
    ui.move({20, 40}).send({.kind = EventKind::wheel, .delta = {0, -1}});
    EXPECT_EQ(ui.rect("Outer/Inner").y, 0);
    ui.move({20, 40}).send({.kind = EventKind::wheel, .delta = {0, -1}});
    EXPECT_EQ(ui.rect("Outer/Inner").y, -3 * row);
}

TEST(ScrollArea, TheThumbIsDraggedAndEscapePutsItBack) {
    Forty t;
    // 250 of 1000 px are visible: the thumb is 62 px long, and its 188 px of way scroll by 750 px.
    t.ui.press("List/vertical scroll bar", {0.5F, 0.05F}).drag_by({0, 45});
    EXPECT_NEAR(t.offset(), 180, 1);
    EXPECT_NEAR(t.ui.value("List/vertical scroll bar"), 180, 1);
    t.ui.key(Key::escape).drag_by({0, 20}).release();
    EXPECT_EQ(t.offset(), 0);
    t.ui.press("List/vertical scroll bar", {0.5F, 0.05F}).drag_by({0, 1000}).release();
    EXPECT_EQ(t.offset(), 750);
}

TEST(ScrollArea, APressBesideTheThumbGoesOnByAPage) {
    Forty t;
    t.ui.click("List/vertical scroll bar", {.at = {0.5F, 0.9F}});
    EXPECT_EQ(t.offset(), 250);
    t.ui.click("List/vertical scroll bar", {.at = {0.5F, 0.05F}});
    EXPECT_EQ(t.offset(), 0);
}

TEST(ScrollArea, PageKeysScrollWhenNothingElseTakesThem) {
    Forty t;
    t.ui.focus("List/Button 0").key(Key::page_down);
    EXPECT_EQ(t.offset(), 250 - row) << "one row is seen twice";
    t.ui.key(Key::end);
    EXPECT_EQ(t.offset(), 750);
    t.ui.key(Key::page_up);
    EXPECT_EQ(t.offset(), 750 - 250 + row);
    t.ui.key(Key::home);
    EXPECT_EQ(t.offset(), 0);
    t.ui.key(Key::escape).move({20, 40}).key(Key::page_down);
    EXPECT_EQ(t.offset(), 250 - row) << "without a focus: what is under the pointer";
}

TEST(ScrollArea, TabBringsIntoSightWhatItComesTo) {
    Forty t;
    t.ui.key(Key::tab, Mods::shift);
    EXPECT_EQ(t.ui.focused(), "List/Button 39");
    EXPECT_EQ(t.ui.rect("List/Button 39").bottom(), 250);
}

TEST(ScrollArea, ScrollsSidewaysWhereItMay) {
    Harness ui(
        [](Ui& u) {
            ScrollArea area(u, "Wide", {.sideways = true});
            Node& node = u.leaf(Role::canvas, "Canvas");
            node.size[0] = px(600), node.size[1] = px(100);
        },
        {200, 250});
    EXPECT_TRUE(ui.exists("Wide/horizontal scroll bar"));
    EXPECT_FALSE(ui.exists("Wide/vertical scroll bar"));
    ui.wheel("Wide", {0, -1}, Mods::shift);
    EXPECT_EQ(ui.rect("Wide/Canvas").x, -3 * row);
    ui.click("Wide/horizontal scroll bar", {.at = {0.95F, 0.5F}});
    EXPECT_EQ(ui.rect("Wide/Canvas").x, -3 * row - 200);
}

struct Frames {
    explicit Frames(std::size_t n, glm::ivec2 size = {300, 250}) : count(n), ui([this](Ui& u) { build(u); }, size) {}
    void build(Ui& u) {
        ++builds, built = 0;
        virtual_rows(u, "Frames", count, u.row_height(), [&](std::size_t i) {
            char text[32];
            std::snprintf(text, sizeof text, "Frame %zu", i);
            label(u, text);
            ++built;
        });
    }
    std::size_t count;
    int builds = 0, built = 0;
    Harness ui;
};

TEST(VirtualRows, OnlyThoseInSightAreBuilt) {
    Frames t(10000);
    EXPECT_EQ(t.built, 10);
    EXPECT_EQ(t.ui.rect("Frames/Frame 0").y, 3);  // 20 px of text in the middle of 25
    EXPECT_TRUE(t.ui.exists("Frames/Frame 9"));
    EXPECT_FALSE(t.ui.exists("Frames/Frame 10"));
    EXPECT_EQ(t.ui.node("Frames/vertical scroll bar").number->maximum, 10000 * row - 250);
    t.ui.wheel("Frames", {0, -1});
    EXPECT_FALSE(t.ui.exists("Frames/Frame 2"));
    EXPECT_TRUE(t.ui.exists("Frames/Frame 12"));
    t.ui.move({20, 40}).key(Key::end);
    EXPECT_EQ(t.ui.rect("Frames/Frame 9999").bottom(), 250 - 2);
}

TEST(VirtualRows, TheFirstFrameAndAnyNewSizeAreRightAtOnce) {
    Frames t(10000);
    t.ui.size = {300, 500};
    t.ui.frame();
    EXPECT_EQ(t.built, 20);
    t.ui.size = {300, 110};
    t.ui.frame();
    EXPECT_EQ(t.built, 5);
}

TEST(VirtualRows, FewerRowsLeaveNoGapAtTheEnd) {
    Frames t(1000);
    t.ui.move({20, 40}).key(Key::end);
    t.count = 12;
    t.ui.frame();
    EXPECT_EQ(t.ui.rect("Frames/Frame 11").bottom(), 250 - 2);
    t.count = 0;
    t.ui.frame();
    EXPECT_EQ(t.built, 0);
    EXPECT_TRUE(t.ui.exists("Frames"));
}

TEST(VirtualRows, WhateverTheOffsetAllThatIsSeenIsThere) {
    Frames t(777, {300, 211});
    std::mt19937 random(1);
    for (int i = 0; i < 300; ++i) {
        const float notches = std::uniform_real_distribution<float>(-9, 8)(random);
        t.ui.move({20, 40}).send({.kind = EventKind::wheel, .delta = {0, notches}});
        std::set<float> tops;
        for (const Node& node : t.ui.ui().tree()) {
            if (node.role == Role::label) tops.insert(node.at[1]);
        }
        ASSERT_LE(*tops.begin(), 3);
        ASSERT_GE(*tops.rbegin() + row, 211 - 3);
    }
}

TEST(VirtualRows, SteadyFramesAndScrollingAllocateNothing) {
    Frames t(10000);
    const auto scroll = [&](float notches) {
        t.ui.ui().push({.kind = EventKind::wheel, .at = {20, 40}, .delta = {0, notches}});
        t.ui.frame();
    };
    for (int i = 0; i < 300; ++i) scroll(i % 2 == 0 ? -1.0F : 1.0F);
    const std::size_t before = test::allocations_so_far();
    for (int i = 0; i < 300; ++i) scroll(i % 2 == 0 ? -1.0F : 1.0F);
    EXPECT_EQ(test::allocations_so_far() - before, 0U);
}

TEST(VirtualRows, TenThousandCostNoMoreThanThoseInSight) {
    Frames t(10000, {600, 720}), few(100, {600, 720});
    t.ui.frame(), few.ui.frame();
    EXPECT_EQ(t.ui.ui().tree().size(), few.ui.ui().tree().size()) << "what it is in us is in `lapfx bench ui`";
    EXPECT_EQ(t.built, few.built);
}

TEST(ScrollArea, APictureAsHighAsItsWidthWantsDoesNotMakeTheBarComeAndGo) {
    bool tall = true;
    Harness ui(
        [&](Ui& u) {
            ScrollArea area(u, "List");
            Node& picture = u.leaf(Role::image, "Picture", Sense::hover);
            picture.size[0] = grow();
            picture.size[1] = px(10);
            if (tall)
                picture.height_for_width = [](Ui&, const Node&, float width) { return std::round(width * 0.75F); };
        },
        {640, 476});  // the picture is 480 px high without the bar, 471 with it
    for (int i = 0; i < 4; ++i) {
        ui.frame();
        EXPECT_LT(ui.rect("List/Picture").w, 640) << "the room of the bar stays";
        EXPECT_LE(ui.rect("List/Picture").h, 476);
    }
    const int builds = ui.ui().builds();
    ui.frame();
    EXPECT_EQ(ui.ui().builds(), builds + 1);
    tall = false;
    ui.frame().frame();
    EXPECT_EQ(ui.rect("List/Picture").w, 640) << "where nothing needs it, it goes";
    tall = true;
    ui.frame().frame();
    EXPECT_LT(ui.rect("List/Picture").w, 640);
}

}  // namespace
}  // namespace lapfx::ui
