#include "ui/shell/toast.h"

#include <gmock/gmock.h>

#include "ui/core/node.h"
#include "ui/support/harness.h"
#include "ui/widgets/basic.h"

namespace lapfx::ui {
namespace {

class ToastTest : public testing::Test {
  protected:
    Toasts toasts;
    Harness ui{[this](Ui& u) {
        button(u, "Field");
        toasts.build(u);
    }};
    std::size_t shown() {
        std::size_t count = 0;
        for (const Node& node : ui.ui().tree()) count += node.role == Role::status ? 1 : 0;
        return count;
    }
};

TEST_F(ToastTest, OneComesAndGoesByItselfAfterAnIdleHour) {
    ui.frame(3600);
    toasts.add({.text = "Saved"});
    ui.frame(3600);
    EXPECT_EQ(ui.text("Notices/Saved"), "Saved");
    EXPECT_EQ(ui.node("Notices/Saved").role, Role::status);
    EXPECT_NEAR(ui.output().wake_at, ui.time + 5, 0.1) << "and nothing wakes the program before";
    ui.frame(4.9);
    EXPECT_TRUE(ui.exists("Notices/Saved")) << "its time begins when it is seen";
    ui.frame(0.2);
    EXPECT_EQ(toasts.size(), 0U);
    ui.frame();
    EXPECT_FALSE(ui.exists("Notices"));
    EXPECT_EQ(ui.frame().output().wake_at, never);
}

TEST_F(ToastTest, ErrorsStayUntilTheyAreClicked) {
    toasts.add({.kind = ToastKind::error, .text = "Disk full"});
    ui.frame().frame(1).frame(1e6);
    EXPECT_EQ(ui.output().wake_at, never);
    ui.click("Notices/Disk full");
    EXPECT_EQ(toasts.size(), 0U);
}

TEST_F(ToastTest, ItStaysWhileThePointerIsOnIt) {
    toasts.add({.text = "Saved", .seconds = 2});
    ui.frame().frame();
    ui.move_to("Notices/Saved").frame(10).frame(10);
    EXPECT_TRUE(ui.exists("Notices/Saved"));
    ui.move({5, 5}).frame(1);
    EXPECT_TRUE(ui.exists("Notices/Saved"));
    ui.frame(1.5);
    EXPECT_EQ(toasts.size(), 0U);
}

TEST_F(ToastTest, ItsButtonActsOnceAndItGoes) {
    int acted = 0;
    toasts.add({.text = "Exported", .action = "Show", .act = [&] {
                    ++acted;
                    for (int i = 0; i < 9; ++i) toasts.add({.text = "More " + std::to_string(i)});
                }});
    ui.frame().click("Notices/Exported/Show");
    EXPECT_EQ(acted, 1);
    EXPECT_FALSE(ui.frame().exists("Notices/Exported"));
    EXPECT_EQ(toasts.size(), Toasts::most_kept);
    EXPECT_TRUE(ui.exists("Notices/More 8"));
}

TEST_F(ToastTest, TheNewestIsSeenAndTheOldestGiveWayToIt) {
    for (int i = 0; i < 6; ++i) toasts.add({.text = "Number " + std::to_string(i), .seconds = 2});
    ui.frame();
    EXPECT_EQ(shown(), Toasts::most_kept);
    EXPECT_TRUE(ui.exists("Notices/Number 5"));
    EXPECT_GT(ui.rect("Notices/Number 5").y, ui.rect("Notices/Number 4").bottom()) << "at the bottom";
    EXPECT_FALSE(ui.exists("Notices/Number 1"));
    EXPECT_TRUE(ui.exists("Notices/2 more in All notices##rest") || ui.exists("Notices/2 more in All notices"))
        << ui.dump();
}

TEST_F(ToastTest, AnErrorStaysRatherThanWhatGoesByItself) {
    toasts.add({.kind = ToastKind::error, .text = "Disk full"});
    for (int i = 0; i < 9; ++i) toasts.add({.text = "Number " + std::to_string(i)});
    ui.frame();
    EXPECT_TRUE(ui.exists("Notices/Disk full"));
    EXPECT_TRUE(ui.exists("Notices/Number 8"));
    for (int i = 0; i < 9; ++i) toasts.add({.kind = ToastKind::error, .text = "Fault " + std::to_string(i)});
    ui.frame();
    EXPECT_EQ(shown(), Toasts::most_kept) << "however many errors there are";
    EXPECT_TRUE(ui.exists("Notices/Fault 8"));
}

TEST_F(ToastTest, ALongOneInASmallWindowStaysWithinIt) {
    ui.size = {500, 400};
    ui.scale = 2;
    std::string text = "A fault";
    for (int i = 0; i < 80; ++i) text += " of many words";
    for (const std::string each : {"first", "second", "third"}) toasts.add({.kind = ToastKind::error, .text = each});
    toasts.add({.kind = ToastKind::error, .text = text});
    ui.frame().frame();
    const Rect card = ui.rect("Notices/" + text);
    EXPECT_GE(card.x, 0);
    EXPECT_GE(card.y, 0);
    EXPECT_LE(card.right(), 500);
    EXPECT_LE(card.bottom(), 400 - ui.ui().row_height()) << "the status bar is free";
    EXPECT_EQ(shown(), 1U) << "there is no room for the others";
    ui.click("Notices/3 more in All notices");
    EXPECT_TRUE(ui.exists("All notices/Log/" + text)) << "all of it is there: " << ui.dump();
    EXPECT_TRUE(ui.exists("All notices/Log/second"));
}

TEST_F(ToastTest, EachHasAButtonThatCloses) {
    int acted = 0;
    toasts.add({.kind = ToastKind::error, .text = "First", .action = "Show", .act = [&] { ++acted; }});
    toasts.add({.kind = ToastKind::error, .text = "Second"});
    ui.frame().click("Notices/First/Close").frame();
    EXPECT_FALSE(ui.exists("Notices/First"));
    EXPECT_TRUE(ui.exists("Notices/Second"));
    EXPECT_EQ(acted, 0);
}

TEST_F(ToastTest, EscClosesTheNewestWhenNothingElseTakesIt) {
    toasts.add({.kind = ToastKind::error, .text = "First"});
    toasts.add({.kind = ToastKind::error, .text = "Second"});
    ui.frame().frame().key(Key::escape).frame();
    EXPECT_FALSE(ui.exists("Notices/Second"));
    EXPECT_TRUE(ui.exists("Notices/First"));
    ui.click("Field").key(Key::escape).frame();
    EXPECT_EQ(toasts.size(), 0U) << "a button that was clicked is nothing one would leave by Esc";
    toasts.add({.kind = ToastKind::error, .text = "Third"});
    ui.focus("Field").key(Key::escape).frame();
    EXPECT_EQ(toasts.size(), 1U) << "here it leaves the field that the keyboard is on";
    EXPECT_EQ(ui.focused(), "");
}

TEST_F(ToastTest, AllOfThemAreInTheLogTheNewestFirst) {
    for (int i = 0; i < 3; ++i) toasts.add({.kind = ToastKind::warning, .text = "Frame dropped"});
    for (int i = 0; i < 7; ++i) toasts.add({.text = "Number " + std::to_string(i), .seconds = 1});
    ui.frame().frame(2).frame();
    ASSERT_EQ(toasts.log().size(), 8U);
    EXPECT_EQ(toasts.log().front().text, "Frame dropped");
    EXPECT_EQ(toasts.log().front().count, 3);
    toasts.open_log(ui.ui());
    ui.frame().frame();
    EXPECT_LT(ui.rect("All notices/Log/Number 6").y, ui.rect("All notices/Log/Number 5").y);
    ui.click("All notices/Copy all");
    EXPECT_THAT(ui.clipboard().get(), testing::StartsWith("Frame dropped  x3\nNumber 0\n"));
    ui.click("All notices/Clear").click("All notices/Close").frame();
    EXPECT_TRUE(toasts.log().empty());
    for (std::size_t i = 0; i < Toasts::most_notes + 5; ++i) toasts.add({.text = std::to_string(i)});
    EXPECT_EQ(toasts.log().size(), Toasts::most_notes);
    EXPECT_EQ(toasts.log().back().text, std::to_string(Toasts::most_notes + 4));
}

TEST_F(ToastTest, TheSameAgainIsCountedAndStaysAnew) {
    toasts.add({.kind = ToastKind::warning, .text = "Frame dropped", .seconds = 2});
    ui.frame().frame(1.5);
    toasts.add({.kind = ToastKind::warning, .text = "Frame dropped", .seconds = 2});
    ui.frame().frame(1.5);
    EXPECT_EQ(ui.text("Notices/Frame dropped"), "Frame dropped  x2");
    EXPECT_EQ(toasts.size(), 1U);
}

TEST_F(ToastTest, ItTakesTheKeyboardFromNobody) {
    ui.focus("Field");
    toasts.add({.text = "Exported", .action = "Show"});
    ui.frame();
    EXPECT_EQ(ui.focused(), "Field");
    EXPECT_EQ(ui.key(Key::tab).focused(), "Field");
    ui.click("Notices/Exported/Show");
    EXPECT_EQ(ui.focused(), "Field");
}

TEST_F(ToastTest, AskedForTheyHaveTheKeyboardAndGiveItBack) {
    ui.focus("Field");
    toasts.add({.text = "First", .seconds = 2});
    toasts.add({.kind = ToastKind::error, .text = "Second"});
    ui.frame().frame();
    toasts.take_focus();
    EXPECT_EQ(ui.frame().focused(), "Notices/Second") << "the newest";
    EXPECT_TRUE(ui.is("Notices/Second", Is::ringed));
    EXPECT_EQ(ui.key(Key::up).focused(), "Notices/First");
    EXPECT_TRUE(ui.frame(5).exists("Notices/First")) << "its time stands";
    toasts.take_focus();
    EXPECT_EQ(ui.frame().focused(), "Field");
    EXPECT_EQ(toasts.size(), 2U);
    toasts.take_focus();
    EXPECT_EQ(ui.frame().focused(), "Notices/Second");
    EXPECT_EQ(ui.key(Key::del).frame().focused(), "Notices/First");
    EXPECT_EQ(ui.key(Key::escape).frame().focused(), "Field") << "Esc closes it";
    EXPECT_EQ(toasts.size(), 0U);
    toasts.take_focus();
    EXPECT_EQ(ui.frame().focused(), "Field") << "there is none";
}

TEST_F(ToastTest, EnterIsItsButton) {
    int acted = 0;
    ui.focus("Field");
    toasts.add({.text = "Other", .seconds = 0});
    toasts.add({.text = "Exported", .action = "Show", .act = [&] { ++acted; }});
    ui.frame();
    toasts.take_focus();
    ui.frame().key(Key::enter).frame();
    EXPECT_EQ(acted, 1);
    EXPECT_EQ(toasts.size(), 1U);
    EXPECT_EQ(ui.focused(), "Field");
    ui.click("Notices/Other");
    EXPECT_EQ(acted, 1);
    EXPECT_EQ(ui.focused(), "Field");
}

TEST_F(ToastTest, ItLiesInTheLowerRightCornerAndALongTextIsBroken) {
    toasts.add({.text = "Short"});
    ui.frame();
    const float line = ui.rect("Notices/Short").h;
    EXPECT_NEAR(ui.rect("Notices/Short").right(), 640 - 11, 1);
    EXPECT_NEAR(ui.rect("Notices/Short").bottom(), 480 - 11 - 25, 1);
    std::string text = "long";
    for (int i = 0; i < 30; ++i) text += " and longer";
    toasts.add({.text = text});
    ui.frame();
    EXPECT_GT(ui.rect("Notices/" + text).h, 4 * line);
    EXPECT_LT(ui.rect("Notices/Short").bottom(), ui.rect("Notices/" + text).y);
}

}  // namespace
}  // namespace lapfx::ui
