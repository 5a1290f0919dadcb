#include "ui/core/ui.h"

#include <gmock/gmock.h>

#include "ui/core/tree.h"
#include "ui/support/harness.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/scroll.h"

namespace lapfx::ui {
namespace {

TEST(Ui, AButtonIsClickedByPointerEnterAndSpace) {
    int clicks = 0;
    Harness ui([&](Ui& u) { clicks += button(u, "Reset") ? 1 : 0; });
    ui.click("Reset");
    EXPECT_EQ(clicks, 1);
    ui.focus("Reset").key(Key::enter);
    EXPECT_EQ(clicks, 2);
    ui.key(Key::space);
    EXPECT_EQ(clicks, 3);
    EXPECT_TRUE(ui.is("Reset", Is::ringed));
}

TEST(Ui, PressAndReleaseInOneFrameBothCount) {
    int clicks = 0;
    Harness ui([&](Ui& u) { clicks += button(u, "Reset") ? 1 : 0; });
    const glm::vec2 at = ui.rect("Reset").center();
    for (int i = 0; i < 3; ++i) {
        ui.ui().push({.kind = EventKind::press, .at = at});
        ui.ui().push({.kind = EventKind::release, .at = at});
    }
    ui.frame();
    EXPECT_EQ(clicks, 3);
}

TEST(Ui, ReleaseElsewhereIsNoClick) {
    int clicks = 0;
    Harness ui([&](Ui& u) { clicks += button(u, "Reset") ? 1 : 0; });
    ui.press("Reset").drag_by({300, 200}).release();
    EXPECT_EQ(clicks, 0);
}

TEST(Ui, DisabledWidgetsTakeNothing) {
    int clicks = 0;
    Harness ui([&](Ui& u) {
        u.push_disabled(true);
        clicks += button(u, "Reset") ? 1 : 0;
        u.pop_disabled();
        button(u, "Other");
    });
    EXPECT_TRUE(ui.is("Reset", Is::disabled));
    ui.click("Reset");
    EXPECT_EQ(clicks, 0);
    ui.key(Key::tab);
    EXPECT_EQ(ui.focused(), "Other");
    ui.key(Key::tab);
    EXPECT_EQ(ui.focused(), "Other");
}

TEST(Ui, HiddenPartsOfLabelsTellWidgetsApart) {
    int left = 0, right = 0;
    Harness ui([&](Ui& u) {
        left += button(u, "Fit##left") ? 1 : 0;
        right += button(u, "Fit##right") ? 1 : 0;
    });
    EXPECT_EQ(ui.ui().duplicates(), 0U);
    EXPECT_THROW(ui.click("Fit"), std::invalid_argument);  // there are two: a test must say which one
}

TEST(Ui, ALabelMayChangeBehindThreeMarks) {
    int n = 0;
    Harness ui([&](Ui& u) { n += button(u, std::to_string(n) + " clips###clips") ? 1 : 0; });
    ui.click("0 clips");
    EXPECT_TRUE(ui.is("1 clips", Is::focused));
}

TEST(Ui, WidgetsOfOneNameWorkEachForItselfAndAreReported) {
    int clicks[2] = {};
    Harness ui([&](Ui& u) {
        for (int& each : clicks) each += button(u, "Same") ? 1 : 0;
    });
    EXPECT_EQ(ui.ui().duplicates(), 1U);
    EXPECT_THAT(faults_of(ui.ui().tree()), testing::ElementsAre(testing::HasSubstr("Same")));
    ui.key(Key::tab).key(Key::tab).key(Key::enter);
    EXPECT_EQ(clicks[0], 0);
    EXPECT_EQ(clicks[1], 1);
}

TEST(Ui, DoubleAndTripleClicksAreCountedOnOneWidgetOnly) {
    std::vector<int> seen;
    Harness ui([&](Ui& u) {
        for (const char* name : {"A", "B"}) {
            Node& node = u.leaf(Role::canvas, name, Sense::press);
            node.size[0] = px(50), node.size[1] = px(50);
            if (const Response r = u.respond(node); r.pressed) seen.push_back(r.clicks);
        }
    });
    ui.click("A", {.clicks = 3});
    ui.click("A").click("B");
    EXPECT_THAT(seen, testing::ElementsAre(1, 2, 3, 1, 1));
}

TEST(Ui, EscapeOrTheOtherButtonGivesUpADrag) {
    int cancelled = 0, released = 0;
    Harness ui([&](Ui& u) {
        Node& node = u.leaf(Role::canvas, "Area", Sense::press | Sense::context);
        node.size[0] = px(50), node.size[1] = px(50);
        const Response r = u.respond(node);
        cancelled += r.cancelled, released += r.released;
    });
    ui.press("Area").drag_by({10, 0}).key(Key::escape);
    EXPECT_EQ(cancelled, 1);
    ui.release();
    EXPECT_EQ(released, 0);
    ui.press("Area").send({.kind = EventKind::press, .button = Button::right, .at = ui.rect("Area").center()});
    EXPECT_EQ(cancelled, 2);
    ui.press("Area").send({.kind = EventKind::focus_lost});
    EXPECT_EQ(cancelled, 3);
}

TEST(Ui, TabGoesRoundInTheOrderOfBuildingAndShiftTabBack) {
    Harness ui([&](Ui& u) {
        Row row(u);
        for (const char* name : {"A", "B", "C"}) button(u, name);
    });
    for (const char* name : {"A", "B", "C", "A"}) EXPECT_EQ(ui.key(Key::tab).focused(), name);
    for (const char* name : {"C", "B", "A"}) EXPECT_EQ(ui.key(Key::tab, Mods::shift).focused(), name);
    ui.key(Key::escape);
    EXPECT_EQ(ui.focused(), "");
}

TEST(Ui, F6GoesFromPanelToPanel) {
    Harness ui([&](Ui& u) {
        for (const char* name : {"Left", "Right"}) {
            Panel panel(u, name);
            button(u, "First");
            button(u, "Second");
        }
    });
    EXPECT_EQ(ui.key(Key::f6).focused(), "Left/First");
    ui.key(Key::tab);
    EXPECT_EQ(ui.key(Key::f6).focused(), "Right/First");
    EXPECT_EQ(ui.key(Key::tab, Mods::command).focused(), "Left/First");
    EXPECT_EQ(ui.key(Key::f6, Mods::shift).focused(), "Right/First");
}

TEST(Ui, ATooltipStaysAwayFromWhatAPressHasOpened) {
    Harness ui([](Ui& u) {
        button(u, "Menu", {.tip = "Opens the menu"});
        button(u, "Other", {.tip = "Something else"});
    });
    const auto tooltip = [&] {
        return std::any_of(ui.ui().tree().begin(), ui.ui().tree().end(),
                           [](const Node& node) { return node.role == Role::tooltip; });
    };
    ui.click("Menu").frame(1).frame(1);
    EXPECT_FALSE(tooltip());
    ui.move_to("Other").frame(1).frame(1);
    EXPECT_TRUE(tooltip());
    ui.move_to("Menu").frame(1).frame(1);
    EXPECT_TRUE(tooltip()) << "come to anew";
}

TEST(Ui, ATooltipComesWhenThePointerRestsAndGoesWithIt) {
    Harness ui([&](Ui& u) { button(u, "Reset", {.tip = "Back to the defaults"}); });
    ui.move_to("Reset");
    const auto shown = [&] {
        for (const Node& node : ui.ui().tree()) {
            if (node.role == Role::tooltip) return std::string(node.text);
        }
        return std::string();
    };
    EXPECT_EQ(shown(), "");
    EXPECT_NEAR(ui.output().wake_at, ui.time + 0.5, 0.1);
    ui.frame(0.6);
    EXPECT_EQ(shown(), "Back to the defaults");
    ui.move({500, 400});
    EXPECT_EQ(shown(), "");
}

TEST(Ui, TheTooltipOfARowLeavesTheRowsBelowInSight) {
    Harness ui(
        [](Ui& u) {
            Row row(u, {.width = grow(), .height = grow()});
            for (const char* list : {"Left", "Right"}) {
                ScrollArea area(u, list, {.width = px(250)});
                for (const char* name : {"First", "Second", "Third"})
                    button(u, name, {.tip = "A tip that is long enough to be broken into several lines, as most are"});
            }
        },
        {1000, 300});
    const auto tip = [&] {
        for (const Node& node : ui.ui().tree())
            if (node.role == Role::tooltip) return node.rect();
        return Rect{};
    };
    ui.move_to("Right/First").frame(1).frame();
    EXPECT_FALSE(tip().empty());
    EXPECT_GE(tip().x, ui.rect("Right").right());
    EXPECT_EQ(tip().y, ui.rect("Right/First").y);
    ui.size = {500, 300};  // no room beside the lists
    ui.move_to("Left/First").frame(1).frame();
    EXPECT_FALSE(tip().empty());
    EXPECT_LE(tip().right(), 500);
}

TEST(Ui, AnOverlayOpensByNameClosesByEscapeAndGivesTheFocusBack) {
    Harness ui([&](Ui& u) {
        if (button(u, "Open")) u.open_overlay("box", OverlayKind::popup, {.side = Placement::Side::center});
        if (Node* node = u.open_overlay_node("box", Role::dialog, "Box", Axis::y)) {
            node->size[0] = px(100);
            button(u, "Inside");
            u.close_overlay_node();
        }
    });
    ui.focus("Open").key(Key::enter);
    EXPECT_TRUE(ui.exists("Box/Inside"));
    EXPECT_EQ(ui.focused(), "Box/Inside");
    EXPECT_EQ(ui.key(Key::tab).focused(), "Box/Inside") << "the focus stays within";
    ui.key(Key::escape);
    EXPECT_FALSE(ui.exists("Box"));
    EXPECT_EQ(ui.focused(), "Open");
    ui.key(Key::enter).click("Box/Inside");
    EXPECT_TRUE(ui.exists("Box"));
    ui.send({.kind = EventKind::press, .at = {5, 470}});
    EXPECT_FALSE(ui.exists("Box"));
}

TEST(Ui, AWidgetIsToldThatItLostTheFocusEvenIfItIsBuiltFirst) {
    int lost = 0;
    Harness ui([&](Ui& u) {
        Node& node = u.leaf(Role::text_field, "Field", Sense::press | Sense::focus);
        node.size[0] = px(50), node.size[1] = px(20);
        lost += u.respond(node).focus_out ? 1 : 0;
        const Id field = node.id;
        if (button(u, "Drop") && field != 0) u.set_focus(0);
        if (u.before(field) != nullptr && u.focus() == field && u.key_down(key_of('Q'))) u.set_focus(0);
    });
    ui.click("Field").key('Q');
    EXPECT_EQ(lost, 1);
}

TEST(Ui, WhatLiesUnderAModalCannotBeUsed) {
    int clicks = 0;
    bool open = true;
    Harness ui([&](Ui& u) {
        clicks += button(u, "Below") ? 1 : 0;
        if (std::exchange(open, false)) u.open_overlay("ask", OverlayKind::modal, {.side = Placement::Side::center});
        if (u.open_overlay_node("ask", Role::dialog, "Ask", Axis::y) != nullptr) {
            button(u, "Yes");
            u.close_overlay_node();
        }
    });
    const glm::vec2 at = ui.rect("Below").center();
    ui.send({.kind = EventKind::press, .at = at}).send({.kind = EventKind::release, .at = at});
    EXPECT_EQ(clicks, 0);
    EXPECT_TRUE(ui.exists("Ask"));
    ui.key(Key::escape).send({.kind = EventKind::press, .at = at}).send({.kind = EventKind::release, .at = at});
    EXPECT_EQ(clicks, 1);
}

TEST(Ui, AKeyThatMovesTheFocusDoesNotTypeThere) {
    std::u32string typed;
    Harness ui([&](Ui& u) {
        Node& node = u.leaf(Role::text_field, "Field", Sense::press | Sense::focus | Sense::typing);
        node.size[0] = node.size[1] = px(30);
        const Id field = node.id;
        u.events_of(field, [&](const Event& e) {
            if (e.kind == EventKind::text) typed += e.codepoint;
        });
        if (button(u, "To the field")) u.set_focus(field);
    });
    ui.focus("To the field").type(" ");
    EXPECT_EQ(ui.focused(), "Field");
    EXPECT_EQ(typed, U"");
    ui.type("a b");
    ui.send({.kind = EventKind::text, .codepoint = U'\u00e9'});  // from an input method: no key came before it
    EXPECT_EQ(typed, U"a b\u00e9");
}

TEST(Ui, OverlaysOverOneAreClosedAndPassiveOnesStay) {
    bool start = true;
    Harness ui([&](Ui& u) {
        if (std::exchange(start, false)) {
            u.open_overlay("low", OverlayKind::popup, {.side = Placement::Side::center});
            u.open_overlay("note", OverlayKind::passive, {.side = Placement::Side::bottom_right});
            u.open_overlay("high", OverlayKind::submenu, {.side = Placement::Side::center});
        }
        for (const char* name : {"low", "note", "high"}) {
            if (u.open_overlay_node(name, Role::menu, name, Axis::y) != nullptr) u.close_overlay_node();
        }
    });
    EXPECT_TRUE(ui.ui().overlay_on_top("high"));
    EXPECT_TRUE(ui.ui().close_overlays_over("low"));
    EXPECT_TRUE(ui.ui().overlay_on_top("low"));
    EXPECT_FALSE(ui.ui().close_overlays_over("low"));
    EXPECT_TRUE(ui.ui().overlay_open("note"));
    EXPECT_FALSE(ui.ui().overlay_open("high"));
}

TEST(Ui, WhatWasBuiltBeforeTheWidgetShowsItsEditInTheVeryFrame) {
    bool on = false;
    Harness ui([&](Ui& u) {
        label(u, on ? "now on" : "now off");
        if (button(u, "Switch")) on = !on;
    });
    const glm::vec2 at = ui.rect("Switch").center();
    ui.send({.kind = EventKind::press, .at = at}).send({.kind = EventKind::release, .at = at});
    EXPECT_TRUE(ui.exists("now on")) << ui.dump();
    EXPECT_EQ(ui.output().wake_at, never);
}

TEST(Ui, FocusTakenBetweenFramesIsTold) {
    int lost = 0;
    Harness ui([&](Ui& u) {
        Node& node = u.leaf(Role::text_field, "Field", Sense::press | Sense::focus);
        node.size[0] = px(50), node.size[1] = px(20);
        lost += u.respond(node).focus_out ? 1 : 0;
    });
    ui.click("Field");
    ui.ui().set_focus(0);
    ui.frame();
    EXPECT_EQ(lost, 1);
}

TEST(Ui, AnOverlayThatOpensTakesTheFocusAndTellsWhoHadIt) {
    int lost = 0;
    bool open = false;
    Harness ui([&](Ui& u) {
        Node& node = u.leaf(Role::text_field, "Field", Sense::press | Sense::focus);
        node.size[0] = px(50), node.size[1] = px(20);
        lost += u.respond(node).focus_out ? 1 : 0;
        if (std::exchange(open, false)) u.open_overlay("box", OverlayKind::popup, {.side = Placement::Side::center});
        if (u.open_overlay_node("box", Role::dialog, "Box", Axis::y) != nullptr) {
            button(u, "Inside");
            u.close_overlay_node();
        }
    });
    ui.click("Field");
    open = true;
    ui.frame();
    EXPECT_EQ(ui.focused(), "Box/Inside");
    EXPECT_EQ(lost, 1);
}

TEST(Ui, WhatNeverComesToRestStopsAskingForFrames) {
    Harness ui([](Ui& u) {
        button(u, "A");
        const Id a = u.last().id;
        button(u, "B");
        u.set_focus(u.focus() == a ? u.last().id : a);
    });
    for (int i = 0; i < 10; ++i) ui.frame();
    EXPECT_EQ(ui.output().wake_at, never);
}

TEST(Ui, KeysDuringADragAreForWhatIsDragged) {
    struct : Shortcuts {
        int ran = 0;
        bool press(Key, Mods) override { return ++ran; }
    } shortcuts;
    Harness ui(
        [](Ui& u) {
            Node& node = u.leaf(Role::canvas, "Area", Sense::press | Sense::focus);
            node.size[0] = px(50), node.size[1] = px(50);
            u.respond(node);
            button(u, "Next");
        },
        {640, 480}, 1, &shortcuts);
    ui.press("Area").key('Z', Mods::command).key(Key::tab);
    EXPECT_EQ(shortcuts.ran, 0);
    EXPECT_EQ(ui.focused(), "Area");
    ui.release().key('Z', Mods::command);
    EXPECT_EQ(shortcuts.ran, 1);
}

TEST(Ui, AKeyHeldDownIsOneClick) {
    int clicks = 0;
    Harness ui([&](Ui& u) { clicks += button(u, "Reset") ? 1 : 0; });
    ui.focus("Reset").key(Key::enter);
    for (int i = 0; i < 5; ++i) ui.send({.kind = EventKind::key, .key = Key::enter, .repeat = true});
    EXPECT_EQ(clicks, 1);
}

TEST(Ui, ATitleMayChangeBehindThreeMarksWithoutChangingWhatIsInside) {
    int n = 0;
    Harness ui([&](Ui& u) {
        u.open(Role::section, "Clips (" + std::to_string(n) + ")###clips", Axis::y);
        n += button(u, "Add") ? 1 : 0;
        u.close();
    });
    ui.click("Clips (0)/Add");
    EXPECT_TRUE(ui.is("Clips (1)/Add", Is::focused));
}

TEST(Ui, AnOverlayStaysWhereItsWidgetWas) {
    bool there = true, open = true;
    Harness ui([&](Ui& u) {
        space(u, 4);
        if (there) button(u, "Opener");
        const Id opener = u.last().id;
        if (std::exchange(open, false))
            u.open_overlay("box", OverlayKind::popup, {.side = Placement::Side::below, .anchor = opener});
        if (u.open_overlay_node("box", Role::dialog, "Box", Axis::y) != nullptr) {
            button(u, "Inside");
            u.close_overlay_node();
        }
    });
    const Rect before = ui.rect("Box");
    EXPECT_EQ(before.y, ui.rect("Opener").bottom());
    there = false;
    EXPECT_EQ(ui.frame().rect("Box"), before);
}

TEST(Ui, AStillFrameIsTheSamePictureAndAsksForNothing) {
    Harness ui([&](Ui& u) { button(u, "Reset"); });
    ui.frame();
    EXPECT_FALSE(ui.output().changed);
    EXPECT_EQ(ui.output().wake_at, never);
    ui.move_to("Reset");
    EXPECT_TRUE(ui.output().changed) << "it lights up in the very frame of the event";
}

TEST(Ui, AWakeFromAnotherThreadAsksForAFrame) {
    int called = 0;
    Harness ui([&](Ui& u) {
        button(u, "Reset");
        if (called == 0) u.set_waker([&] { ++called; });
    });
    ui.ui().wake("decoded");
    EXPECT_EQ(called, 1);
    EXPECT_STREQ(ui.ui().wake_reasons().empty() ? "" : ui.ui().wake_reasons().back().reason, "");
    ui.frame();
    EXPECT_EQ(ui.output().wake_at, never) << "the frame that came is what was asked for";
}

TEST(Ui, WhatFollowsASizeIsBuiltAgainBeforeItIsDrawn) {
    Harness ui([&](Ui& u) {
        Node& area = u.open(Role::canvas, "Area", Axis::y, Sense::press);
        area.size[0] = grow(), area.size[1] = grow();
        u.follow_size(area);
        const glm::vec2 middle = u.rect_before(area.id).size() * 0.5F;
        Node& child = u.leaf(Role::handle, "Middle", Sense::press);
        child.size[0] = px(10), child.size[1] = px(10);
        child.placed = true;
        child.placement = u.arena().make(Placement{.offset = middle, .pivot = {0.5F, 0.5F}});
        u.close();
    });
    EXPECT_EQ(ui.rect("Area/Middle").center(), ui.rect("Area").center());
    ui.size = {300, 200};
    ui.frame();
    EXPECT_EQ(ui.rect("Area/Middle").center(), glm::vec2(150, 100));
    const int builds = ui.ui().builds();
    ui.frame();
    EXPECT_EQ(ui.ui().builds(), builds + 1) << "a size that stays costs nothing";
}

TEST(Ui, GroundsAreClearedButInWhatIsPlacedOverAPicture) {
    bool placed = false;
    Harness ui([&](Ui& u) {
        Node& area = u.open(Role::canvas, "Area", Axis::y);
        area.size[0] = grow(), area.size[1] = grow();
        {
            Panel over(u, "Over", {.width = px(100), .height = px(100)});
            if (placed) {
                u.parent().placed = true;
                u.parent().placement = u.arena().make(Placement{});
            }
            Panel inner(u, "Inner");
        }
        Panel beside(u, "Beside");
        u.close();
    });
    const auto grounds = [&] { return std::pair(ui.output().list->clears.size(), ui.output().list->instances.size()); };
    EXPECT_EQ(grounds(), std::pair(std::size_t(4), std::size_t(0))) << "the window, and three panels";
    placed = true;
    ui.frame();
    EXPECT_EQ(grounds(), std::pair(std::size_t(2), std::size_t(2))) << "what is placed fills, and what is inside it";
}

TEST(Ui, AnyWindowAndScaleHold) {
    for (const glm::ivec2 size : {glm::ivec2(0, 0), glm::ivec2(1, 1), glm::ivec2(7680, 4320)}) {
        for (const float scale : {0.0F, 0.75F, 3.0F, std::numeric_limits<float>::quiet_NaN()}) {
            Harness ui(
                [&](Ui& u) {
                    Panel panel(u, "Panel");
                    button(u, "Reset");
                },
                size, scale);
            EXPECT_GE(ui.rect("Panel/Reset").w, 0);
        }
    }
}

TEST(Tree, FindsByPathAndNamesWhatIsThere) {
    Harness ui([&](Ui& u) {
        Panel panel(u, "Bleeding");
        button(u, "Speed");
    });
    EXPECT_TRUE(ui.exists("Bleeding/Speed"));
    EXPECT_TRUE(ui.exists("**/Speed"));
    EXPECT_FALSE(ui.exists("Speed"));
    EXPECT_THROW(ui.click("Bleeding/Sped"), std::invalid_argument);
    EXPECT_THAT(ui.dump(), testing::HasSubstr("button \"Speed\""));
    EXPECT_THAT(dump_json(ui.ui().tree()), testing::HasSubstr("\"path\": \"Bleeding/Speed\""));
}

}  // namespace
}  // namespace lapfx::ui
