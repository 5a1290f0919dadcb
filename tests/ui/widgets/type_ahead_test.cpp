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
