#include "ui/widgets/tree_view.h"

#include <gmock/gmock.h>

#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

using testing::ElementsAre;

struct Parts {
    void build(Ui& u) {
        const Icon eye = Icon::eye;
        const TreeItem items[] = {{"Liver", 0, Icon::none, eye, "Hide"}, {"Left lobe", 1, Icon::none, eye},
                                  {"Segment 2", 2, Icon::none, eye},     {"Segment 3", 2, Icon::none, eye},
                                  {"Right lobe", 1, Icon::none, eye},    {"Gallbladder", 0}};
        u.push_disabled(disabled);
        const TreeEvents e = tree_view(u, "Parts", state, items);
        u.pop_disabled();
        if (e.marked_item != no_row) marked = e.marked_item;
        if (e.opened != no_row) opened = e.opened;
        toggles += e.toggled != no_row ? 1 : 0;
    }
    TreeState state;
    bool disabled = false;
    std::size_t marked = no_row, opened = no_row;
    int toggles = 0;
    Harness ui{[this](Ui& u) { build(u); }, {300, 300}};
};

TEST(TreeView, ShowsEveryLevelFurtherIn) {
    Parts t;
    EXPECT_EQ(t.ui.node("Parts").role, Role::tree);
    EXPECT_EQ(t.ui.value("Parts/Segment 2"), 2);
    EXPECT_TRUE(t.ui.is("Parts/Liver", Is::expanded));
    EXPECT_FALSE(t.ui.is("Parts/Gallbladder", Is::expanded));
    EXPECT_EQ(t.ui.rect("Parts/Gallbladder").y, 125);
}

TEST(TreeView, TheTriangleClosesAndOpens) {
    Parts t;
    t.ui.click("Parts/Left lobe", {.at = {0.1F, 0.5F}});
    EXPECT_FALSE(t.ui.exists("Parts/Segment 2"));
    EXPECT_FALSE(t.ui.is("Parts/Left lobe", Is::expanded));
    EXPECT_TRUE(t.ui.exists("Parts/Right lobe"));
    EXPECT_THAT(t.state.closed, ElementsAre(1));
    t.ui.click("Parts/Left lobe", {.at = {0.1F, 0.5F}});
    EXPECT_TRUE(t.ui.exists("Parts/Segment 2"));
    EXPECT_EQ(t.toggles, 2);
    t.ui.click("Parts/Left lobe", {.at = {0.6F, 0.5F}});
    EXPECT_EQ(t.toggles, 2) << "its name only selects";
}

TEST(TreeView, WhatIsClosedInsideSomethingClosedStaysSo) {
    Parts t;
    t.state.closed = {0, 1};
    t.ui.frame();
    EXPECT_FALSE(t.ui.exists("Parts/Left lobe"));
    t.ui.click("Parts/Liver", {.clicks = 2});
    EXPECT_TRUE(t.ui.exists("Parts/Left lobe"));
    EXPECT_FALSE(t.ui.exists("Parts/Segment 2"));
    EXPECT_EQ(t.opened, 0U);
}

TEST(TreeView, RightAndLeftOpenCloseAndGoInAndOut) {
    Parts t;
    t.ui.click("Parts/Left lobe").key(Key::left);
    EXPECT_THAT(t.state.closed, ElementsAre(1));
    t.ui.key(Key::right);
    EXPECT_TRUE(t.state.closed.empty());
    EXPECT_THAT(t.state.selection.keys, ElementsAre(1));
    t.ui.key(Key::right);
    EXPECT_THAT(t.state.selection.keys, ElementsAre(2)) << "the first below";
    EXPECT_TRUE(t.ui.is("Parts/Segment 2", Is::selected));
    t.ui.key(Key::right);
    EXPECT_THAT(t.state.selection.keys, ElementsAre(2)) << "nothing is below it";
    t.ui.key(Key::down).key(Key::left);
    EXPECT_THAT(t.state.selection.keys, ElementsAre(1)) << "the one above";
    t.ui.key(Key::left).key(Key::left).key(Key::left).key(Key::left);
    EXPECT_THAT(t.state.closed, ElementsAre(0, 1));
    EXPECT_THAT(t.state.selection.keys, ElementsAre(0));
}

TEST(TreeView, DownSkipsWhatIsHidden) {
    Parts t;
    t.state.closed = {1};
    t.ui.frame().click("Parts/Left lobe").key(Key::down);
    EXPECT_THAT(t.state.selection.keys, ElementsAre(4));
    EXPECT_EQ(t.ui.key(Key::end).focused(), "Parts");
    EXPECT_THAT(t.state.selection.keys, ElementsAre(5));
}

TEST(TreeView, TheMarkIsClickedOrTakenBySpace) {
    Parts t;
    t.ui.click("Parts/Segment 3/mark");
    EXPECT_EQ(t.marked, 3U);
    EXPECT_TRUE(t.state.selection.keys.empty());
    EXPECT_EQ(t.ui.focused(), "Parts");
    EXPECT_EQ(t.ui.tip("Parts/Liver/mark"), "Hide");
    t.ui.key(Key::home).key(Key::space);
    EXPECT_EQ(t.marked, 0U);
    t.ui.key(Key::end).key(Key::space);
    EXPECT_EQ(t.marked, 0U) << "it has none";
}

TEST(TreeView, DisabledItTakesNothing) {
    Parts t;
    t.disabled = true;
    t.ui.frame().click("Parts/Left lobe", {.at = {0.1F, 0.5F}}).click("Parts/Liver/mark");
    EXPECT_TRUE(t.state.closed.empty());
    EXPECT_TRUE(t.state.selection.keys.empty());
    EXPECT_EQ(t.marked, no_row);
}

TEST(TreeView, TenThousandItemsBuildOnlyThoseInSightAndAllocateNothing) {
    std::vector<TreeItem> items;
    for (int i = 0; i < 10000; ++i) items.push_back({"Part", i % 10 == 0 ? 0 : 1});
    TreeState state;
    Harness ui([&](Ui& u) { tree_view(u, "Parts", state, items); }, {300, 250});
    std::size_t rows = 0;
    for (const Node& node : ui.ui().tree()) rows += node.role == Role::tree_item ? 1 : 0;
    EXPECT_EQ(rows, 10U);
    for (int i = 0; i < 10; ++i) ui.frame();
    const std::size_t before = test::allocations_so_far();
    for (int i = 0; i < 100; ++i) ui.frame();
    EXPECT_EQ(test::allocations_so_far() - before, 0U);
}

TEST(TreeView, ALongNameIsCutAndItsMarkStaysInSight) {
    const TreeItem items[] = {{"Segment V, with a name that does not fit in any way", 3, Icon::image, Icon::eye}};
    TreeState state;
    Harness ui([&](Ui& u) { tree_view(u, "Parts", state, items); }, {200, 100});
    EXPECT_EQ(ui.rect("**/mark").right(), 200);
    EXPECT_LE(ui.node("Parts").scroll->content.x, 200) << "nothing to scroll sideways";
    EXPECT_EQ(ui.tip("Parts/Segment V, with a name that does not fit in any way"), items[0].label);
    ui.size = {60, 100};
    ui.frame();
    EXPECT_GT(ui.node("Parts").scroll->content.x, 60) << "a few letters are left";
}

}  // namespace
}  // namespace lapfx::ui
