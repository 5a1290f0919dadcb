#include "ui/canvas/curve_editor.h"

#include <gmock/gmock.h>

#include <random>

#include "ui/core/tree.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

class CurveEditorTest : public testing::Test {
  protected:
    Curve curve{{{0, 0}, {0.25, 0.5}, {0.5, 0.25}, {1, 1}}};
    Curve standard = curve;
    CurveEditorOptions options{.height = {SizeKind::px, 300}, .tip = "How strong over how old"};
    Edit all;
    int began = 0, committed = 0, cancelled = 0;
    bool disabled = false;
    Harness ui{[this](Ui& u) {
                   u.push_disabled(disabled);
                   const Edit edit = curve_editor(u, "Curve", curve, options);
                   u.pop_disabled();
                   all |= edit;
                   began += edit.began ? 1 : 0, committed += edit.committed ? 1 : 0;
                   cancelled += edit.cancelled ? 1 : 0;
               },
               {640, 400}};
    // The margins around the graph are 42 px on the left, 13 on the right and above, 22 below (frame_of()).
    glm::vec2 graph() const { return {640 - 42 - 13, 300 - 13 - 22}; }
    glm::vec2 at(double x, double y) const {
        return {42 + static_cast<float>(x) * graph().x, 13 + static_cast<float>(1 - y) * graph().y};
    }
    glm::vec2 way(double x, double y) const {
        return {static_cast<float>(x) * graph().x, -static_cast<float>(y) * graph().y};
    }
    Harness& press_at(glm::vec2 place, Mods mods = Mods::none) {
        ui.frame(0.5);
        ui.move(place);
        return ui.send({.kind = EventKind::press, .mods = mods, .at = place});
    }
    void double_click(glm::vec2 place) {
        press_at(place);
        ui.send({.kind = EventKind::release, .at = place});
        ui.send({.kind = EventKind::press, .at = place});
    }
};

TEST_F(CurveEditorTest, EachPointIsANodeWhereItStands) {
    EXPECT_EQ(ui.text("Curve"), "4 points");
    const Rect rect = ui.rect("Curve/Point 2");
    EXPECT_NEAR(rect.center().x, at(0.25, 0.5).x, 1);
    EXPECT_NEAR(rect.center().y, at(0.25, 0.5).y, 1);
    EXPECT_GE(rect.w, 24) << "12 px around the point";
    EXPECT_EQ(ui.value("Curve/Point 2"), 0.5);
    EXPECT_EQ(ui.text("Curve/Point 2"), "0.250; 0.500");
    EXPECT_EQ(ui.node("Curve/Point 2").number->maximum, 1);
    EXPECT_FALSE(ui.exists("Curve/Point 5"));
    EXPECT_EQ(ui.tip("Curve"), "How strong over how old");
    EXPECT_TRUE(faults_of(ui.ui().tree()).empty());
}

TEST_F(CurveEditorTest, DragMovesAPointInOneGesture) {
    ui.drag("Curve/Point 2", way(0.1, 0.2));
    EXPECT_NEAR(curve.point(1).x, 0.35, 1e-6);
    EXPECT_NEAR(curve.point(1).y, 0.7, 1e-6);
    EXPECT_EQ(began, 1);
    EXPECT_EQ(committed, 1);
    EXPECT_TRUE(ui.is("Curve/Point 2", Is::selected));
}

TEST_F(CurveEditorTest, APressOrATinyMoveChangesNothing) {
    ui.drag("Curve/Point 2", {2, 1});
    ui.click("Curve/Point 3");
    EXPECT_EQ(curve, standard);
    EXPECT_EQ(began, 0);
}

TEST_F(CurveEditorTest, EscapeAndTheOtherButtonGiveBack) {
    ui.press("Curve/Point 2").drag_by(way(0.1, 0.2));
    EXPECT_FALSE(curve == standard);
    ui.key(Key::escape).release();
    EXPECT_EQ(curve, standard);
    EXPECT_EQ(cancelled, 1);
    EXPECT_EQ(committed, 0);
    ui.press("Curve/Point 2").drag_by(way(0.1, 0.2));
    ui.send({.kind = EventKind::press, .button = Button::right, .at = {300, 100}});
    EXPECT_EQ(curve, standard);
}

TEST_F(CurveEditorTest, ShiftMovesATenthAndCtrlInSteps) {
    ui.drag("Curve/Point 2", way(0.1, 0.2), Mods::shift);
    EXPECT_NEAR(curve.point(1).x, 0.26, 1e-6);
    EXPECT_NEAR(curve.point(1).y, 0.52, 1e-6);
    options.x_step = options.y_step = 0.1;
    ui.press("Curve/Point 2").drag_by(way(0.06, 0.06), Mods::command).release(Mods::command);
    EXPECT_DOUBLE_EQ(curve.point(1).x, 0.3);
    EXPECT_DOUBLE_EQ(curve.point(1).y, 0.6);
}

TEST_F(CurveEditorTest, APointStaysBetweenItsNeighboursAndInRange) {
    ui.drag("Curve/Point 2", way(2, 3));
    EXPECT_LT(curve.point(1).x, 0.5);
    EXPECT_NEAR(curve.point(1).x, 0.5, 1e-3);
    EXPECT_EQ(curve.point(1).y, 1);
    ui.drag("Curve/Point 1", way(-2, -3));
    EXPECT_EQ(curve.point(0).x, 0);
    EXPECT_EQ(curve.point(0).y, 0);
}

TEST_F(CurveEditorTest, ADragGoesOnOutsideOfTheGraph) {
    ui.press("Curve/Point 3").drag_by({20, 900});
    EXPECT_EQ(curve.point(2).y, 0);
    ui.drag_by({0, -900 + way(0, 0.1).y});
    EXPECT_NEAR(curve.point(2).y, 0.35, 1e-5);
    ui.release();
    EXPECT_EQ(committed, 1);
}

TEST_F(CurveEditorTest, OfTwoPointsInOnePlaceTheNearerIsMeant) {
    curve = Curve({{0, 0}, {0.5, 0.5}, {0.515, 0.5}, {1, 1}});
    ui.frame();
    press_at(at(0.5, 0.5) - glm::vec2(2, 0)).drag_by(way(0, 0.2)).release();
    EXPECT_NEAR(curve.point(1).y, 0.7, 1e-6);
    EXPECT_EQ(curve.point(2).y, 0.5);
    EXPECT_EQ(ui.focused(), "Curve/Point 2");
}

TEST_F(CurveEditorTest, DoubleClickInsertsAndGoesOnDragging) {
    double_click(at(0.75, 0.5));
    ASSERT_EQ(curve.size(), 5U);
    EXPECT_NEAR(curve.point(3).x, 0.75, 1e-6);
    EXPECT_NEAR(curve.point(3).y, 0.5, 1e-6);
    EXPECT_EQ(began, 1);
    EXPECT_EQ(committed, 0);
    ui.drag_by(way(0.1, 0.1)).release();
    EXPECT_NEAR(curve.point(3).x, 0.85, 1e-6);
    EXPECT_EQ(began, 1);
    EXPECT_EQ(committed, 1);
    EXPECT_TRUE(ui.is("Curve/Point 4", Is::selected));
}

TEST_F(CurveEditorTest, AnInsertionIsGivenUpByEscape) {
    double_click(at(0.75, 0.5));
    ui.drag_by(way(0.1, 0.1)).key(Key::escape).release();
    EXPECT_EQ(curve, standard);
    EXPECT_EQ(cancelled, 1);
}

TEST_F(CurveEditorTest, ABoxSelectsAndTheSelectionMovesTogether) {
    press_at(at(0.15, 0.7)).drag_by(way(0.45, -0.6)).release();
    EXPECT_FALSE(ui.is("Curve/Point 1", Is::selected));
    EXPECT_TRUE(ui.is("Curve/Point 2", Is::selected));
    EXPECT_TRUE(ui.is("Curve/Point 3", Is::selected));
    EXPECT_EQ(began, 0);
    ui.drag("Curve/Point 3", way(0.1, 0.1));
    EXPECT_NEAR(curve.point(1).x, 0.35, 1e-6);
    EXPECT_NEAR(curve.point(2).x, 0.6, 1e-6);
    EXPECT_NEAR(curve.point(1).y, 0.6, 1e-6);
    EXPECT_NEAR(curve.point(2).y, 0.35, 1e-6);
    EXPECT_EQ(curve.point(0).x, 0);
    ui.drag("Curve/Point 3", way(0, 5));
    EXPECT_EQ(curve.point(1).y, 1);
    EXPECT_NEAR(curve.point(2).y, 0.75, 1e-6) << "keeps its distance";
}

TEST_F(CurveEditorTest, EscapeGivesBackTheSelectionBeforeABox) {
    ui.click("Curve/Point 4");
    press_at(at(0.15, 0.7)).drag_by(way(0.45, -0.6));
    EXPECT_TRUE(ui.is("Curve/Point 2", Is::selected));
    ui.key(Key::escape).release();
    EXPECT_FALSE(ui.is("Curve/Point 2", Is::selected));
    EXPECT_TRUE(ui.is("Curve/Point 4", Is::selected));
}

TEST_F(CurveEditorTest, ShiftAddsToTheSelectionAndAPressBesideDropsIt) {
    ui.click("Curve/Point 2").click("Curve/Point 4", {.mods = Mods::shift});
    EXPECT_TRUE(ui.is("Curve/Point 2", Is::selected));
    EXPECT_TRUE(ui.is("Curve/Point 4", Is::selected));
    press_at(at(0.4, 0.8), Mods::shift).drag_by(way(0.2, -0.6)).release();
    EXPECT_TRUE(ui.is("Curve/Point 3", Is::selected));
    EXPECT_TRUE(ui.is("Curve/Point 2", Is::selected));
    press_at(at(0.8, 0.1)).release();
    EXPECT_FALSE(ui.is("Curve/Point 2", Is::selected));
}

TEST_F(CurveEditorTest, DeleteErasesWhatIsSelectedOrFocused) {
    ui.click("Curve/Point 2").click("Curve/Point 3", {.mods = Mods::shift}).key(Key::del);
    EXPECT_EQ(curve.size(), 2U);
    EXPECT_EQ(committed, 1);
    EXPECT_FALSE(ui.focused().empty());
    ui.focus("Curve/Point 1").key(Key::backspace);
    EXPECT_EQ(curve.size(), 1U);
    EXPECT_EQ(curve.point(0).x, 1);
    ui.focus("Curve/Point 1").key(Key::del);
    EXPECT_EQ(curve.size(), 1U) << "the last one stays";
    EXPECT_EQ(committed, 2);
}

TEST_F(CurveEditorTest, ArrowsMoveByAStep) {
    ui.focus("Curve/Point 2").key(Key::right);
    EXPECT_NEAR(curve.point(1).x, 0.26, 1e-12);
    ui.key(Key::up, Mods::command);
    EXPECT_NEAR(curve.point(1).y, 0.6, 1e-12);
    ui.key(Key::down, Mods::shift);
    EXPECT_NEAR(curve.point(1).y, 0.599, 1e-12);
    ui.key(Key::left);
    EXPECT_NEAR(curve.point(1).x, 0.25, 1e-12);
    EXPECT_EQ(began, 4);
    EXPECT_EQ(committed, 4);
}

TEST_F(CurveEditorTest, TypedFiguresAreYOrXAndY) {
    ui.focus("Curve/Point 2").type("1/4").key(Key::enter);
    EXPECT_EQ(curve.point(1).y, 0.25);
    EXPECT_EQ(curve.point(1).x, 0.25);
    ui.type("0.3; .9").key(Key::enter);
    EXPECT_NEAR(curve.point(1).x, 0.3, 1e-12);
    EXPECT_NEAR(curve.point(1).y, 0.9, 1e-12);
    ui.type("7;7").key(Key::enter);
    EXPECT_LT(curve.point(1).x, 0.5) << "as far as its neighbour";
    EXPECT_EQ(curve.point(1).y, 1);
    EXPECT_EQ(committed, 3);
}

TEST_F(CurveEditorTest, WhatCannotBeTakenStaysToBeMended) {
    ui.focus("Curve/Point 2").type("0.9*").key(Key::enter);
    EXPECT_TRUE(ui.is("Curve/Point 2", Is::invalid));
    EXPECT_EQ(curve, standard);
    ui.key(Key::backspace).key(Key::enter);
    EXPECT_FALSE(ui.is("Curve/Point 2", Is::invalid));
    EXPECT_NEAR(curve.point(1).y, 0.9, 1e-12);
}

TEST_F(CurveEditorTest, EscapeLeavesAnEntryAndTabTakesIt) {
    ui.focus("Curve/Point 2").type("0.9").key(Key::escape);
    EXPECT_EQ(curve, standard);
    EXPECT_EQ(ui.focused(), "Curve/Point 2");
    ui.type("0.9").key(Key::tab);
    EXPECT_NEAR(curve.point(1).y, 0.9, 1e-12);
    EXPECT_EQ(ui.focused(), "Curve/Point 3");
}

TEST_F(CurveEditorTest, DoubleClickOnAPointOpensItsEntry) {
    ui.click("Curve/Point 3", {.clicks = 2}).type("0.125").key(Key::enter);
    EXPECT_EQ(curve.point(2).y, 0.125);
    EXPECT_EQ(curve.size(), 4U);
}

TEST_F(CurveEditorTest, IInsertsHalfWayOnTheCurve) {
    const double y = curve.evaluate(0.375);
    ui.focus("Curve/Point 2").type("i");
    ASSERT_EQ(curve.size(), 5U);
    EXPECT_EQ(curve.point(2).x, 0.375);
    EXPECT_EQ(curve.point(2).y, y);
}

TEST_F(CurveEditorTest, KeysWaitForTheEndOfADrag) {
    ui.press("Curve/Point 2").drag_by({30, 0});
    ui.key(Key::del).key(Key::up);
    EXPECT_EQ(curve.size(), 4U);
    EXPECT_EQ(committed, 0);
    ui.release();
    EXPECT_EQ(began, 1);
    EXPECT_EQ(committed, 1);
}

TEST_F(CurveEditorTest, TellsWhetherItDiffersFromItsDefaultAndTheLiveValue) {
    options.standard = &standard;
    options.live = 0.25;
    ui.frame();
    EXPECT_FALSE(ui.is("Curve", Is::changed));
    EXPECT_EQ(ui.value("Curve"), 0.5);
    ui.drag("Curve/Point 2", way(0, 0.25));
    EXPECT_TRUE(ui.is("Curve", Is::changed));
}

TEST_F(CurveEditorTest, DisabledItTakesNothing) {
    disabled = true;
    ui.frame();
    ui.drag("Curve/Point 2", way(0.1, 0.1));
    double_click(at(0.75, 0.5));
    EXPECT_EQ(curve, standard);
    EXPECT_TRUE(ui.is("Curve/Point 2", Is::disabled));
    EXPECT_EQ(began, 0);
}

TEST_F(CurveEditorTest, TheProgramMayReplaceTheCurveDuringADrag) {
    ui.click("Curve/Point 2").click("Curve/Point 4", {.mods = Mods::shift});
    ui.press("Curve/Point 4").drag_by(way(0, -0.2));
    curve = Curve();
    ui.drag_by(way(0, 0.1)).release();
    EXPECT_EQ(curve, Curve());
    EXPECT_EQ(ui.text("Curve"), "2 points");
}

TEST_F(CurveEditorTest, NothingIsAllocatedWhileNothingChangesOrAPointIsDragged) {
    options.standard = &standard;
    ui.click("Curve/Point 2").settle();
    std::size_t before = test::allocations_so_far();
    for (int i = 0; i < 300; ++i) ui.frame();
    EXPECT_EQ(test::allocations_so_far(), before);
    ui.press("Curve/Point 2").drag_by(way(0.1, 0.2)).drag_by(way(-0.1, -0.2));
    before = test::allocations_so_far();
    for (int i = 0; i < 100; ++i) {
        ui.ui().push({.kind = EventKind::pointer, .at = at(0.3, 0.5) + glm::vec2(i % 7, i % 5)});
        ui.frame();
    }
    EXPECT_LE(test::allocations_so_far() - before, 20U) << "new texts of points are laid out, nothing else";
}

TEST_F(CurveEditorTest, AnyInputLeavesAValidCurve) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> x(0, 640), y(0, 300);
    const Key keys[] = {Key::left, Key::right, Key::up,     Key::down,      Key::del,
                        Key::tab,  Key::enter, Key::escape, Key::backspace, key_of('I')};
    const Mods mods[] = {Mods::none, Mods::shift, Mods::command, Mods::alt};
    for (int i = 0; i < 4000; ++i) {
        const glm::vec2 place{x(random), y(random)};
        const Mods with = mods[random() % 4];
        switch (random() % 6) {
            case 0:
                ui.send(
                    {.kind = EventKind::press, .button = static_cast<Button>(random() % 3), .mods = with, .at = place});
                break;
            case 1:
                ui.send({.kind = EventKind::release,
                         .button = static_cast<Button>(random() % 3),
                         .mods = with,
                         .at = place});
                break;
            case 2:
                ui.key(keys[random() % std::size(keys)], with);
                break;
            case 3:
                ui.send({.kind = EventKind::text, .codepoint = static_cast<char32_t>("0123.;-+x("[random() % 10])});
                break;
            default:
                ui.send({.kind = EventKind::pointer, .mods = with, .at = place});
        }
        ASSERT_TRUE(Curve::valid(curve.points()));
        for (const CurvePoint& p : curve.points()) {
            ASSERT_TRUE(p.x >= -1e-9 && p.x <= 1 + 1e-9 && p.y >= -1e-9 && p.y <= 1 + 1e-9) << i;
        }
        if (curve.size() > 40) curve = standard;
    }
}

}  // namespace
}  // namespace lapfx::ui
