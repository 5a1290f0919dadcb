#include "ui/widgets/text_field.h"

#include <gtest/gtest.h>

#include "ui/core/node.h"
#include "ui/support/count_allocations.h"
#include "ui/support/count_decoded.h"
#include "ui/support/harness.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/field.h"

namespace lapfx::ui {
namespace {

struct TextFieldTest : testing::Test {
    std::string text = "alpha beta gamma", other = "other";
    TextFieldOptions options;
    Edit all;
    int commits = 0, begins = 0, cancels = 0;
    bool search = false;

    Harness ui{[this](Ui& u) {
        const Edit edit = search ? search_field(u, "Name", text, options) : text_field(u, "Name", text, options);
        commits += edit.committed, begins += edit.began, cancels += edit.cancelled;
        all |= edit;
        text_field(u, "Other", other);
    }};

    /// px in the window of the place before byte `n`, when nothing is scrolled.
    glm::vec2 place(std::size_t n) {
        const Rect rect = ui.rect("Name");
        return {rect.x + ui.ui().em(0.5F) + Harness::fonts().run(text, ui.ui().text_style()).x_of(n), rect.center().y};
    }
    void press_at(std::size_t n, Mods mods = Mods::none) {
        ui.send({.kind = EventKind::press, .mods = mods, .at = place(n)});
    }
    void click_at(std::size_t n, Mods mods = Mods::none) {
        press_at(n, mods);
        ui.release(mods);
    }
    std::string copied() {
        ui.clipboard().text = "(nothing)";
        ui.key('C', Mods::command);
        return ui.clipboard().text;
    }
};

TEST_F(TextFieldTest, ATypedCharacterIsInTheTextInTheSameFrame) {
    click_at(5);
    ui.type("X");
    EXPECT_EQ(text, "alphaX beta gamma");
    EXPECT_EQ(ui.text("Name"), "alphaX beta gamma");
    EXPECT_EQ(begins, 1);
    EXPECT_EQ(commits, 0);
    ui.type("Y");
    EXPECT_EQ(begins, 1);
}

TEST_F(TextFieldTest, EnterCommitsAndStays) {
    ui.focus("Name").type("new").key(Key::enter);
    EXPECT_EQ(text, "new");
    EXPECT_EQ(commits, 1);
    EXPECT_EQ(ui.focused(), "Name");
    ui.key(Key::enter);
    EXPECT_EQ(commits, 1) << "nothing has changed since";
}

TEST_F(TextFieldTest, LeavingCommitsByTabAndByPointer) {
    ui.focus("Name").type("one").key(Key::tab);
    EXPECT_EQ(commits, 1);
    EXPECT_EQ(ui.focused(), "Other");
    ui.click("Name").type("two");
    ui.click("Other");
    EXPECT_EQ(commits, 2);
    ui.click("Name").click("Other");
    EXPECT_EQ(commits, 2) << "nothing was typed";
}

TEST_F(TextFieldTest, EscapeGoesBackToWhatWasCommittedAndThenLeaves) {
    ui.focus("Name").type("one").key(Key::enter).type("two").key(Key::escape);
    EXPECT_EQ(text, "one");
    EXPECT_EQ(cancels, 1);
    EXPECT_EQ(ui.focused(), "Name");
    ui.key(Key::escape);
    EXPECT_EQ(ui.focused(), "");
    EXPECT_EQ(commits, 1);
}

TEST_F(TextFieldTest, TabComesWithAllSelectedAndAPressDoesNot) {
    ui.focus("Name");
    EXPECT_EQ(copied(), "alpha beta gamma");
    ui.key(Key::tab);
    click_at(3);
    EXPECT_EQ(copied(), "(nothing)");
}

TEST_F(TextFieldTest, APressPlacesTheCaretAtTheNearestCharacter) {
    click_at(0);
    ui.type("<");
    click_at(text.size());
    ui.type(">");
    EXPECT_EQ(text, "<alpha beta gamma>");
}

TEST_F(TextFieldTest, ShiftWithAPressOrAnArrowSelects) {
    click_at(6);
    click_at(10, Mods::shift);
    EXPECT_EQ(copied(), "beta");
    ui.key(Key::left, Mods::shift);
    EXPECT_EQ(copied(), "bet");
    ui.key(Key::end, Mods::shift);
    EXPECT_EQ(copied(), "beta gamma");
    ui.key(Key::home, Mods::shift);
    EXPECT_EQ(copied(), "alpha ");
}

TEST_F(TextFieldTest, TwoPressesTakeTheWordThreeAll) {
    const float at = (place(8).x - ui.rect("Name").x) / ui.rect("Name").w;
    ui.click("Name", {.clicks = 2, .at = {at, 0.5F}});
    EXPECT_EQ(copied(), "beta");
    ui.frame(1);
    ui.click("Name", {.clicks = 3, .at = {at, 0.5F}});
    EXPECT_EQ(copied(), "alpha beta gamma");
}

TEST_F(TextFieldTest, ADragSelects) {
    press_at(6);
    ui.drag_by(place(10) - place(6)).release();
    EXPECT_EQ(copied(), "beta");
}

TEST_F(TextFieldTest, ADragBeyondTheEdgeScrollsAndGoesOnWhileThePointerRests) {
    for (int i = 0; i < 60; ++i) text += " and so on " + std::to_string(i);
    ui.frame();
    press_at(2);
    ui.move({ui.rect("Name").right() + 40, ui.rect("Name").center().y});
    EXPECT_LT(ui.output().wake_at, ui.time + 0.1);
    const auto selected = [&] { return copied().size(); };
    const std::size_t first = selected();
    for (int i = 0; i < 30; ++i) ui.frame();
    const std::size_t then = selected();
    EXPECT_GT(then, first + 10);
    for (int i = 0; i < 30; ++i) ui.frame(0);
    EXPECT_LT(selected(), then + 8) << "time has not gone on but for the keys that copy";
    for (int i = 0; i < 3000; ++i) ui.frame();
    EXPECT_EQ(selected(), text.size() - 2);
    ui.release().frame();
    EXPECT_GT(ui.output().wake_at, ui.time + 0.1);
}

TEST_F(TextFieldTest, APointerHeldBeyondTheEndLetsTheMachineSleep) {
    press_at(3);
    ui.move({ui.rect("Name").right() + 40, ui.rect("Name").center().y});
    EXPECT_GT(ui.output().wake_at, ui.time + 0.1) << "nothing is left to scroll to";
}

TEST_F(TextFieldTest, ARightClickKeepsTheSelectionAndOffersWhatIsUsual) {
    ui.click("Name", {.clicks = 2, .at = {(place(8).x - ui.rect("Name").x) / ui.rect("Name").w, 0.5F}});
    ui.type("b").key(Key::home, Mods::shift);
    EXPECT_EQ(text, "alpha b gamma");
    ui.right_click("Name");
    EXPECT_TRUE(ui.exists("Name menu/Cut"));
    EXPECT_EQ(commits, 0) << "still under edit";
    ui.click("Name menu/Cut");
    EXPECT_FALSE(ui.exists("Name menu/Cut"));
    EXPECT_EQ(text, " gamma");
    EXPECT_EQ(ui.clipboard().text, "alpha b");
    EXPECT_EQ(ui.focused(), "Name");
    ui.right_click("Name");
    EXPECT_TRUE(ui.is("Name menu/Copy", Is::disabled));
    ui.click("Name menu/Paste");
    EXPECT_EQ(text, "alpha b gamma");
    ui.right_click("Name").click("Name menu/Select all");
    EXPECT_EQ(copied(), "alpha b gamma");
    ui.right_click("Name").key(Key::escape);
    EXPECT_EQ(ui.focused(), "Name");
    EXPECT_EQ(copied(), "alpha b gamma") << "a menu that was left has changed nothing";
    EXPECT_EQ(begins, 1);
    ui.key(Key::enter);
    EXPECT_EQ(commits, 1);
    options.read_only = true;
    ui.click("Other").right_click("Name");
    EXPECT_TRUE(ui.is("Name menu/Cut", Is::disabled));
    EXPECT_TRUE(ui.is("Name menu/Paste", Is::disabled));
    EXPECT_FALSE(ui.is("Name menu/Copy", Is::disabled));
}

TEST_F(TextFieldTest, CommandArrowsGoByWordsAndEraseThem) {
    click_at(0);
    ui.key(Key::right, Mods::command).type("1");
    EXPECT_EQ(text, "alpha1 beta gamma");
    ui.key(Key::end).key(Key::left, Mods::command | Mods::shift);
    EXPECT_EQ(copied(), "gamma");
    ui.key(Key::end).key(Key::backspace, Mods::command);
    EXPECT_EQ(text, "alpha1 beta ");
    ui.key(Key::home).key(Key::del);
    EXPECT_EQ(text, "lpha1 beta ");
    ui.key(Key::backspace);
    EXPECT_EQ(text, "lpha1 beta ");
}

TEST_F(TextFieldTest, CutCopyPasteGoThroughTheClipboard) {
    ui.focus("Name").key('X', Mods::command);
    EXPECT_EQ(text, "");
    EXPECT_EQ(ui.clipboard().text, "alpha beta gamma");
    ui.key('V', Mods::command).key('V', Mods::command);
    EXPECT_EQ(text, "alpha beta gammaalpha beta gamma");
    ui.clipboard().text = "two\nlines";
    ui.key('A', Mods::command).key('V', Mods::command);
    EXPECT_EQ(text, "two lines");
}

TEST_F(TextFieldTest, CopyingNothingLeavesTheClipboardAlone) {
    click_at(3);
    ui.clipboard().text = "kept";
    ui.key('C', Mods::command).key('X', Mods::command);
    EXPECT_EQ(ui.clipboard().text, "kept");
    EXPECT_EQ(text, "alpha beta gamma");
}

TEST_F(TextFieldTest, UndoAndRedoAreTheFieldsWhileItHasAny) {
    ui.focus("Name").type("new words");
    ui.key('Z', Mods::command);
    EXPECT_NE(text, "new words");
    ui.key('Z', Mods::command).key('Z', Mods::command);
    EXPECT_EQ(text, "alpha beta gamma");
    ui.key('Y', Mods::command).key('Z', Mods::command | Mods::shift);
    EXPECT_EQ(text, "new words");
}

TEST(TextField, UndoGoesOnToTheProgramWhenTheFieldHasNothingToUndo) {
    struct Program : Shortcuts {
        int undone = 0;
        bool press(Key key, Mods mods) override {
            const bool mine = key == key_of('Z') && mods == Mods::command;
            undone += mine ? 1 : 0;
            return mine;
        }
    } program;
    std::string text = "a";
    Harness ui([&](Ui& u) { text_field(u, "Name", text); }, {640, 480}, 1, &program);
    ui.focus("Name").type("b").key('Z', Mods::command);
    EXPECT_EQ(program.undone, 0);
    EXPECT_EQ(text, "a");
    ui.key('Z', Mods::command);
    EXPECT_EQ(program.undone, 1);
}

TEST_F(TextFieldTest, TextOfInputMethodsComesInBeyondTheFirstPlaneToo) {
    ui.focus("Name").type("\u00e9\u6f22\U0001F600");
    EXPECT_EQ(text, "\u00e9\u6f22\U0001F600");
    ui.key(Key::backspace);
    EXPECT_EQ(text, "\u00e9\u6f22");
    EXPECT_FALSE(ui.output().caret.empty()) << "input methods put their window there";
}

TEST_F(TextFieldTest, BytesThatAreNoTextAreKept) {
    text = "a\xff\xfe z";
    ui.frame();
    click_at(0);
    ui.type("b").key(Key::enter);
    EXPECT_EQ(text, "ba\xff\xfe z");
}

TEST_F(TextFieldTest, WhatTheFieldLeavesOutIsNotChangedByLookingAtIt) {
    text = "two\nlines";
    ui.frame();
    ui.focus("Name").key(Key::left).key(Key::end).key(Key::enter).key(Key::tab);
    EXPECT_EQ(text, "two\nlines");
    EXPECT_FALSE(all.changed);
}

TEST_F(TextFieldTest, AChangeByTheProgramIsShownAndEscapeDoesNotUndoIt) {
    ui.focus("Name").type("typed");
    text = "from the program";
    ui.frame();
    EXPECT_EQ(ui.text("Name"), "from the program");
    ui.key(Key::escape);
    EXPECT_EQ(text, "from the program");
}

TEST_F(TextFieldTest, TheCaretBlinksAndStopsAfterTenSeconds) {
    click_at(3);
    ui.frame(0.01);
    const double due = ui.output().wake_at;
    EXPECT_NEAR(due - ui.time, 0.53, 0.53);
    ui.frame(due - ui.time);
    EXPECT_TRUE(ui.output().changed);
    EXPECT_NEAR(ui.output().wake_at - ui.time, 0.53, 1e-6);
    ui.frame(0.53);
    EXPECT_TRUE(ui.output().changed);
    ui.frame(11);
    EXPECT_EQ(ui.output().wake_at, never);
}

TEST_F(TextFieldTest, TheCaretRestsWithReducedMotion) {
    ui.ui().set_reduced_motion(true);
    click_at(3);
    ui.frame(1);
    EXPECT_EQ(ui.output().wake_at, never);
}

TEST_F(TextFieldTest, ADisabledFieldTakesNothing) {
    Harness dead([&](Ui& u) {
        u.push_disabled(true);
        text_field(u, "Name", text, {.tip = "why"});
        u.pop_disabled();
    });
    dead.click("Name").type("x").key(Key::tab);
    EXPECT_EQ(text, "alpha beta gamma");
    EXPECT_TRUE(dead.is("Name", Is::disabled));
    EXPECT_EQ(dead.tip("Name"), "why");
    EXPECT_EQ(dead.text("Name"), "alpha beta gamma");
    EXPECT_EQ(dead.focused(), "");
}

TEST_F(TextFieldTest, AReadOnlyFieldCanBeCopiedButNotChanged) {
    options.read_only = true;
    ui.frame().focus("Name");
    EXPECT_EQ(copied(), "alpha beta gamma");
    ui.type("x").key(Key::del).key(Key::backspace).key('X', Mods::command).key('V', Mods::command);
    EXPECT_EQ(text, "alpha beta gamma");
    EXPECT_TRUE(ui.is("Name", Is::read_only));
}

TEST_F(TextFieldTest, TheLimitIsKept) {
    options.bytes = 4;
    text = "";
    ui.frame().focus("Name").type("abcdef");
    EXPECT_EQ(text, "abcd");
}

TEST_F(TextFieldTest, KeysOutsideAreLeftToTheCaller) {
    options.keys_outside = true;
    ui.frame().focus("Name").type("x").key(Key::escape).key(Key::enter);
    EXPECT_EQ(text, "x");
    EXPECT_EQ(ui.focused(), "Name");
    EXPECT_EQ(commits + cancels, 0);
}

TEST_F(TextFieldTest, AMegabyteIsPastedAndWalkedThroughInLinearTime) {
    std::string big;
    while (big.size() < (1 << 20) - 64) big += "words and \xe6\xbc\xa2 ";
    ui.clipboard().text = big;
    const std::size_t start = test::decoded_so_far();
    ui.focus("Name").key('V', Mods::command);
    EXPECT_EQ(text, big);
    for (const Key key : {Key::home, Key::right, Key::end, Key::left}) ui.key(key);
    for (int i = 0; i < 20; ++i) ui.key(Key::left, Mods::command);
    ui.type("!");
    const std::size_t decoded = test::decoded_so_far() - start;
    EXPECT_EQ(text.size(), big.size() + 1);
    EXPECT_LT(decoded, 4 * big.size());
    EXPECT_LE(ui.text("Name").size(), 65536U);
}

TEST_F(TextFieldTest, WalkingThroughALongTextKeepsTheCaretInSight) {
    text.clear();
    for (int i = 0; i < 3000; ++i) text += std::to_string(i) + " ";
    ui.frame().focus("Name").key(Key::home);
    const Rect rect = ui.rect("Name");
    for (int i = 0; i < 1200; ++i) {
        ui.key(Key::right, Mods::command);
        const Rect caret = ui.output().caret;
        ASSERT_GE(caret.x, rect.x) << i;
        ASSERT_LE(caret.x, rect.right()) << i;
    }
    ui.type("|");
    EXPECT_NE(text.find("1199|"), std::string::npos);
}

TEST_F(TextFieldTest, SteadyFramesAndDragsAllocateNothing) {
    click_at(3);
    press_at(2);
    for (int i = 0; i < 200; ++i) ui.frame(0);
    const std::size_t before = test::allocations_so_far();
    for (int i = 0; i < 100; ++i) ui.frame(0.02);
    EXPECT_EQ(test::allocations_so_far(), before);
}

TEST_F(TextFieldTest, ASearchFieldIsEmptiedByEscapeThenLeft) {
    search = true;
    ui.frame().focus("Name").type("word").key(Key::escape);
    EXPECT_EQ(text, "");
    EXPECT_EQ(ui.focused(), "Name");
    EXPECT_EQ(commits, 1);
    ui.key(Key::escape);
    EXPECT_EQ(ui.focused(), "");
}

TEST_F(TextFieldTest, TheCrossEmptiesASearchFieldAndGivesItTheKeyboard) {
    search = true;
    ui.frame();
    EXPECT_EQ(ui.tip("Name/Clear"), "Clear (Esc)");
    ui.click("Name/Clear");
    EXPECT_EQ(text, "");
    EXPECT_EQ(commits, 1);
    EXPECT_EQ(ui.focused(), "Name");
    EXPECT_FALSE(ui.exists("Name/Clear"));
    EXPECT_EQ(ui.node("Name").role, Role::search_field);
}

TEST(TextField, SelectedTextCanBeRead) {
    for (const Theme* theme : {&dark_theme(), &light_theme()}) {
        EXPECT_GE(contrast(theme->text, selection_color(*theme)), 4.5);
        EXPECT_GE(contrast(theme->field, selection_color(*theme)), 1.4) << "and seen to be selected";
    }
}

TEST_F(TextFieldTest, ThePointerOverTheFieldIsForText) {
    ui.move_to("Name");
    EXPECT_EQ(ui.output().cursor, Cursor::text);
    ui.move({600, 400});
    EXPECT_EQ(ui.output().cursor, Cursor::arrow);
}

}  // namespace
}  // namespace lapfx::ui
