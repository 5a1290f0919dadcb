#include "ui/widgets/thumbnails.h"

#include <gmock/gmock.h>

#include "ui/core/tree.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

using testing::ElementsAre;

/// Three cells fit in a line: each needs 120 px (8 em and pads of 4 px), and of the 388 px next to the bar it gets 129.
struct Presets {
    explicit Presets(std::size_t n) : count(n), ui([this](Ui& u) { build(u); }, {400, 300}) {}
    void build(Ui& u) {
        char text[32];
        const auto item = [&](std::size_t i) {
            const int size = std::snprintf(text, sizeof text, "Preset %zu", i);
            return Thumbnail{.label = {text, static_cast<std::size_t>(size)},
                             .image = i == 1 ? 0 : own_images,
                             .star = i == star,
                             .changed = i == 2};
        };
        u.push_disabled(disabled);
        const ThumbnailEvents e = thumbnails(u, "Presets", selection, count, item);
        u.pop_disabled();
        hovered = e.hovered;
        if (e.opened != no_row) opened = e.opened;
        if (e.marked != no_row) star = e.marked;
    }
    std::size_t cells() {
        std::size_t n = 0;
        for (const Node& node : ui.ui().tree()) n += node.role == Role::image ? 1 : 0;
        return n;
    }
    std::size_t count, star = no_row, opened = no_row, hovered = no_row;
    Selection selection;
    bool disabled = false;
    Harness ui;
};

TEST(Thumbnails, FillTheWidthInTheFirstFrame) {
    Presets t(1000);
    EXPECT_EQ(t.ui.rect("Presets/Preset 2").x, 258);
    EXPECT_EQ(t.ui.rect("Presets/Preset 3").x, 0);
    EXPECT_EQ(t.ui.rect("Presets/Preset 3").w, 129);
    EXPECT_EQ(t.cells(), 12U) << "three lines of 97 px and a bit of a fourth";
    t.ui.size = {530, 300};
    t.ui.frame();
    EXPECT_EQ(t.ui.rect("Presets/Preset 3").x, 387);
}

TEST(Thumbnails, TellWhatTheyAre) {
    Presets t(10);
    t.star = 0;
    t.ui.frame();
    EXPECT_EQ(t.ui.node("Presets").role, Role::grid);
    EXPECT_TRUE(t.ui.is("Presets/Preset 1", Is::busy));
    EXPECT_FALSE(t.ui.is("Presets/Preset 0", Is::busy));
    EXPECT_TRUE(t.ui.is("Presets/Preset 2", Is::changed));
    EXPECT_TRUE(t.ui.is("Presets/Preset 0", Is::checked));
    EXPECT_EQ(t.ui.tip("Presets/Preset 0/star"), "Take the star away");
    EXPECT_TRUE(faults_of(t.ui.ui().tree()).empty());
}

TEST(Thumbnails, ArrowsGoInAllDirectionsAndScrollAlong) {
    Presets t(100);
    t.ui.click("Presets/Preset 1").key(Key::down);
    EXPECT_THAT(t.selection.keys, ElementsAre(4));
    t.ui.key(Key::right).key(Key::right);
    EXPECT_THAT(t.selection.keys, ElementsAre(6));
    t.ui.key(Key::left).key(Key::up);
    EXPECT_THAT(t.selection.keys, ElementsAre(2));
    t.ui.key(Key::end);
    EXPECT_THAT(t.selection.keys, ElementsAre(99));
    EXPECT_EQ(t.ui.rect("Presets/Preset 99").bottom(), 300);
    EXPECT_TRUE(t.ui.is("Presets/Preset 99", Is::selected));
}

TEST(Thumbnails, EnterAndADoubleClickOpen) {
    Presets t(10);
    t.ui.click("Presets/Preset 4", {.clicks = 2});
    EXPECT_EQ(t.opened, 4U);
    t.ui.key(Key::left).key(Key::enter);
    EXPECT_EQ(t.opened, 3U);
}

TEST(Thumbnails, TheStarIsClickedOrTakenBySpace) {
    Presets t(10);
    t.ui.click("Presets/Preset 4/star");
    EXPECT_EQ(t.star, 4U);
    EXPECT_TRUE(t.selection.keys.empty());
    t.ui.key(Key::home).key(Key::space);
    EXPECT_EQ(t.star, 0U);
}

TEST(Thumbnails, WhatThePointerIsOnIsToldOverItsStarToo) {
    Presets t(10);
    t.ui.move_to("Presets/Preset 4");
    EXPECT_EQ(t.hovered, 4U);
    t.ui.move_to("Presets/Preset 5/star");
    EXPECT_EQ(t.hovered, 5U);
    t.ui.send({.kind = EventKind::pointer_out});
    EXPECT_EQ(t.hovered, no_row);
}

TEST(Thumbnails, DisabledTheyTakeNothing) {
    Presets t(10);
    t.disabled = true;
    t.ui.frame().click("Presets/Preset 4").click("Presets/Preset 4/star");
    EXPECT_TRUE(t.selection.keys.empty());
    EXPECT_EQ(t.star, no_row);
}

TEST(Thumbnails, ANarrowPlaceStillHoldsOneAndNoneAtAllAreFine) {
    Presets t(10);
    t.ui.size = {60, 300};
    t.ui.frame();
    EXPECT_EQ(t.ui.rect("Presets/Preset 1").x, 0);
    t.count = 0;
    t.ui.frame().focus("Presets").key(Key::down).key(Key::enter).key(Key::space);
    EXPECT_TRUE(t.selection.keys.empty());
    EXPECT_EQ(t.opened, no_row);
}

TEST(Thumbnails, SteadyFramesAllocateNothing) {
    Presets t(1000);
    for (int i = 0; i < 10; ++i) t.ui.frame();
    const std::size_t before = test::allocations_so_far();
    for (int i = 0; i < 100; ++i) t.ui.frame();
    EXPECT_EQ(test::allocations_so_far() - before, 0U);
}

TEST(Thumbnails, AStarHasADarkGroundWhateverThePicture) {
    Selection selection;
    Harness ui([&](Ui& u) {
        u.set_theme(light_theme());
        thumbnails(u, "Presets", selection, 1, [](std::size_t) { return Thumbnail{.label = "Fog", .star = true}; });
    });
    const Rect star = ui.rect("Presets/Fog/star");
    int grounds = 0;
    for (const Instance& i : ui.output().list->instances) {
        const bool under =
            i.kind == InstanceKind::fill && star.contains({i.x, i.y}) && star.contains({i.x + i.w, i.y + i.h});
        grounds += under && i.w > 10 && i.color.a > 128 &&
                   contrast({i.color.r, i.color.g, i.color.b, 255}, rgb(0xffffff)) > 12;
    }
    EXPECT_EQ(grounds, 1);
}

}  // namespace
}  // namespace lapfx::ui
