#include "ui/widgets/type_ahead.h"

#include <gtest/gtest.h>

#include <array>

namespace lapfx::ui {
namespace {

constexpr std::array<std::string_view, 5> names{"Apple", "banana", "bath", "Bath tub", "cherry"};

std::size_t found(const TypeAhead& typed, std::size_t from) {
    return typed.find(names.size(), from, [](std::size_t i) { return names[i]; });
}

TEST(TypeAhead, FindsTheNextThatBeginsSoInEitherCase) {
    TypeAhead typed;
    EXPECT_EQ(found(typed, 0), names.size()) << "nothing is typed";
    for (const char32_t c : {U'B', U'a', U't'}) typed.add(c, 10);
    EXPECT_EQ(found(typed, names.size()), 2U);
    EXPECT_EQ(found(typed, 2), 2U) << "where it stands is one of them";
    EXPECT_EQ(found(typed, 3), 3U);
    EXPECT_EQ(found(typed, 4), 2U) << "around the end";
    typed.add(U'z', 10);
    EXPECT_EQ(found(typed, 2), names.size());
}

TEST(TypeAhead, OneLetterOverAndOverGoesOn) {
    TypeAhead typed;
    typed.add(U'b', 1);
    EXPECT_EQ(found(typed, 1), 2U);
    typed.add(U'b', 1.5);
    EXPECT_EQ(found(typed, 2), 3U);
    EXPECT_EQ(found(typed, 3), 1U);
}

TEST(TypeAhead, ALetterOfSeveralBytesIsOne) {
    constexpr std::array<std::string_view, 4> all{"\u00e9cart", "\u00e8re", "\u00e9t\u00e9", "eel"};
    const auto next = [&](const TypeAhead& typed, std::size_t from) {
        return typed.find(all.size(), from, [&](std::size_t i) { return all[i]; });
    };
    TypeAhead typed;
    typed.add(U'\u00e9', 1);
    EXPECT_EQ(next(typed, all.size()), 0U);
    EXPECT_EQ(next(typed, 0), 2U);
    typed.add(U'\u00e9', 1.2);
    EXPECT_EQ(next(typed, 0), 2U) << "and on";
    EXPECT_EQ(next(typed, 2), 0U);
    TypeAhead other;
    other.add(U'\u00e9', 1), other.add(U't', 1.2);
    EXPECT_EQ(next(other, 0), 2U);
    EXPECT_EQ(next(other, 2), 2U) << "a word";
}

TEST(TypeAhead, LettersBelongTogetherForASecond) {
    TypeAhead typed;
    EXPECT_FALSE(typed.open(0));
    typed.add(U'b', 5);
    EXPECT_TRUE(typed.open(5 + TypeAhead::together));
    EXPECT_FALSE(typed.open(5.01 + TypeAhead::together));
    typed.add(U'c', 6.1);
    EXPECT_EQ(found(typed, 0), 4U) << "another word";
    typed.clear();
    EXPECT_FALSE(typed.open(6.1));
}

}  // namespace
}  // namespace lapfx::ui
