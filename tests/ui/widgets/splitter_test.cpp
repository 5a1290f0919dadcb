#include "ui/widgets/splitter.h"

#include <limits>

#include "ui/core/node.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"
#include "ui/widgets/basic.h"

namespace lapfx::ui {
namespace {

/// Panes named First and Second in 604 px: 600 px and 4 for the handle.
struct Two {
    explicit Two(Axis along = Axis::x) : axis(along), ui([this](Ui& u) { build(u); }, {604, 604}) {}
    void build(Ui& u) {
        u.push_disabled(disabled);
        split_in_two(u);
        u.pop_disabled();
    }
    void split_in_two(Ui& u) {
        Splitter split(u, "Split", axis, fraction, {.first_minimum = 5, .second_minimum = 10, .standard = 0.25F});
        all.began |= split.edit().began, all.committed |= split.edit().committed;
        all.cancelled |= split.edit().cancelled;
        changes += split.edit().changed ? 1 : 0;
        pane(u, "First");
        split.next();
        pane(u, "Second");
    }
    static void pane(Ui& u, const char* name) {
        Node& node = u.leaf(Role::canvas, name);
        node.size[0] = node.size[1] = grow();
    }
    Axis axis;
    float fraction = 0.5F;
    bool disabled = false;
    Edit all;
    int changes = 0;
    Harness ui;
};

TEST(Splitter, SharesTheRoomByItsFractionInTheFirstFrame) {
    Two t;
    EXPECT_EQ(t.ui.rect("Split/First").w, 300);
    EXPECT_EQ(t.ui.rect("Split/Second").x, 304);
    EXPECT_EQ(t.ui.rect("Split/Second").right(), 604);
    EXPECT_EQ(t.ui.rect("Split/First").h, 604);
    Two down(Axis::y);
    EXPECT_EQ(down.ui.rect("Split/First").h, 300);
    EXPECT_EQ(down.ui.rect("Split/Second").y, 304);
}

TEST(Splitter, IsDraggedInOneGesture) {
    Two t;
    t.ui.press("Split/handle");
    EXPECT_FALSE(t.all.began) << "a press alone is no edit";
    t.ui.drag_by({60, 0});
    EXPECT_TRUE(t.all.began);
    EXPECT_FALSE(t.all.committed);
    EXPECT_EQ(t.changes, 4);
    EXPECT_EQ(t.ui.rect("Split/First").w, 360) << "in the frame of the event";
    t.ui.release();
    EXPECT_TRUE(t.all.committed);
    EXPECT_FLOAT_EQ(t.fraction, 0.6F);
    EXPECT_FLOAT_EQ(static_cast<float>(t.ui.value("Split/handle")), 0.6F);
    EXPECT_EQ(t.ui.output().cursor, Cursor::resize_x);
}

TEST(Splitter, EscapeAndTheOtherButtonPutItBack) {
    Two t;
    t.ui.press("Split/handle").drag_by({60, 0});
    t.changes = 0;
    t.ui.key(Key::escape);
    EXPECT_EQ(t.fraction, 0.5F);
    EXPECT_EQ(t.changes, 1) << "what follows it is to follow back";
    EXPECT_TRUE(t.all.cancelled);
    EXPECT_FALSE(t.all.committed);
    t.ui.release().press("Split/handle").drag_by({-60, 0});
    t.ui.send({.kind = EventKind::press, .button = Button::right, .at = {240, 300}});
    EXPECT_EQ(t.fraction, 0.5F);
}

TEST(Splitter, LeavesEachPaneItsLeast) {
    Two t;
    t.ui.drag("Split/handle", {-1000, 0});
    EXPECT_EQ(t.ui.rect("Split/First").w, 70);
    t.ui.drag("Split/handle", {1000, 0});
    EXPECT_EQ(t.ui.rect("Split/Second").w, 140);
    t.ui.size = {109, 100};  // 105 px for both, shared as 5 to 10
    t.ui.frame();
    EXPECT_EQ(t.ui.rect("Split/First").w, 35);
    EXPECT_EQ(t.ui.rect("Split/Second").w, 70);
}

TEST(Splitter, AWindowMadeSmallerAndLargerAgainKeepsTheFraction) {
    Two t;
    t.fraction = 0.2F;
    t.ui.size = {304, 604};
    t.ui.frame();
    EXPECT_EQ(t.ui.rect("Split/First").w, 70) << "not less than the least";
    t.ui.size = {604, 604};
    t.ui.frame();
    EXPECT_EQ(t.ui.rect("Split/First").w, 120);
}

TEST(Splitter, ADoubleClickAndBackspaceBringTheStandardBack) {
    Two t;
    t.ui.click("Split/handle", {.clicks = 2});
    EXPECT_FLOAT_EQ(t.fraction, 0.25F);
    EXPECT_TRUE(t.all.committed);
    t.fraction = 0.7F;
    t.ui.frame().focus("Split/handle").key(Key::backspace);
    EXPECT_FLOAT_EQ(t.fraction, 0.25F);
}

TEST(Splitter, KeysMoveItByAnEmAndToTheEnds) {
    Two t;
    t.ui.focus("Split/handle").key(Key::right);
    EXPECT_EQ(t.ui.rect("Split/First").w, 314);
    t.ui.key(Key::left).key(Key::left);
    EXPECT_EQ(t.ui.rect("Split/First").w, 286);
    t.ui.key(Key::home);
    EXPECT_EQ(t.ui.rect("Split/First").w, 70);
    t.ui.key(Key::end);
    EXPECT_EQ(t.ui.rect("Split/First").w, 460);
    Two down(Axis::y);
    down.ui.focus("Split/handle").key(Key::down);
    EXPECT_EQ(down.ui.rect("Split/First").h, 314);
}

TEST(Splitter, ANumberThatIsNoneCountsAsTheStandard) {
    Two t;
    t.fraction = std::numeric_limits<float>::quiet_NaN();
    t.ui.frame();
    EXPECT_EQ(t.ui.rect("Split/First").w, 150);
}

TEST(Splitter, DisabledItStays) {
    Two t;
    t.disabled = true;
    t.ui.frame().drag("Split/handle", {60, 0});
    EXPECT_EQ(t.fraction, 0.5F);
}

TEST(Splitter, DraggingAllocatesNothing) {
    Two t;
    t.ui.press("Split/handle");
    const auto move = [&](int i) {
        t.ui.ui().push({.kind = EventKind::pointer, .at = {302 + i % 50, 300}});
        t.ui.frame();
    };
    for (int i = 0; i < 100; ++i) move(i);
    const std::size_t before = test::allocations_so_far();
    for (int i = 0; i < 100; ++i) move(i);
    EXPECT_EQ(test::allocations_so_far() - before, 0U);
}

}  // namespace
}  // namespace lapfx::ui
