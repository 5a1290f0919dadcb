#include "ui/widgets/dock.h"

#include <gmock/gmock.h>

#include "ui/canvas/viewport.h"
#include "ui/core/tree.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/scroll.h"
#include "ui/widgets/section.h"

namespace lapfx::ui {
namespace {

using testing::ElementsAre;

constexpr std::string_view all[] = {"View", "Parameters", "Scopes", "Log"};

/// View is on the left; on the right, Parameters and Scopes are above Log. The 1004 px are 1000 and 4 for the edge.
struct Workspace {
    static DockLayout standard() {
        return dock_split(Axis::x, 0.6F, dock_tabs({"View"}),
                          dock_split(Axis::y, 0.5F, dock_tabs({"Parameters", "Scopes"}), dock_tabs({"Log"})));
    }
    void build(Ui& u) {
        u.push_disabled(disabled);
        const DockEvents e = dock(u, "Desk", layout, all, [&](std::size_t panel) {
            if (Section section(u, "Part"); section) button(u, u.join({"In ", all[panel]}));
        });
        u.pop_disabled();
        arranged += e.arranged ? 1 : 0;
        committed += e.resized.committed ? 1 : 0;
    }
    std::vector<std::string> tabs_with(std::string_view panel) const {
        const int at = layout.find(panel);
        return at < 0 ? std::vector<std::string>{} : layout.nodes[static_cast<std::size_t>(at)].tabs;
    }
    /// Drags the tab of a panel to a place in the rectangle of another one.
    void drag(const std::string& panel, const std::string& onto, glm::vec2 at) {
        ui.press("Desk/tabs/" + panel, {0.3F, 0.5F});
        const Rect to = ui.rect("Desk/" + onto);
        ui.move(to.at() + to.size() * at);
    }
    DockLayout layout = standard();
    bool disabled = false;
    int arranged = 0, committed = 0;
    Harness ui{[this](Ui& u) { build(u); }, {1004, 604}};
};

TEST(Dock, LaysPanelsOutWithoutOverlapInTheFirstFrame) {
    Workspace t;
    EXPECT_EQ(t.ui.rect("Desk/View"), (Rect{0, 25, 600, 579}));
    EXPECT_EQ(t.ui.rect("Desk/Parameters"), (Rect{604, 25, 400, 275}));
    EXPECT_EQ(t.ui.rect("Desk/Log"), (Rect{604, 329, 400, 275}));
    EXPECT_FALSE(t.ui.exists("Desk/Scopes")) << "behind Parameters";
    EXPECT_TRUE(t.ui.exists("Desk/tabs/Scopes"));
    EXPECT_EQ(t.ui.ui().duplicates(), 0U);
    EXPECT_TRUE(faults_of(t.ui.ui().tree()).empty());
}

TEST(Dock, ATabBringsItsPanelToTheFront) {
    Workspace t;
    t.ui.click("Desk/tabs/Scopes");
    EXPECT_TRUE(t.ui.exists("Desk/Scopes/Part/In Scopes"));
    EXPECT_FALSE(t.ui.exists("Desk/Parameters"));
    EXPECT_EQ(t.arranged, 1);
    t.ui.focus("Desk/Scopes/Part/In Scopes").key(Key::page_down, Mods::command);
    EXPECT_TRUE(t.ui.exists("Desk/Parameters")) << "by keys from inside";
}

TEST(Dock, ATabIsDraggedOntoAnotherGroup) {
    Workspace t;
    t.drag("Scopes", "Log", {0.5F, 0.5F});
    EXPECT_THAT(t.tabs_with("Log"), ElementsAre("Log")) << "not before it is let go";
    t.ui.release();
    EXPECT_THAT(t.tabs_with("Log"), ElementsAre("Log", "Scopes"));
    EXPECT_TRUE(t.ui.exists("Desk/Scopes"));
    EXPECT_TRUE(t.ui.exists("Desk/Parameters"));
}

TEST(Dock, ATabIsDraggedToASide) {
    Workspace t;
    t.drag("Scopes", "View", {0.5F, 0.95F});
    t.ui.release();
    EXPECT_EQ(t.ui.rect("Desk/View"), (Rect{0, 25, 600, 275}));
    EXPECT_EQ(t.ui.rect("Desk/Scopes"), (Rect{0, 329, 600, 275}));
    t.drag("Log", "View", {0.02F, 0.5F});
    t.ui.release();
    EXPECT_EQ(t.ui.rect("Desk/Log").x, 0);
    EXPECT_EQ(t.ui.rect("Desk/View").x, 302);
}

TEST(Dock, ATabIsDraggedAmongItsOwn) {
    Workspace t;
    t.ui.press("Desk/tabs/Parameters", {0.3F, 0.5F});
    t.ui.move(t.ui.rect("Desk/tabs/Scopes").at() + t.ui.rect("Desk/tabs/Scopes").size() * glm::vec2(0.9F, 0.5F));
    t.ui.release();
    EXPECT_THAT(t.tabs_with("Scopes"), ElementsAre("Scopes", "Parameters"));
}

TEST(Dock, WhereItWouldGoIsShown) {
    Workspace t;
    t.drag("Scopes", "View", {0.98F, 0.5F});
    EXPECT_EQ(t.ui.output().cursor, Cursor::move);
    const auto& shapes = t.ui.output().list->instances;
    const Instance& last = shapes[shapes.size() - 1];
    EXPECT_EQ((Rect{last.x, last.y, last.w, last.h}), (Rect{300, 0, 300, 604})) << "the right half of that group";
}

TEST(Dock, EscapeGivesADragUp) {
    Workspace t;
    const DockLayout before = t.layout;
    t.drag("Scopes", "View", {0.5F, 0.95F});
    t.ui.key(Key::escape).release();
    EXPECT_EQ(t.layout.nodes.size(), before.nodes.size());
    EXPECT_EQ(t.layout.find("Scopes"), before.find("Scopes"));
    t.drag("View", "View", {0.5F, 0.95F});
    t.ui.release();
    EXPECT_EQ(t.layout.nodes.size(), before.nodes.size()) << "a group of one is not split";
    t.drag("Scopes", "Log", {0.5F, 0.5F});
    t.ui.move({5000, 50}).release();
    EXPECT_EQ(t.layout.find("Scopes"), before.find("Scopes")) << "let go beside everything";
}

TEST(Dock, ClosesByTheCrossButNotTheLast) {
    Workspace t;
    t.ui.click("Desk/tabs/View", {.at = {0.9F, 0.5F}});
    EXPECT_THAT(t.layout.closed, ElementsAre("View"));
    EXPECT_EQ(t.ui.rect("Desk/Parameters").w, 1004);
    for (const char* name : {"Log", "Scopes"}) t.ui.click(std::string("Desk/tabs/") + name, {.button = Button::middle});
    t.ui.click("Desk/tabs/Parameters", {.button = Button::middle});
    EXPECT_TRUE(t.ui.exists("Desk/Parameters"));
    t.layout.show("View");
    t.ui.frame();
    EXPECT_TRUE(t.ui.exists("Desk/View"));
}

TEST(Dock, WhatIsInsideAPanelKeepsItsStateWhereverItGoes) {
    Workspace t;
    t.ui.click("Desk/Log/Part/header");
    EXPECT_FALSE(t.ui.is("Desk/Log/Part", Is::expanded));
    t.drag("Log", "View", {0.5F, 0.02F});
    t.ui.release();
    EXPECT_THAT(t.tabs_with("Log"), ElementsAre("Log"));
    EXPECT_FALSE(t.ui.is("Desk/Log/Part", Is::expanded));
    t.drag("Log", "Parameters", {0.5F, 0.5F});
    t.ui.release();
    EXPECT_FALSE(t.ui.is("Desk/Log/Part", Is::expanded));
}

TEST(Dock, EdgesAreDraggedInOneGesture) {
    Workspace t;
    t.ui.drag("Desk/edge 0", {-100, 0});
    EXPECT_EQ(t.ui.rect("Desk/View").w, 500);
    EXPECT_EQ(t.committed, 1);
    t.ui.drag("Desk/edge 2", {0, 50});
    EXPECT_EQ(t.ui.rect("Desk/Log").h, 225);
    t.ui.drag("Desk/edge 0", {-2000, 0});
    EXPECT_EQ(t.ui.rect("Desk/View").w, 84) << "6 em";
    t.ui.click("Desk/edge 0", {.clicks = 2});
    EXPECT_EQ(t.ui.rect("Desk/View").w, 500);
}

TEST(Dock, TakesInNewPanelsAndAWindowOfAnySize) {
    Workspace t;
    t.layout = dock_tabs({"View", "Old"});
    t.ui.frame();
    EXPECT_THAT(t.tabs_with("View"), ElementsAre("View", "Parameters", "Scopes", "Log"));
    t.layout = Workspace::standard();
    for (const glm::ivec2 size : {glm::ivec2(0, 0), glm::ivec2(30, 20), glm::ivec2(4000, 3000)}) {
        t.ui.size = size;
        t.ui.frame();
        for (const Node& node : t.ui.ui().tree()) ASSERT_GE(node.extent[0], 0);
    }
    EXPECT_EQ(t.ui.rect("Desk/Log").right(), 4000);
}

TEST(Dock, F6GoesFromPanelToPanel) {
    Workspace t;
    EXPECT_EQ(t.ui.key(Key::f6).focused(), "Desk/View/Part/header");
    EXPECT_EQ(t.ui.key(Key::f6).focused(), "Desk/Parameters/Part/header");
    EXPECT_EQ(t.ui.key(Key::f6).focused(), "Desk/Log/Part/header");
}

TEST(Dock, DisabledItStays) {
    Workspace t;
    t.disabled = true;
    t.ui.frame();
    t.drag("Scopes", "View", {0.5F, 0.95F});
    t.ui.release().click("Desk/tabs/Scopes").drag("Desk/edge 0", {-100, 0});
    EXPECT_EQ(t.layout, Workspace::standard());
}

TEST(Dock, SteadyFramesAndDragsAllocateNothing) {
    Workspace t;
    t.ui.press("Desk/tabs/Scopes", {0.3F, 0.5F});
    const auto move = [&](int i) {
        t.ui.ui().push({.kind = EventKind::pointer, .at = {20 + i % 50 * 18, 300}});
        t.ui.frame();
    };
    for (int i = 0; i < 100; ++i) move(i);
    const std::size_t before = test::allocations_so_far();
    for (int i = 0; i < 100; ++i) move(i);
    EXPECT_EQ(test::allocations_so_far() - before, 0U);
}

TEST(Dock, TheMenuOfATabClosesPanelsAndBringsThemBack) {
    Workspace t;
    t.ui.right_click("Desk/tabs/Scopes").click("Panels/Close Scopes");
    EXPECT_THAT(t.layout.closed, ElementsAre("Scopes"));
    EXPECT_THAT(t.tabs_with("Parameters"), ElementsAre("Parameters"));
    EXPECT_FALSE(t.ui.exists("Panels"));
    t.ui.right_click("Desk/tabs/Log").click("Panels/Show Scopes");
    EXPECT_TRUE(t.layout.closed.empty());
    EXPECT_THAT(t.tabs_with("Log"), ElementsAre("Log", "Scopes"));
    EXPECT_TRUE(t.ui.exists("Desk/Scopes")) << "in front";
    EXPECT_EQ(t.arranged, 2);
}

TEST(Dock, TheLastPanelCannotBeClosedFromItsMenu) {
    Workspace t;
    for (const char* panel : {"View", "Scopes", "Log"}) t.layout.close(panel);
    t.ui.frame().right_click("Desk/tabs/Parameters");
    EXPECT_TRUE(t.ui.is("Panels/Close Parameters", Is::disabled));
    EXPECT_TRUE(t.ui.exists("Panels/Show Log"));
}

/// Notes the keys that a view gets, and Ctrl+Home as a shortcut.
struct Home : Shortcuts {
    int pressed = 0;
    bool press(Key key, Mods mods) override {
        const bool is = key == Key::home && mods == Mods::command;
        pressed += is ? 1 : 0;
        return is;
    }
};

TEST(Dock, APressOnATabGivesTheKeysToItsPicture) {
    constexpr std::string_view panels[] = {"Reference", "View", "List"};
    DockLayout layout = dock_tabs({"Reference", "View", "List"});
    Home shortcuts;
    int left = 0;
    Harness ui(
        [&](Ui& u) {
            dock(u, "Desk", layout, panels, [&](std::size_t panel) {
                if (panel == 2) {
                    const ScrollArea area(u, "Rows");
                    for (int i = 0; i < 60; ++i) label(u, "row");
                    return;
                }
                button(u, "Above");
                const ViewportResult view = viewport(u, panel == 1 ? "Preview" : "Video", 0);
                for (const ViewportKey& key : view.keys) left += key.key == Key::left ? 1 : 0;
            });
        },
        {600, 400}, 1, &shortcuts);
    for (int i = 0; i < 2; ++i) {  // the second time it is in front already
        ui.click("Desk/tabs/View").frame();
        EXPECT_EQ(ui.focused(), "Desk/View/Preview");
        ui.key(Key::left);
        EXPECT_EQ(left, i + 1);
        ui.key(Key::escape);
    }
    ui.click("Desk/tabs/List").frame();
    ui.key(Key::home, Mods::command).key(Key::home).key(Key::del).key(Key::space);
    EXPECT_EQ(shortcuts.pressed, 1) << "not the first tab";
    EXPECT_TRUE(ui.exists("Desk/List")) << "neither another tab nor closed";
    const float top = ui.rect("Desk/List/Rows").y;
    ui.key(Key::page_down).frame();
    EXPECT_EQ(ui.rect("Desk/List/Rows").y, top);
    EXPECT_TRUE(ui.exists("Desk/List"));
    float scrolled = 0;
    for (const Node& node : ui.ui().tree())
        if (node.scroll != nullptr && node.scrolls[1]) scrolled = std::max(scrolled, node.scroll->offset.y);
    EXPECT_GT(scrolled, 100) << "pages turn in what the tab shows";
}

}  // namespace
}  // namespace lapfx::ui
