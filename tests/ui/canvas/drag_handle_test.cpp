#include "ui/canvas/drag_handle.h"

#include <gmock/gmock.h>

#include "ui/core/node.h"
#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

/// A grip that moves along 0..200 px for the values 0..100.
struct Grip {
    double value = 50;
    bool disabled = false;
    Edit last;
    int began = 0, changed = 0, committed = 0, cancelled = 0;
    Harness ui{[this](Ui& u) {
        Node& node = u.open(Role::canvas, "Area", Axis::y);
        node.size[0] = px(200), node.size[1] = px(60);
        u.push_disabled(disabled);
        const HandleMoves moves =
            put_handle(u, {.label = "Grip", .tip = "What it does", .at = {static_cast<float>(2 * value), 30}});
        last = edit_by_handle(u, moves, {.minimum = 0, .maximum = 100, .step = 5, .reset = 25, .initial = 10},
                              moves.steps.x + moves.steps.y, static_cast<double>(moves.to.x) / 2, value);
        u.last().number = u.number(value, 0, 100, 5);
        u.draw_with<draw_knob>(u.last(), KnobLook{.color = u.theme().text});
        u.pop_disabled();
        u.close();
        began += last.began, changed += last.changed, committed += last.committed, cancelled += last.cancelled;
    }};
};

TEST(DragHandle, FollowsThePointerFromWhereItWasGripped) {
    Grip g;
    g.ui.press("Area/Grip", {0.9F, 0.5F});
    EXPECT_EQ(g.value, 50) << "a press moves nothing";
    g.ui.drag_by({40, 7}).release();
    EXPECT_EQ(g.value, 70);
    EXPECT_EQ(g.began, 1);
    EXPECT_EQ(g.changed, 4);
    EXPECT_EQ(g.committed, 1);
    EXPECT_EQ(g.cancelled, 0);
}

TEST(DragHandle, StopsAtItsEndsAndComesBackWithThePointer) {
    Grip g;
    g.ui.press("Area/Grip").drag_by({400, 0});
    EXPECT_EQ(g.value, 100);
    g.ui.drag_by({-320, 0});
    EXPECT_EQ(g.value, 90);
    g.ui.release();
    EXPECT_EQ(g.value, 90);
}

TEST(DragHandle, ShiftIsATenthOfTheWayAndControlWholeSteps) {
    Grip g;
    g.ui.drag("Area/Grip", {40, 0}, Mods::shift);
    EXPECT_NEAR(g.value, 52, 1e-5);
    g.ui.drag("Area/Grip", {23, 0}, Mods::command);
    EXPECT_EQ(g.value, 65);
}

TEST(DragHandle, EscapeAndTheRightButtonRestore) {
    Grip g;
    g.ui.press("Area/Grip").drag_by({40, 0}).key(Key::escape);
    EXPECT_EQ(g.value, 50);
    EXPECT_EQ(g.cancelled, 1);
    g.ui.release();
    EXPECT_EQ(g.committed, 0);
    g.ui.press("Area/Grip").drag_by({-40, 0});
    g.ui.send({.kind = EventKind::press, .button = Button::right, .at = {60, 30}});
    EXPECT_EQ(g.value, 50);
    EXPECT_EQ(g.cancelled, 2);
}

TEST(DragHandle, APressWithoutAMoveIsNoEdit) {
    Grip g;
    g.ui.click("Area/Grip");
    g.ui.press("Area/Grip").key(Key::escape);
    EXPECT_EQ(g.began + g.changed + g.committed + g.cancelled, 0);
}

TEST(DragHandle, KeysStep) {
    Grip g;
    g.ui.focus("Area/Grip").key(Key::right);
    EXPECT_EQ(g.value, 55);
    EXPECT_TRUE(g.ui.is("Area/Grip", Is::ringed));
    g.ui.key(Key::up);
    EXPECT_EQ(g.value, 60);
    g.ui.key(Key::left, Mods::shift);
    EXPECT_EQ(g.value, 59.5);
    g.ui.key(Key::down);
    EXPECT_EQ(g.value, 54.5);
    g.ui.key(Key::page_up);
    EXPECT_EQ(g.value, 100);
    g.ui.key(Key::page_down);
    EXPECT_EQ(g.value, 50);
    g.ui.key(Key::home);
    EXPECT_EQ(g.value, 0);
    g.ui.key(Key::end);
    EXPECT_EQ(g.value, 100);
    EXPECT_EQ(g.began, 8);
    EXPECT_EQ(g.committed, 8);
    g.ui.key(Key::right);
    EXPECT_EQ(g.began, 8) << "what changes nothing is no edit";
}

TEST(DragHandle, DoubleClickAndBackspaceReset) {
    Grip g;
    g.ui.click("Area/Grip", {.clicks = 2});
    EXPECT_EQ(g.value, 25);
    EXPECT_EQ(g.committed, 1);
    g.value = 80;
    g.ui.frame().focus("Area/Grip").key(Key::backspace);
    EXPECT_EQ(g.value, 25);
    g.ui.key(Key::backspace, Mods::shift);
    EXPECT_EQ(g.value, 10) << "the default, as everywhere";
    EXPECT_EQ(g.committed, 3);
}

TEST(DragHandle, ADisabledOneTakesNothing) {
    Grip g;
    g.disabled = true;
    g.ui.frame().drag("Area/Grip", {40, 0});
    EXPECT_EQ(g.value, 50);
    EXPECT_TRUE(g.ui.is("Area/Grip", Is::disabled));
    EXPECT_THROW(g.ui.focus("Area/Grip"), std::runtime_error);
}

TEST(DragHandle, IsSpokenOfAndLargeEnough) {
    Grip g;
    EXPECT_EQ(g.ui.value("Area/Grip"), 50);
    EXPECT_EQ(g.ui.tip("Area/Grip"), "What it does");
    EXPECT_EQ(g.ui.node("Area/Grip").role, Role::handle);
    EXPECT_GE(g.ui.rect("Area/Grip").w, 24);
    EXPECT_EQ(g.ui.rect("Area/Grip").center(), glm::vec2(100, 30));
    g.ui.move_to("Area/Grip");
    EXPECT_EQ(g.ui.output().cursor, Cursor::move);
}

}  // namespace
}  // namespace lapfx::ui
