#include "ui/value/text_edit.h"

#include <gtest/gtest.h>

#include <random>

#include "ui/support/count_decoded.h"
#include "ui/value/text_edit_oracle.h"
#include "ui/value/utf8.h"

namespace lapfx::ui {
namespace {

using enum TextCommand;

void type(TextEdit& edit, std::string_view text) {
    for (const char c : text) edit.insert(static_cast<char32_t>(c));
}

/// The text with "|" for the caret and "^" for the other end of the selection.
std::string shown(const TextEdit& edit) {
    std::string out = edit.text();
    const bool selects = edit.caret() != edit.anchor();
    if (selects && edit.anchor() > edit.caret()) out.insert(edit.anchor(), "^");
    out.insert(edit.caret(), "|");
    if (selects && edit.anchor() < edit.caret()) out.insert(edit.anchor(), "^");
    return out;
}

std::string after(TextEdit edit, std::initializer_list<TextCommand> commands) {
    for (const TextCommand command : commands) edit.apply(command);
    return shown(edit);
}

TEST(TextEdit, TypingReplacesTheSelection) {
    TextEdit edit("speed");
    EXPECT_EQ(shown(edit), "speed|");
    EXPECT_TRUE(edit.apply(select_all));
    EXPECT_EQ(edit.selected(), "speed");
    EXPECT_TRUE(edit.insert("4.5"));
    EXPECT_EQ(shown(edit), "4.5|");
    EXPECT_FALSE(edit.insert("")) << "nothing in place of nothing";
}

TEST(TextEdit, ArrowsLeaveASelectionAtItsEnds) {
    TextEdit edit("abcd");
    EXPECT_EQ(after(edit, {left, select_left, select_left, left}), "a|bcd");
    EXPECT_EQ(after(edit, {left, select_left, select_left, right}), "abc|d");
    EXPECT_EQ(after(edit, {left, select_left, select_left}), "a|bc^d");
    EXPECT_EQ(after(edit, {left, select_left, select_none}), "ab|cd");
    EXPECT_FALSE(edit.apply(right)) << "nothing changed";
    EXPECT_TRUE(edit.apply(left));
}

TEST(TextEdit, WordsArePartedBySpacesAndPunctuation) {
    const TextEdit edit("one  two.three = 4");
    EXPECT_EQ(after(edit, {word_left}), "one  two.three = |4");
    EXPECT_EQ(after(edit, {word_left, word_left}), "one  two.three |= 4");
    EXPECT_EQ(after(edit, {word_left, word_left, word_left}), "one  two.|three = 4");
    EXPECT_EQ(after(edit, {word_left, word_left, word_left, word_left}), "one  two|.three = 4");
    EXPECT_EQ(after(edit, {text_start, word_right}), "one|  two.three = 4");
    EXPECT_EQ(after(edit, {text_start, word_right, word_right}), "one  two|.three = 4");
    EXPECT_EQ(after(edit, {text_start, word_right, select_word_right}), "one^  two|.three = 4");
    EXPECT_EQ(after(edit, {text_start, word_right, erase_word_right}), "one|.three = 4");
    EXPECT_EQ(after(edit, {erase_word_left, erase_word_left}), "one  two.three |");
    EXPECT_EQ(after(TextEdit("gr\xC3\xBC\xC3\x9F"
                             "e, na"),
                    {text_start, word_right}),
              "gr\xC3\xBC\xC3\x9F"
              "e|, na");
}

TEST(TextEdit, SelectsTheWordAtTheCaret) {
    TextEdit edit("one two.");
    const auto selected_at = [&](std::size_t byte) {
        edit.place(byte, false);
        edit.apply(select_word);
        return std::string(edit.selected());
    };
    EXPECT_EQ(selected_at(1), "one");
    EXPECT_EQ(selected_at(3), "one") << "a word before a space";
    EXPECT_EQ(selected_at(4), "two");
    EXPECT_EQ(selected_at(7), "two");
    EXPECT_EQ(selected_at(8), ".");
    EXPECT_EQ(after(TextEdit("a  b"), {left, left, select_word}), "a^  |b");
}

TEST(TextEdit, LineBreaksAndControlCharactersThatComeIn) {
    EXPECT_EQ(TextEdit("a\r\nb\rc\nd").text(), "a b c d");
    EXPECT_EQ(TextEdit("d\xE2\x80\xA8"
                       "e")
                  .text(),
              "d e");
    TextEdit edit;
    EXPECT_TRUE(edit.insert(std::string_view("a\0b\x1B\x7F\xC2\x85\tc", 9)));
    EXPECT_EQ(edit.text(), "ab\tc");
    EXPECT_FALSE(edit.insert(U'\b'));
    edit.apply(select_all);
    EXPECT_FALSE(edit.insert(U'\x1B')) << "and the selection stays";
    EXPECT_EQ(edit.text(), "ab\tc");
    edit.insert(char32_t{0xD800});
    EXPECT_EQ(edit.text(), "\xEF\xBF\xBD");
}

TEST(TextEdit, WhatGoesBeyondTheLimitIsCutAtACharacter) {
    TextEdit edit("abc", 6);
    EXPECT_TRUE(edit.insert("x\xC3\xA9\xC3\xA9"));
    EXPECT_EQ(edit.text(), "abcx\xC3\xA9");
    EXPECT_FALSE(edit.insert("y"));
    edit.apply(select_left);
    EXPECT_TRUE(edit.insert("yz!")) << "the selection makes room";
    EXPECT_EQ(edit.text(), "abcxyz");
    EXPECT_EQ(TextEdit("ae\xCC\x81", 3).text(), "a") << "not a letter without its mark";
    EXPECT_EQ(TextEdit("\xF0\x9F\x98\x80", 3).text(), "");
    edit.replace("1234567");
    EXPECT_EQ(edit.text(), "123456");
}

TEST(TextEdit, BytesThatAreNoUtf8AreKept) {
    const std::string bytes = "a\xFF\xC3(\xE2\x82z";
    TextEdit edit(bytes);
    EXPECT_EQ(edit.text(), bytes);
    for (std::size_t expected = bytes.size(); expected > 0; --expected) {
        EXPECT_EQ(edit.caret(), expected) << "each is a character";
        edit.apply(left);
    }
}

TEST(TextEdit, PlacesAreTheNearestThatAreAllowed) {
    TextEdit edit(
        "a\xF0\x9F\x98\x80"
        "e\xCC\x81");  // places 0, 1, 5, 8
    const std::size_t expected[] = {0, 1, 1, 1, 5, 5, 5, 8, 8};
    for (std::size_t byte = 0; byte < 9; ++byte) {
        edit.place(byte, false);
        EXPECT_EQ(edit.caret(), expected[byte]) << byte;
    }
    edit.place(1, false);
    edit.place(1000, true);
    EXPECT_EQ(edit.anchor(), 1u);
    EXPECT_EQ(edit.caret(), 8u);
}

TEST(TextEdit, ACaretBetweenWhatBecomesOneCharacterGoesBehindIt) {
    TextEdit mark("x \xCC\x81");
    mark.replace("\xCC\x81");
    mark.apply(text_start);
    mark.insert("e");
    EXPECT_EQ(mark.caret(), 3u);
    TextEdit halves("\xC3x\xA9");
    halves.place(1, false);
    halves.apply(erase_right);
    EXPECT_EQ(halves.text(), "\xC3\xA9");
    EXPECT_EQ(halves.caret(), 2u);
    halves.apply(undo);
    EXPECT_EQ(halves.caret(), 1u);
    halves.apply(redo);
    EXPECT_EQ(halves.caret(), 2u);
}

TEST(TextEdit, UndoTakesTypingWordByWord) {
    TextEdit edit;
    type(edit, "one two");
    EXPECT_TRUE(edit.apply(undo));
    EXPECT_EQ(edit.text(), "one ");
    EXPECT_TRUE(edit.apply(undo));
    EXPECT_EQ(edit.text(), "");
    EXPECT_FALSE(edit.apply(undo));
    EXPECT_TRUE(edit.apply(redo));
    EXPECT_TRUE(edit.apply(redo));
    EXPECT_EQ(shown(edit), "one two|");
    EXPECT_FALSE(edit.can_redo());
}

TEST(TextEdit, AMotionAPasteOrACommandEndsAStepOfTyping) {
    TextEdit edit;
    type(edit, "ab");
    edit.apply(left);
    edit.apply(right);
    type(edit, "cd");
    edit.insert("pasted");
    type(edit, "ef");
    edit.apply(erase_left);
    type(edit, "g");
    const char* states[] = {"abcdpastede", "abcdpastedef", "abcdpasted", "abcd", "ab", ""};
    for (const char* state : states) {
        edit.apply(undo);
        EXPECT_EQ(edit.text(), state);
    }
    EXPECT_FALSE(edit.can_undo());
    type(edit, "n");
    EXPECT_FALSE(edit.can_redo()) << "what is new takes the place of what was undone";
    edit.place(1, false);
    type(edit, "o");
    edit.apply(undo);
    EXPECT_EQ(edit.text(), "n") << "a click, even to the same place";
}

TEST(TextEdit, UndoBringsTheSelectionBack) {
    TextEdit edit("one two");
    edit.apply(select_word_left);
    type(edit, "xy");
    edit.apply(undo);
    EXPECT_EQ(shown(edit), "one |two^");
    edit.apply(redo);
    EXPECT_EQ(shown(edit), "one xy|");
}

TEST(TextEdit, ReplaceIsOneStepAndResetForgets) {
    TextEdit edit("old");
    edit.replace("new text");
    EXPECT_EQ(shown(edit), "new text|");
    edit.apply(text_start);
    edit.replace("new text");
    EXPECT_EQ(shown(edit), "new text|");
    edit.apply(undo);
    EXPECT_EQ(edit.text(), "old");
    EXPECT_FALSE(edit.can_undo()) << "the same text again was no step";
    edit.reset("fresh");
    EXPECT_EQ(shown(edit), "fresh|");
    EXPECT_FALSE(edit.can_undo());
    EXPECT_FALSE(edit.can_redo());
}

TEST(TextEdit, TheHistoryIsBounded) {
    TextEdit edit;
    for (int i = 0; i < 1500; ++i) edit.insert("ab");
    int steps = 0;
    while (edit.apply(undo)) ++steps;
    EXPECT_EQ(steps, 1000);
    EXPECT_EQ(edit.text().size(), 1000u);

    const std::string large(1 << 20, 'x');
    edit.reset("");
    for (int i = 0; i < 10; ++i) edit.replace(large), edit.replace("");
    for (steps = 0; edit.apply(undo); ++steps) {
    }
    EXPECT_EQ(steps, 4) << "4 MB";
    TextEdit huge("", 16 << 20);
    huge.insert(std::string(8 << 20, 'x'));
    EXPECT_TRUE(huge.apply(undo)) << "the newest step always";
}

TEST(TextEdit, AMegabyteIsPastedInLinearTime) {
    const auto decoded_for = [](const std::string& piece) {
        std::string text;
        while (text.size() < (1 << 20)) text += piece;
        const std::size_t start = test::decoded_so_far();
        TextEdit edit;
        edit.insert(text);
        for (const TextCommand command : {word_left, select_all, left, word_right, undo, redo}) edit.apply(command);
        return test::decoded_so_far() - start;
    };
    for (const char* piece : {"x", "word \r\n", "\xCC\x81", "\xFF", "\xE2\x80\x8D\xF0\x9F\x91\xA9", "\n"}) {
        EXPECT_LT(decoded_for(piece), 16U << 20) << testing::PrintToString(piece);
    }
}

TEST(TextEdit, AgreesWithItsOracleOnAHundredThousandOperations) {
    const std::u32string alphabet = U"aaabZ0_     \t\n\n.-+(é€«\u00A0\u0301\u0301\uFE0F\u200D👩👩\r\x07";
    std::mt19937 random(7);
    TextEdit edit("", 120);
    TextEditOracle oracle(120);
    for (int i = 0; i < 100000; ++i) {
        const auto pick = random() % 8;
        if (pick < 3) {
            std::u32string in;
            for (auto count = pick == 0 ? random() % 6 : 1; count > 0; --count)
                in += alphabet[random() % alphabet.size()];
            std::string bytes;
            for (const char32_t c : in) append(bytes, c);
            edit.insert(bytes);
            oracle.insert(in);
        } else {
            const auto command = static_cast<TextCommand>(random() % (static_cast<unsigned>(redo) + 1));
            if (command >= erase_left && command < undo && random() % 2 == 0) continue;
            edit.apply(command);
            oracle.apply(command);
        }
        ASSERT_EQ(edit.text(), oracle.text()) << i;
        ASSERT_EQ(edit.caret(), oracle.caret()) << i << testing::PrintToString(edit.text());
        ASSERT_EQ(edit.anchor(), oracle.anchor()) << i << testing::PrintToString(edit.text());
        ASSERT_EQ(edit.can_undo(), oracle.can_undo()) << i;
        ASSERT_EQ(edit.can_redo(), oracle.can_redo()) << i;
    }
}

TEST(TextEdit, UndoGoesBackToTheStartAndRedoToTheEnd) {
    std::mt19937 random(8);
    for (int round = 0; round < 200; ++round) {
        TextEdit edit("begin \xC3\xA9 here");
        const std::string start = edit.text();
        for (int i = 0; i < 500; ++i) {
            const auto command = static_cast<TextCommand>(random() % static_cast<unsigned>(undo));
            if (random() % 2 == 0) edit.insert(std::string(1 + random() % 2, static_cast<char>(random() % 256)));
            if (random() % 2 == 0) edit.apply(command);
        }
        const std::string end = edit.text();
        while (edit.can_undo()) ASSERT_TRUE(edit.apply(undo));
        ASSERT_EQ(edit.text(), start);
        while (edit.can_redo()) ASSERT_TRUE(edit.apply(redo));
        ASSERT_EQ(edit.text(), end);
    }
}

// The place where a flag begins depends on all flags before it in the row. A step back counts them, so moving by a word
// must not make one step for each flag.
TEST(TextEdit, ARowOfFlagsIsOneWordHoweverLong) {
    std::string flags;
    while (flags.size() < (1U << 20)) flags += "\xF0\x9F\x87\xA9\xF0\x9F\x87\xAA";
    TextEdit edit("a " + flags.substr(0, (1U << 20) - 8));
    edit.apply(word_left);
    EXPECT_EQ(edit.caret(), 2u);
    edit.apply(word_right);
    EXPECT_EQ(edit.caret(), edit.text().size());
    edit.apply(select_word);
    EXPECT_EQ(edit.selection_begin(), 2u);
    edit.apply(left);
    edit.apply(text_end);
    edit.apply(erase_left);
    EXPECT_EQ(edit.text().size(), (1U << 20) - 14);
}

TEST(TextEdit, AnyBytesAndCommandsLeaveTheCaretOnAnAllowedPlace) {
    std::mt19937 random(9);
    TextEdit edit("", 300);
    const auto allowed = [&](std::size_t byte) {
        std::size_t at = 0;
        while (at < byte) at += next_character(edit.text(), at);
        return at == byte;
    };
    const std::string pieces[] = {"\x80",     "\xC3",         "\xA9", "\xE2", "\xF0\x9F", "\xCC\x81",
                                  "\x91\xA9", "\xE2\x80\x8D", "a",    "\n",   "\xFF",     "\xF0\x9F\x87\xA9"};
    for (int i = 0; i < 100000; ++i) {
        switch (random() % 4) {
            case 0:
                edit.insert(pieces[random() % std::size(pieces)]);
                break;
            case 1:
                edit.insert(static_cast<char32_t>(random() % 0x120000));
                break;
            case 2:
                edit.place(random() % 310, random() % 2 == 0);
                break;
            default:
                edit.apply(static_cast<TextCommand>(random() % (static_cast<unsigned>(redo) + 1)));
        }
        ASSERT_LE(edit.text().size(), 300u);
        ASSERT_TRUE(allowed(edit.caret())) << i << testing::PrintToString(edit.text()) << edit.caret();
        ASSERT_TRUE(allowed(edit.anchor())) << i << testing::PrintToString(edit.text()) << edit.anchor();
    }
}

}  // namespace
}  // namespace lapfx::ui
