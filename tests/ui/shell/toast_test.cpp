#include "ui/shell/toast.h"

#include <gmock/gmock.h>

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
    EXPECT_EQ(toasts.size(), 9U);
}

TEST_F(ToastTest, FourAreShownTheOthersWaitTheirTurn) {
    for (int i = 0; i < 6; ++i) toasts.add({.text = "Number " + std::to_string(i), .seconds = 2});
    ui.frame().frame(1);
    EXPECT_EQ(shown(), 4U);
    ui.frame(1.5).frame();
    EXPECT_EQ(shown(), 2U);
    EXPECT_TRUE(ui.exists("Notices/Number 5"));
    ui.frame(1.5);
    EXPECT_EQ(shown(), 2U) << "their time began when they were seen";
}

TEST_F(ToastTest, TheSameAgainIsCountedAndStaysAnew) {
    toasts.add({.kind = ToastKind::warning, .text = "Frame dropped", .seconds = 2});
    ui.frame().frame(1.5);
    toasts.add({.kind = ToastKind::warning, .text = "Frame dropped", .seconds = 2});
    ui.frame().frame(1.5);
    EXPECT_EQ(ui.text("Notices/Frame dropped"), "Frame dropped (2)");
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
    EXPECT_EQ(ui.key(Key::escape).focused(), "Field");
    EXPECT_EQ(toasts.size(), 2U);
    toasts.take_focus();
    EXPECT_EQ(ui.frame().focused(), "Notices/Second");
    EXPECT_EQ(ui.key(Key::del).frame().focused(), "Notices/First");
    EXPECT_EQ(ui.key(Key::enter).frame().focused(), "Field");
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
