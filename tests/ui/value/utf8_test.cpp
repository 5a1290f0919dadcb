#include "ui/value/utf8.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace lapfx::ui {
namespace {

std::string encoded(std::u32string_view text) {
    std::string out;
    for (const char32_t c : text) append(out, c);
    return out;
}

/// The places where characters begin, and the end, found by walking forwards.
std::vector<std::size_t> places_forward(std::string_view text) {
    std::vector<std::size_t> places{0};
    while (places.back() < text.size()) places.push_back(places.back() + next_character(text, places.back()));
    return places;
}

std::vector<std::size_t> places_backward(std::string_view text) {
    std::vector<std::size_t> places{text.size()};
    while (places.back() > 0) places.push_back(places.back() - previous_character(text, places.back()));
    return {places.rbegin(), places.rend()};
}

TEST(Utf8, EveryScalarValueComesBackAsItWent) {
    for (char32_t c = 0; c <= 0x10FFFF; ++c) {
        if (c >= 0xD800 && c <= 0xDFFF) continue;
        std::string text;
        append(text, c);
        const Decoded d = decode(text);
        ASSERT_TRUE(d.valid) << std::hex << static_cast<unsigned>(c);
        ASSERT_EQ(d.codepoint, c);
        ASSERT_EQ(d.bytes, text.size());
    }
    EXPECT_EQ(encoded(U"aé€😀"), "a\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
}

TEST(Utf8, WhatIsNoScalarValueIsAppendedAsTheReplacement) {
    for (const char32_t c : {char32_t{0xD800}, char32_t{0xDFFF}, char32_t{0x110000}, char32_t{0xFFFFFFFF}}) {
        std::string text;
        append(text, c);
        EXPECT_EQ(text, "\xEF\xBF\xBD");
    }
}

TEST(Utf8, FaultyBytesAreOneReplacementEach) {
    const char* faulty[] = {"\x80",
                            "\xBF",
                            "\xC0\xAF",
                            "\xC1\xBF",
                            "\xE0\x80\xAF",
                            "\xE0\x9F\xBF",
                            "\xF0\x80\x80\xAF",
                            "\xED\xA0\x80",
                            "\xF4\x90\x80\x80",
                            "\xF5\x80\x80\x80",
                            "\xFF",
                            "\xC3",
                            "\xE2\x82",
                            "\xF0\x9F\x98",
                            "\xC3("};
    for (const std::string_view bytes : faulty) {
        const Decoded d = decode(bytes);
        EXPECT_FALSE(d.valid) << testing::PrintToString(bytes);
        EXPECT_EQ(d.codepoint, replacement);
        EXPECT_EQ(d.bytes, 1);
        EXPECT_FALSE(valid_utf8(bytes));
    }
    EXPECT_TRUE(valid_utf8(""));
    EXPECT_TRUE(valid_utf8("gr\xC3\xBC\xC3\x9F"));
    EXPECT_FALSE(valid_utf8("ok\xC3"));
}

TEST(Utf8, MarksJoinersAndVariationsGoWithWhatTheyStandOn) {
    EXPECT_EQ(places_forward(encoded(U"e\u0301x")), (std::vector<std::size_t>{0, 3, 4}));
    EXPECT_EQ(places_forward(encoded(U"a\u0302\u0323b")), (std::vector<std::size_t>{0, 5, 6}));
    EXPECT_EQ(places_forward(encoded(U"❤\uFE0Fx")), (std::vector<std::size_t>{0, 6, 7}));
    EXPECT_EQ(places_forward(encoded(U"👩\u200D🔬x")), (std::vector<std::size_t>{0, 11, 12}));
    EXPECT_EQ(places_forward(encoded(U"👍🏽x")), (std::vector<std::size_t>{0, 8, 9}));
    EXPECT_EQ(places_forward(encoded(U"a\u200Db")), (std::vector<std::size_t>{0, 4, 5})) << "a letter is not tied";
}

TEST(Utf8, AMarkAtTheFrontOfALineStandsAlone) {
    EXPECT_EQ(places_forward(encoded(U"\u0301a")), (std::vector<std::size_t>{0, 2, 3}));
    EXPECT_EQ(places_forward(encoded(U"a\n\u0301")), (std::vector<std::size_t>{0, 1, 2, 4}));
}

TEST(Utf8, CharactersEndWhereTheTextDoes) {
    EXPECT_EQ(previous_character("abc", 0), 0u);
    EXPECT_EQ(next_character("abc", 3), 0u);
    EXPECT_EQ(next_character("abc", 9), 0u);
    EXPECT_EQ(next_character("", 0), 0u);
    EXPECT_EQ(previous_character("", 0), 0u);
}

/// The characters of a text.
std::vector<std::u32string> characters(std::u32string_view text) {
    const std::string bytes = encoded(text);
    std::vector<std::u32string> found;
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t end = at + next_character(bytes, at);
        std::u32string& character = found.emplace_back();
        for (; at < end; at += decode(std::string_view(bytes).substr(at)).bytes)
            character += decode(std::string_view(bytes).substr(at)).codepoint;
    }
    EXPECT_EQ(places_forward(bytes), places_backward(bytes)) << bytes;
    return found;
}

using Characters = std::vector<std::u32string>;

TEST(Utf8, PicturesTiedByJoinersAreOneCharacter) {
    EXPECT_EQ(characters(U"👩\u200D👩\u200D👧x"), (Characters{U"👩\u200D👩\u200D👧", U"x"}));
    EXPECT_EQ(characters(U"👩🏽\u200D🔬👩"), (Characters{U"👩🏽\u200D🔬", U"👩"}));
    EXPECT_EQ(characters(U"🏳\uFE0F\u200D🌈🏴"), (Characters{U"🏳\uFE0F\u200D🌈", U"🏴"}));
    EXPECT_EQ(characters(U"a\u200D🔬"), (Characters{U"a\u200D", U"🔬"})) << "a joiner after a letter ties nothing";
    EXPECT_EQ(characters(U"❤\u200D≤"), (Characters{U"❤\u200D", U"≤"})) << "a sign of calculation is no picture";
}

TEST(Utf8, FlagsAreTwoLettersEach) {
    EXPECT_EQ(characters(U"🇩🇪🇫🇷x"), (Characters{U"🇩🇪", U"🇫🇷", U"x"}));
    EXPECT_EQ(characters(U"x🇩🇪🇫"), (Characters{U"x", U"🇩🇪", U"🇫"})) << "half a flag";
    EXPECT_EQ(characters(U"🇩\u200D🇪🇫"), (Characters{U"🇩\u200D", U"🇪🇫"}));
    const std::string half = encoded(U"🇩🇪🇫🇷");
    EXPECT_EQ(previous_character(half, 12), 4u) << "from inside a flag to where it begins";
}

TEST(Utf8, SyllablesOfHangulAreOneCharacter) {
    EXPECT_EQ(characters(U"\u1112\u1161\u11AB\u1100\u1173\u11AF"),
              (Characters{U"\u1112\u1161\u11AB", U"\u1100\u1173\u11AF"}));
    EXPECT_EQ(characters(U"가\u11A8나"), (Characters{U"가\u11A8", U"나"})) << "a final consonant";
    EXPECT_EQ(characters(U"한글"), (Characters{U"한", U"글"}));
}

TEST(Utf8, SignsOfIndicThaiAndJapaneseGoWithTheirLetter) {
    EXPECT_EQ(characters(U"नमस्ते"), (Characters{U"न", U"म", U"स्", U"ते"}));
    EXPECT_EQ(characters(U"கோ"), (Characters{U"கோ"}));
    EXPECT_EQ(characters(U"น้ำ"), (Characters{U"น้ำ"})) << "SARA AM is a letter by its category";
    EXPECT_EQ(characters(U"ຂຳ"), (Characters{U"ຂຳ"}));
    EXPECT_EQ(characters(U"ｶﾞ"), (Characters{U"ｶﾞ"})) << "a voiced sound mark of half width";
    EXPECT_EQ(characters(U"\u0600\u0661\u0662"), (Characters{U"\u0600\u0661", U"\u0662"})) << "a sign before its digit";
    EXPECT_EQ(characters(U"\r\n\n"), (Characters{U"\r\n", U"\n"}));
}

TEST(Utf8, AnyBytesHaveTheSamePlacesForwardsAndBackwards) {
    std::mt19937 random(1);
    const std::string pieces[] = {"a",
                                  "\n",
                                  " ",
                                  "\x80",
                                  "\xC3",
                                  "\xE2",
                                  "\xF0",
                                  "\xCC\x81",
                                  "\xE2\x80\x8D",
                                  "\xF0\x9F\x91\xA9",
                                  "\x9F",
                                  "\xE2\x9D\xA4",
                                  "\xFF",
                                  "\r",
                                  "\xF0\x9F\x87\xA9",
                                  "\xE1\x84\x80",
                                  "\xE1\x85\xA1",
                                  "\xD8\x80"};
    for (int round = 0; round < 100000; ++round) {
        std::string text;
        for (auto left = random() % 12; left > 0; --left) text += pieces[random() % std::size(pieces)];
        ASSERT_EQ(places_forward(text), places_backward(text)) << testing::PrintToString(text);
        const auto places = places_forward(text);
        for (std::size_t byte = 1; byte <= text.size(); ++byte) {  // the start may lie inside a character
            const auto at_or_after = std::lower_bound(places.begin(), places.end(), byte);
            ASSERT_EQ(byte - previous_character(text, byte), *std::prev(at_or_after))
                << testing::PrintToString(text) << byte;
        }
    }
}

}  // namespace
}  // namespace lapfx::ui
