#include <algorithm>

#include "ui/support/texts.h"
#include "ui/widgets/param_fixture.h"

namespace lapfx::ui {
namespace {

TEST_F(Param, APressChangesNothing) {
    ui.click("Speed").click("Speed", {.at = {0.99F, 0.5F}});
    EXPECT_EQ(speed, 100);
    EXPECT_EQ(edits.began + edits.changed, 0);
    EXPECT_EQ(ui.focused(), "Speed");
}

TEST_F(Param, ADragIsRelativeAndBeginsAfterThreePixels) {
    ui.press("Speed").drag_by({2, 0});
    EXPECT_EQ(speed, 100);
    EXPECT_FALSE(ui.output().pointer_locked) << "a click leaves the pointer alone";
    ui.drag_by({1, 0});
    EXPECT_EQ(speed, 100) << "it sets off from where it is";
    ui.drag_by({10, 0});
    EXPECT_EQ(speed, 110);
    ui.drag_by({-30, 0}).release();
    EXPECT_EQ(speed, 80);
}

TEST_F(Param, TheThreePixelsGrowWithTheScale) {
    ui.scale = 2;
    ui.frame().press("Speed").drag_by({5, 0});
    EXPECT_FALSE(ui.output().pointer_locked);
    ui.drag_by({1, 0});
    EXPECT_TRUE(ui.output().pointer_locked);
}

TEST_F(Param, ShiftGoesATenthAsFastAndChangingItDoesNotJump) {
    ui.press("Speed").drag_by({13, 0});
    EXPECT_EQ(speed, 110);
    ui.drag_by({20, 0}, Mods::shift);
    EXPECT_EQ(speed, 112);
    ui.drag_by({10, 0});
    EXPECT_EQ(speed, 122);
}

TEST_F(Param, CtrlTakesStepsAndWithShiftTenthsOfThem) {
    ui.drag("Speed", {14, 0}, Mods::command);
    EXPECT_EQ(speed, 110);
    speed = 100;
    ui.drag("Speed", {3 + 14, 0}, Mods::command | Mods::shift);
    EXPECT_EQ(speed, 101.5);
}

TEST_F(Param, ADragAimsAtRoundNumbers) {
    speed = 12.3456;
    ui.press("Speed").drag_by({4, 0});
    EXPECT_EQ(speed, 13) << "within 12.85..13.85";
}

TEST_F(Param, ThePointerIsHiddenAndGoesBeyondTheWindow) {
    ui.press("Speed").drag_by({100, 0});
    EXPECT_TRUE(ui.output().pointer_locked);
    EXPECT_EQ(ui.output().cursor, Cursor::resize_x);
    options.maximum = 3520;  // each px is ten times as much from here on
    ui.drag_by({200, 0});
    EXPECT_EQ(speed, 1000) << "the hard maximum, 2197 without";
    options.hard_maximum = 1e6;
    ui.drag_by({1000, 0});
    EXPECT_EQ(speed, 3520) << "far outside of the window";
    ui.release();
    EXPECT_FALSE(ui.output().pointer_locked);
}

TEST_F(Param, ADragIsOneEdit) {
    ui.drag("Speed", {40, 0});
    EXPECT_EQ(edits.began, 1);
    EXPECT_EQ(edits.changed, 4);
    EXPECT_EQ(edits.committed, 1);
    EXPECT_EQ(edits.cancelled, 0);
    ui.press("Speed").drag_by({2, 0}).release();
    EXPECT_EQ(edits.began, 1) << "less than three px: nothing";
    EXPECT_EQ(edits.committed, 1);
}

TEST_F(Param, EscapePutsTheValueBack) {
    ui.press("Speed").drag_by({40, 0}).key(Key::escape);
    EXPECT_EQ(speed, 100);
    EXPECT_EQ(edits.cancelled, 1);
    EXPECT_EQ(edits.committed, 0);
    EXPECT_FALSE(ui.output().pointer_locked);
    ui.drag_by({20, 0}).release();
    EXPECT_EQ(speed, 100);
}

TEST_F(Param, TheRightButtonPutsTheValueBackAndOpensNoMenu) {
    ui.press("Speed").drag_by({40, 0});
    ui.send({.kind = EventKind::press, .button = Button::right, .at = field_center()});
    EXPECT_EQ(speed, 100);
    EXPECT_EQ(edits.cancelled, 1);
    EXPECT_EQ(ui.ui().overlay_count(), 0U);
}

TEST_F(Param, ADragThatIsDisabledInTheMiddleIsCommitted) {
    ui.press("Speed").drag_by({13, 0});
    disabled = true;
    ui.frame();
    EXPECT_EQ(edits.committed, 1);
    disabled = false;
    ui.drag_by({13, 0});
    EXPECT_EQ(speed, 110);
}

TEST_F(Param, ADoubleClickOpensTheFieldForTyping) {
    ui.click("Speed", {.clicks = 2, .at = {0.7F, 0.5F}});
    EXPECT_EQ(ui.text("Speed"), "100");
    ui.type("12/2").key(Key::enter);
    EXPECT_EQ(speed, 6);
    EXPECT_EQ(ui.text("Speed"), "6 mm/s");
    EXPECT_EQ(edits.began, 1);
    EXPECT_EQ(edits.committed, 1);
}

TEST_F(Param, TwoQuickDragsAreNoDoubleClick) {
    ui.press("Speed").drag_by({13, 0});
    ui.send({.kind = EventKind::release, .at = ui.rect("Speed").center() + glm::vec2(13, 0)});
    ui.move(ui.rect("Speed").center());  // the pointer returns to this place
    ui.send({.kind = EventKind::press, .at = ui.rect("Speed").center()});
    ui.send({.kind = EventKind::release, .at = ui.rect("Speed").center()});
    EXPECT_EQ(ui.text("Speed"), "110 mm/s");
}

TEST_F(Param, EnterOpensItAndEscapeKeepsTheValue) {
    ui.focus("Speed").key(Key::enter).type("7");
    EXPECT_EQ(ui.text("Speed"), "7") << "what was there was selected";
    ui.key(Key::escape);
    EXPECT_EQ(speed, 100);
    EXPECT_EQ(ui.text("Speed"), "100 mm/s");
    EXPECT_EQ(ui.focused(), "Speed");
    EXPECT_EQ(edits.changed, 0);
}

TEST_F(Param, ADigitOpensItAndOtherLettersAreShortcuts) {
    ui.focus("Speed");
    chords.keys.clear();
    ui.key('J');
    EXPECT_THAT(chords.keys, testing::ElementsAre(key_of('J')));
    chords.keys.clear();
    ui.type("4").key('J').type("5");
    EXPECT_THAT(chords.keys, testing::IsEmpty()) << "not while a text is open";
    ui.key(Key::enter);
    EXPECT_EQ(speed, 45);
}

TEST_F(Param, FastTypingInOneFrameIsAllTaken) {
    ui.focus("Speed");
    chords.keys.clear();
    for (const char c : std::string("2e2")) {
        ui.ui().push({.kind = EventKind::key, .key = key_of(c)});
        ui.ui().push({.kind = EventKind::text, .codepoint = static_cast<char32_t>(c)});
        ui.ui().push({.kind = EventKind::key_up, .key = key_of(c)});
    }
    ui.ui().push({.kind = EventKind::key, .key = Key::enter});
    ui.frame();
    EXPECT_EQ(speed, 200);
    EXPECT_THAT(chords.keys, testing::IsEmpty());
}

TEST_F(Param, UnitsAndSharesAreTyped) {
    ui.focus("Speed").type("2cm/s").key(Key::enter);
    EXPECT_EQ(speed, 20);
    ui.key(Key::enter).type("50%").key(Key::enter);
    EXPECT_EQ(speed, 176);
    ui.key(Key::enter).type("+=4").key(Key::enter);
    EXPECT_EQ(speed, 180);
}

TEST_F(Param, TypingReachesBeyondTheSoftRangeButNotTheHardOne) {
    ui.focus("Speed").type("500").key(Key::enter);
    EXPECT_EQ(speed, 500);
    ui.type("5000").key(Key::enter);
    EXPECT_EQ(speed, 1000);
}

TEST_F(Param, WhatCannotBeReadIsMarkedInPlaceWithItsReason) {
    ui.focus("Speed").type("12/");
    EXPECT_TRUE(ui.is("Speed", Is::invalid));
    EXPECT_NE(ui.tip("Speed"), "");
    EXPECT_NE(ui.tip("Speed"), "How fast blood flows");
    ui.key(Key::enter);
    EXPECT_EQ(ui.text("Speed"), "12/") << "it stays open";
    EXPECT_EQ(speed, 100);
    ui.type("3");
    EXPECT_FALSE(ui.is("Speed", Is::invalid));
    EXPECT_EQ(ui.tip("Speed"), "How fast blood flows");
    ui.key(Key::enter);
    EXPECT_EQ(speed, 4);
    ui.type("3 ms");
    EXPECT_THAT(ui.tip("Speed"), testing::HasSubstr("ms"));
    ui.click("Else");
    EXPECT_EQ(speed, 4) << "and is given up when it is left";
    EXPECT_EQ(ui.text("Speed"), "4 mm/s");
}

TEST_F(Param, WhatIsRefusedOrLimitedIsSaidAtOnceAndAfterwards) {
    ui.focus("Speed").type("abc");
    EXPECT_THAT(said(), testing::HasSubstr("abc")) << "while it is typed, wherever the pointer is";
    ui.click("Else");
    EXPECT_THAT(said(), testing::StartsWith("\"abc\" was not taken: ")) << "and once it has been left";
    EXPECT_EQ(speed, 100);
    ui.focus("Speed").key(Key::enter);
    EXPECT_EQ(said(), "") << "a new entry begins";
    ui.type("1e9");
    EXPECT_EQ(said(), "allowed are -1000 to 1000 mm/s: 1000 mm/s is taken");
    ui.key(Key::enter);
    EXPECT_EQ(speed, 1000);
    EXPECT_EQ(said(), "allowed are -1000 to 1000 mm/s: 1000 mm/s is taken");
    ui.frame(7);
    EXPECT_EQ(said(), "");
    options.hard_maximum = std::numeric_limits<double>::infinity();
    options.hard_minimum = 0;
    ui.key(Key::enter).type("-5").key(Key::enter);
    EXPECT_EQ(said(), "allowed are 0 mm/s and more: 0 mm/s is taken");
    ui.key(Key::enter).type("0.5 kg");
    EXPECT_THAT(said(), testing::AllOf(testing::HasSubstr("kg"), testing::HasSubstr("allowed are mm/s")));
    ui.key(Key::escape).key(Key::enter).type("1 000");
    EXPECT_THAT(said(), testing::HasSubstr("operator"));
    ui.key(Key::escape);
    EXPECT_EQ(said(), "") << "given up by the person";
    ui.key(Key::enter).key('A', Mods::command).key(Key::backspace);
    ui.click("Else");
    EXPECT_THAT(said(), testing::StartsWith("Nothing was not taken: ")) << "an empty entry";
}

TEST_F(Param, APasteThatIsNoNumberIsSaid) {
    ui.clipboard().text = "words";
    ui.focus("Speed").key('V', Mods::command);
    EXPECT_EQ(said(), "The clipboard has no number that can stand here");
    EXPECT_EQ(speed, 100);
}

TEST_F(Param, WhatIsNoNumberIsRefused) {
    for (const char* typed : {"0/0", "1/0", "nan", "1e999", "sqrt(-1)"}) {
        ui.focus("Speed").key(Key::enter).type(typed);
        EXPECT_TRUE(ui.is("Speed", Is::invalid)) << typed;
        ui.key(Key::enter).key(Key::escape);
        EXPECT_EQ(speed, 100) << typed;
    }
    ui.clipboard().text = "nan";
    ui.key('V', Mods::command);
    EXPECT_EQ(speed, 100);
}

TEST_F(Param, AValueThatIsNoNumberIsShownAndCanBeMended) {
    speed = std::nan("");
    ui.frame();
    EXPECT_EQ(ui.text("Speed"), "not a number mm/s");
    ui.focus("Speed").key(Key::right).wheel("Speed", {0, 1}, Mods::command);
    EXPECT_EQ(edits.changed, 0) << "no number has no next one";
    ui.drag("Speed", {13, 0});
    EXPECT_EQ(speed, 110) << "from the standard";
}

TEST_F(Param, NothingTypedIsNoEdit) {
    speed = 1.0 / 3;
    ui.focus("Speed").key(Key::enter).key(Key::enter);
    EXPECT_EQ(speed, 1.0 / 3);
    speed = 5000;  // set by the program, beyond the hard range
    ui.key(Key::enter).key(Key::enter);
    EXPECT_EQ(speed, 5000);
    EXPECT_EQ(edits.began, 0);
}

TEST_F(Param, TabTakesWhatIsTypedAndOpensTheNext) {
    ui.focus("Speed").type("7").key(Key::tab);
    EXPECT_EQ(speed, 7);
    EXPECT_EQ(ui.focused(), "Size");
    EXPECT_EQ(ui.text("Size"), "20");
    ui.type("8").key(Key::tab, Mods::shift);
    EXPECT_EQ(size, 8);
    EXPECT_EQ(ui.text("Speed"), "7") << "backwards, too";
    ui.key(Key::escape).key(Key::tab);
    EXPECT_EQ(ui.text("Size"), "8") << "with its step of one, and no text open: that is for the keys below";
    ui.key(Key::right);
    EXPECT_EQ(size, 9);
}

TEST_F(Param, LeavingTheFieldTakesWhatIsTyped) {
    ui.focus("Speed").type("7").click("Else");
    EXPECT_EQ(speed, 7);
    EXPECT_EQ(edits.committed, 1);
}

TEST(ParamLabel, OfAGroupAndANameTheNameStays) {
    double value = 15;
    for (const auto& [width, glyphs] : {std::pair(300, 11), std::pair(800, 20)}) {
        Harness ui([&](Ui& u) { param(u, "Bleeding: Level extent", value, {.minimum = 0, .maximum = 60}); },
                   {width, 100});
        ui.frame();
        const std::vector<TextSeen> texts = texts_seen(*ui.output().list, Harness::fonts(), ui.ui().em(1));
        for (const TextSeen& text : texts) EXPECT_FALSE(text.elided);
        const auto longest = std::ranges::max_element(texts, {}, [](const TextSeen& t) { return t.glyphs.size(); });
        ASSERT_NE(longest, texts.end());
        EXPECT_NEAR(static_cast<double>(longest->glyphs.size()), glyphs, 2) << width;
    }
}

// As in a slow frame: the window hands over the last character and the click elsewhere together.
TEST_F(Param, ACharacterAndAClickElsewhereInOneFrameLoseNothing) {
    ui.focus("Speed").type("12.2");
    const glm::vec2 elsewhere = ui.rect("Else").center();
    ui.ui().push({.kind = EventKind::text, .codepoint = U'5'});
    ui.ui().push({.kind = EventKind::pointer, .at = elsewhere});
    ui.ui().push({.kind = EventKind::press, .at = elsewhere});
    ui.frame();
    EXPECT_EQ(speed, 12.25);
    EXPECT_EQ(edits.committed, 1);
}

TEST_F(Param, TextIsEditedWithSelectionClipboardAndUndo) {
    ui.focus("Speed").key(Key::enter).key('C', Mods::command);
    EXPECT_EQ(ui.clipboard().text, "100");
    ui.key(Key::end).key(Key::left, Mods::shift).key('X', Mods::command);
    EXPECT_EQ(ui.text("Speed"), "10");
    EXPECT_EQ(ui.clipboard().text, "0");
    ui.key('V', Mods::command).key('V', Mods::command);
    EXPECT_EQ(ui.text("Speed"), "1000");
    ui.key('Z', Mods::command);
    EXPECT_EQ(ui.text("Speed"), "10");
    ui.key('Y', Mods::command);
    EXPECT_EQ(ui.text("Speed"), "1000");
    ui.key(Key::home).key(Key::del).key(Key::end).key(Key::backspace);
    EXPECT_EQ(ui.text("Speed"), "00");
    const Rect row = ui.rect("Speed");
    ui.type("1 2").click("Speed", {.clicks = 2, .at = {(row.w * 0.45F + 10) / row.w, 0.5F}}).type("9");
    EXPECT_EQ(ui.text("Speed"), "9 2") << "a double click takes a word";
}

TEST_F(Param, TheCaretIsPlacedAndDraggedByThePointer) {
    ui.focus("Speed").key(Key::enter).type("123456");
    const Rect row = ui.rect("Speed");
    ui.press("Speed", {0.46F, 0.5F}).drag_by({400, 0}).release();
    ui.type("7");
    EXPECT_EQ(ui.text("Speed"), "7") << "all of it was selected";
    EXPECT_EQ(speed, 100) << "nothing is dragged while a text is open";
    EXPECT_EQ(ui.move(field_center()).output().cursor, Cursor::text);
    EXPECT_GT(ui.output().caret.x, row.w * 0.45F);
}

TEST_F(Param, ALongTextIsScrolledToItsCaret) {
    ui.focus("Speed").key(Key::enter).type("1");
    for (int i = 0; i < 100; ++i) ui.type("+1");
    EXPECT_LT(ui.output().caret.x, ui.rect("Speed").right());
    EXPECT_GT(ui.output().caret.x, ui.rect("Speed").right() - 30);
    ui.key(Key::home);
    EXPECT_LT(ui.output().caret.x, ui.rect("Speed").right() - 300);
    ui.key(Key::enter);
    EXPECT_EQ(speed, 101);
}

TEST_F(Param, BackspaceGoesToTheStandard) {
    speed = 7;
    ui.focus("Speed").key(Key::backspace);
    EXPECT_EQ(speed, 100);
    EXPECT_EQ(edits.committed, 1);
    ui.key(Key::backspace);
    EXPECT_EQ(edits.committed, 1) << "it is there already";
}

TEST_F(Param, BackspaceMeansWhatIsUnderThePointerUnlessARingIsShown) {
    speed = 7;
    ui.click("Size").move_to("Speed").key(Key::backspace);
    EXPECT_EQ(speed, 100);
    EXPECT_EQ(size, 20);
    speed = 7;
    ui.key(Key::tab).focus("Size").key(Key::backspace);
    EXPECT_EQ(speed, 7);
    EXPECT_EQ(size, 10);
}

TEST_F(Param, ADoubleClickOnTheLabelGoesToTheStandard) {
    speed = 7;
    ui.click("Speed", {.clicks = 2, .at = {0.1F, 0.5F}});
    EXPECT_EQ(speed, 100);
    EXPECT_EQ(edits.committed, 1);
}

TEST_F(Param, TheLabelIsNotDragged) {
    ui.press("Speed", {0.1F, 0.5F}).drag_by({50, 0}).release();
    EXPECT_EQ(speed, 100);
    EXPECT_NE(ui.output().cursor, Cursor::resize_x);
    ui.move(field_center());
    EXPECT_EQ(ui.output().cursor, Cursor::resize_x);
}

TEST_F(Param, AValueOffItsStandardIsMarked) {
    EXPECT_FALSE(ui.is("Speed", Is::changed));
    options.standard = 99;  // the same number, now with a dot
    EXPECT_TRUE(ui.frame().is("Speed", Is::changed));
    EXPECT_TRUE(ui.output().changed);
    options.standard.reset();
    EXPECT_FALSE(ui.frame().is("Speed", Is::changed));
}

}  // namespace
}  // namespace lapfx::ui
