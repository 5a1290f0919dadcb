#include "ui/widgets/tabs.h"

#include "ui/core/tree.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"
#include "ui/widgets/basic.h"

namespace lapfx::ui {
namespace {

struct Three {
    explicit Three(std::vector<std::string_view> all = {"Matte", "Scopes", "Video"}, glm::ivec2 size = {640, 200})
        : names(std::move(all)), ui([this](Ui& u) { build(u); }, size) {}
    void build(Ui& u) {
        u.push_disabled(disabled);
        {
            Tabs tabs(u, "Views", active, names);
            changes += tabs.changed() ? 1 : 0;
            button(u, u.join({"On ", names[static_cast<std::size_t>(active)]}));
        }
        u.pop_disabled();
    }
    std::vector<std::string_view> names;
    int active = 0, changes = 0;
    bool disabled = false;
    Harness ui;
};

TEST(Tabs, APressShowsThePageInTheSameFrame) {
    Three t;
    EXPECT_TRUE(t.ui.is("Views/tabs/Matte", Is::selected));
    t.ui.press("Views/tabs/Scopes");
    EXPECT_EQ(t.active, 1);
    EXPECT_EQ(t.changes, 1);
    EXPECT_TRUE(t.ui.is("Views/tabs/Scopes", Is::selected));
    EXPECT_FALSE(t.ui.is("Views/tabs/Matte", Is::selected));
    EXPECT_TRUE(t.ui.exists("Views/On Scopes"));
    EXPECT_EQ(t.ui.focused(), "Views/tabs/Scopes");
    t.ui.release().press("Views/tabs/Scopes");
    EXPECT_EQ(t.changes, 1);
}

TEST(Tabs, ArrowsGoRoundAndHomeAndEndToTheEnds) {
    Three t;
    t.ui.focus("Views/tabs/Matte").key(Key::right);
    EXPECT_EQ(t.ui.focused(), "Views/tabs/Scopes");
    t.ui.key(Key::right).key(Key::right);
    EXPECT_EQ(t.active, 0);
    t.ui.key(Key::left);
    EXPECT_EQ(t.ui.focused(), "Views/tabs/Video");
    EXPECT_TRUE(t.ui.is("Views/tabs/Video", Is::ringed));
    t.ui.key(Key::home);
    EXPECT_EQ(t.active, 0);
    t.ui.key(Key::end);
    EXPECT_EQ(t.active, 2);
}

TEST(Tabs, OnlyTheOneInFrontIsOnTheWayOfTab) {
    Three t;
    EXPECT_EQ(t.ui.key(Key::tab).focused(), "Views/tabs/Matte");
    EXPECT_EQ(t.ui.key(Key::tab).focused(), "Views/On Matte");
}

TEST(Tabs, ControlAndPageKeysTurnPagesFromAnywhereInside) {
    Three t;
    t.ui.focus("Views/On Matte").key(Key::page_down, Mods::command);
    EXPECT_EQ(t.active, 1);
    t.ui.focus("Views/On Scopes").key(Key::page_up, Mods::command);
    EXPECT_EQ(t.active, 0);
    t.ui.focus("Views/On Matte").key(Key::page_up, Mods::command);
    EXPECT_EQ(t.active, 2);
    EXPECT_EQ(t.changes, 3);
}

TEST(Tabs, AreClosedByTheCrossTheMiddleButtonAndDelete) {
    constexpr std::string_view names[] = {"Matte", "Scopes", "Video"};
    int active = 0, closed = -1;
    bool closable = false;
    Harness ui([&](Ui& u) {
        const TabEvents events = tab_strip(u, "tabs", active, names, {.closable = closable});
        if (events.chosen >= 0) active = events.chosen;
        if (events.closed >= 0) closed = events.closed;
    });
    ui.click("tabs/Scopes", {.button = Button::middle});
    EXPECT_EQ(closed, -1) << "not these";
    closable = true;
    ui.frame().click("tabs/Scopes", {.button = Button::middle});
    EXPECT_EQ(closed, 1);
    ui.click("tabs/Video", {.at = {0.9F, 0.5F}});
    EXPECT_EQ(closed, 2);
    EXPECT_EQ(active, 0) << "a press on the cross does not choose";
    closed = -1;
    ui.press("tabs/Video", {0.9F, 0.5F}).drag_by({-40, 0}).release();
    EXPECT_EQ(closed, -1) << "let go beside the cross";
    ui.focus("tabs/Matte").key(Key::del);
    EXPECT_EQ(closed, 0);
}

TEST(Tabs, WhatDoesNotFitScrollsIntoSightAndIsListed) {
    std::vector<std::string_view> many = {"First tab",  "Second tab", "Third tab",
                                          "Fourth tab", "Fifth tab",  "Sixth tab"};
    Three t(many, {260, 200});
    EXPECT_TRUE(t.ui.exists("Views/All tabs")) << "in the first frame";
    t.active = 5;
    t.ui.frame();
    EXPECT_LE(t.ui.rect("Views/tabs/Sixth tab").right(), t.ui.rect("Views/All tabs").x);
    t.ui.click("Views/All tabs").click("All tabs/Second tab");
    EXPECT_EQ(t.active, 1);
    EXPECT_GE(t.ui.rect("Views/tabs/Second tab").x, 0);
    t.ui.size = {900, 200};
    t.ui.frame();
    EXPECT_FALSE(t.ui.exists("Views/All tabs"));
}

TEST(Tabs, PagesKeepTheirOwnStateAndTheirWidgetsDoNotClashWithTabs) {
    Three t({"Matte", "On Matte"});
    EXPECT_EQ(t.ui.ui().duplicates(), 0U);
    EXPECT_TRUE(faults_of(t.ui.ui().tree()).empty());
}

TEST(Tabs, DisabledTheyStay) {
    Three t;
    t.disabled = true;
    t.ui.frame().click("Views/tabs/Scopes");
    EXPECT_EQ(t.active, 0);
    EXPECT_TRUE(t.ui.is("Views/tabs/Scopes", Is::disabled));
}

TEST(Tabs, ANumberOutOfRangeIsBroughtIn) {
    Three t;
    t.active = 99;
    t.ui.frame();
    EXPECT_EQ(t.active, 2);
    t.active = -4;
    t.ui.frame();
    EXPECT_EQ(t.active, 0);
    EXPECT_EQ(t.changes, 0);
}

TEST(Tabs, SteadyFramesAllocateNothing) {
    Three t;
    for (int i = 0; i < 10; ++i) t.ui.frame();
    const std::size_t before = test::allocations_so_far();
    for (int i = 0; i < 100; ++i) t.ui.frame();
    EXPECT_EQ(test::allocations_so_far() - before, 0U);
}

}  // namespace
}  // namespace lapfx::ui
