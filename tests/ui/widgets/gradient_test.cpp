#include "ui/widgets/gradient.h"

#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

struct GradientTest : testing::Test {
    std::vector<GradientStop> stops{{0.0F, rgb(0x000000)}, {0.5F, rgb(0xff0000)}, {1.0F, rgb(0xffffff)}};
    GradientOptions options;
    Edit all;
    int commits = 0, begins = 0;
    Harness ui{[this](Ui& u) {
        const Edit edit = gradient_bar(u, "Tint", stops, options);
        commits += edit.committed, begins += edit.began;
        all |= edit;
    }};
    float width() { return ui.rect("Tint").w - 2 * std::round(0.85F * 14); }
};

TEST_F(GradientTest, EachStopIsANodeWithPlaceAndColour) {
    EXPECT_EQ(ui.node("Tint/Stop 2").role, Role::handle);
    EXPECT_EQ(ui.value("Tint/Stop 2"), 0.5);
    EXPECT_EQ(ui.text("Tint/Stop 2"), "#ff0000");
    EXPECT_NEAR(ui.rect("Tint/Stop 2").center().x, ui.rect("Tint").center().x, 1);
    EXPECT_GE(ui.rect("Tint/Stop 1").x, ui.rect("Tint").x);
    EXPECT_LE(ui.rect("Tint/Stop 3").right(), ui.rect("Tint").right());
    EXPECT_GE(ui.rect("Tint/Stop 1").h, 24);
}

TEST_F(GradientTest, ADragMovesByWhatThePointerMovesAndIsOneGesture) {
    ui.press("Tint/Stop 2").drag_by({2, 0});
    EXPECT_FALSE(all.changed) << "the first three px are none";
    ui.drag_by({width() / 4 - 2, 40});
    EXPECT_NEAR(stops[1].place, 0.75F, 0.002F);
    EXPECT_EQ(ui.value("Tint/Stop 2"), stops[1].place) << "shown in the same frame";
    ui.release();
    EXPECT_EQ(begins, 1);
    EXPECT_EQ(commits, 1);
}

TEST_F(GradientTest, ShiftIsTenTimesAsFine) {
    ui.drag("Tint/Stop 2", {width() / 4, 0}, Mods::shift);
    EXPECT_NEAR(stops[1].place, 0.525F, 0.001F);
}

TEST_F(GradientTest, NeighboursHoldAStopBack) {
    ui.drag("Tint/Stop 2", {2000, 0});
    EXPECT_EQ(stops[1].place, 1);
    ui.drag("Tint/Stop 1", {2000, 0});
    EXPECT_EQ(stops[0].place, 1);
}

TEST_F(GradientTest, EscapeDuringADragTakesItBack) {
    ui.press("Tint/Stop 2").drag_by({100, 0});
    EXPECT_NE(stops[1].place, 0.5F);
    ui.key(Key::escape);
    EXPECT_EQ(stops[1].place, 0.5F);
    EXPECT_TRUE(all.cancelled);
    EXPECT_EQ(commits, 0);
}

TEST_F(GradientTest, ArrowsMoveAndOnlyCommandHomeGoesToTheEnd) {
    ui.focus("Tint/Stop 2").key(Key::right);
    EXPECT_NEAR(stops[1].place, 0.51F, 1e-5F);
    ui.key(Key::left, Mods::shift);
    EXPECT_NEAR(stops[1].place, 0.509F, 1e-5F);
    ui.key(Key::left, Mods::command);
    EXPECT_NEAR(stops[1].place, 0.409F, 1e-5F);
    EXPECT_EQ(commits, 3);
    ui.key(Key::home);
    EXPECT_NEAR(stops[1].place, 0.409F, 1e-5F);
    ui.key(Key::home, Mods::command);
    EXPECT_EQ(stops[1].place, 0);
}

TEST_F(GradientTest, ADoublePressAddsAStopOfTheColourThere) {
    ui.click("Tint", {.clicks = 1, .at = {0.25F, 0.2F}});
    EXPECT_EQ(stops.size(), 3U);
    ui.click("Tint", {.clicks = 2, .at = {0.25F, 0.2F}});
    ASSERT_EQ(stops.size(), 4U);
    EXPECT_NEAR(stops[1].place, 0.25F, 0.02F);
    EXPECT_NEAR(stops[1].color.r, 0x80, 8);
    EXPECT_TRUE(ui.exists("Tint/Stop 4"));
    EXPECT_EQ(commits, 1);
}

TEST_F(GradientTest, EnterOnTheBarAddsInTheWidestGapUpToTheMost) {
    stops[1].place = 0.2F;
    options.most = 4;
    ui.frame().focus("Tint").key(Key::enter);
    ASSERT_EQ(stops.size(), 4U);
    EXPECT_NEAR(stops[2].place, 0.6F, 1e-5F);
    ui.key(Key::enter);
    EXPECT_EQ(stops.size(), 4U);
}

TEST_F(GradientTest, DeleteTakesAStopAwayDownToTheLeast) {
    ui.focus("Tint/Stop 3").key(Key::del);
    ASSERT_EQ(stops.size(), 2U);
    EXPECT_EQ(stops[1].color, rgb(0xff0000));
    EXPECT_FALSE(ui.exists("Tint/Stop 3"));
    EXPECT_EQ(ui.focused(), "Tint/Stop 2");
    ui.key(Key::backspace);
    EXPECT_EQ(stops.size(), 2U);
    EXPECT_EQ(commits, 1);
}

TEST_F(GradientTest, ADoublePressOrEnterOpensTheColour) {
    ui.focus("Tint/Stop 1").key(Key::enter);
    ASSERT_TRUE(ui.exists("Tint picker"));
    ui.click("Tint picker/Hex").key('A', Mods::command).type("#0f0");
    EXPECT_EQ(stops[0].color, rgb(0x00ff00));
    ui.key(Key::enter);
    EXPECT_EQ(commits, 1);
    ui.send({.kind = EventKind::press, .at = {630, 470}});
    ui.release();
    EXPECT_FALSE(ui.exists("Tint picker"));
    ui.click("Tint/Stop 2", {.clicks = 2});
    EXPECT_TRUE(ui.exists("Tint picker"));
    EXPECT_EQ(ui.text("Tint picker/Before"), "#ff0000");
}

TEST_F(GradientTest, StopsThatComeInWildAreSortedAndBroughtIntoRange) {
    stops = {{3, rgb(1)}, {-1, rgb(2)}, {NAN, rgb(3)}, {0.5F, rgb(4)}};
    ui.frame();
    EXPECT_EQ(stops[0].place, 0);
    EXPECT_EQ(stops[2].place, 0.5F);
    EXPECT_EQ(stops[3].place, 1);
    EXPECT_FALSE(all.changed);
    stops.clear();
    ui.frame().focus("Tint").key(Key::enter);
    EXPECT_EQ(stops.size(), 1U);
}

TEST_F(GradientTest, ADisabledBarKeepsItsStops) {
    Harness dead([&](Ui& u) {
        u.push_disabled(true);
        gradient_bar(u, "Tint", stops, {.tip = "why"});
        u.pop_disabled();
    });
    dead.drag("Tint/Stop 2", {100, 0});
    dead.click("Tint", {.clicks = 2, .at = {0.25F, 0.2F}}).key(Key::tab).key(Key::del);
    EXPECT_EQ(stops.size(), 3U);
    EXPECT_EQ(stops[1].place, 0.5F);
    EXPECT_EQ(dead.tip("Tint"), "why");
}

TEST_F(GradientTest, DragsAllocateNothing) {
    ui.press("Tint/Stop 2");
    const auto drag = [&](int frames) {
        for (int i = 0; i < frames; ++i) ui.move({200 + static_cast<float>(i % 90), 30});
    };
    drag(300);
    const std::size_t before = test::allocations_so_far();
    drag(90);
    EXPECT_EQ(test::allocations_so_far(), before);
}

TEST(GradientAt, IsExactAtStopsAndLinearBetween) {
    const GradientStop stops[] = {
        {0.2F, rgb(0x000000)}, {0.4F, rgb(0xc80000)}, {0.4F, rgb(0x0000ff)}, {0.8F, rgb(0x0000ff)}};
    EXPECT_EQ(gradient_at(stops, 0), rgb(0x000000));
    EXPECT_EQ(gradient_at(stops, 0.3F), rgb(0x640000));
    EXPECT_EQ(gradient_at(stops, 0.4F), rgb(0xc80000));
    EXPECT_EQ(gradient_at(stops, 0.41F), rgb(0x0000ff)) << "two stops in one place: a hard edge";
    EXPECT_EQ(gradient_at(stops, 1), rgb(0x0000ff));
    EXPECT_EQ(gradient_at({}, 0.5F), (Color{0, 0, 0, 0}));
}

}  // namespace
}  // namespace lapfx::ui
