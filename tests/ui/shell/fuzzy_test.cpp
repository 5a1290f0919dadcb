#include "ui/shell/fuzzy.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace lapfx::ui {
namespace {

float score(std::string_view pattern, std::string_view text) {
    const auto match = fuzzy_match(pattern, text);
    return match ? match->score : -1;
}

/// The matched letters in upper case, the others in lower.
std::string marked(std::string_view pattern, std::string text) {
    const auto match = fuzzy_match(pattern, text);
    for (std::size_t i = 0; i < text.size(); ++i)
        text[i] = static_cast<char>(match && match->at(i) ? std::toupper(text[i]) : std::tolower(text[i]));
    return text;
}

TEST(Fuzzy, LettersAreFoundInOrderWithGaps) {
    EXPECT_TRUE(fuzzy_match("fsv", "File: Save"));
    EXPECT_FALSE(fuzzy_match("vsf", "File: Save"));
    EXPECT_FALSE(fuzzy_match("savee", "File: Save"));
    EXPECT_TRUE(fuzzy_match("", "anything"));
    EXPECT_FALSE(fuzzy_match("a", ""));
    EXPECT_TRUE(fuzzy_match("  ", ""));
}

TEST(Fuzzy, WordsOfThePatternComeInAnyOrder) {
    EXPECT_TRUE(fuzzy_match("save file", "File: Save"));
    EXPECT_FALSE(fuzzy_match("save edit", "File: Save"));
}

TEST(Fuzzy, BeginningsAndNeighboursCountMost) {
    EXPECT_GT(score("save", "File: Save"), score("save", "Show all vertices"));
    EXPECT_GT(score("sa", "File: Save"), score("sa", "View: Scale all"));
    EXPECT_GT(score("so", "Save options"), score("so", "Resort"));
    EXPECT_GT(score("fs", "File: Save"), score("fs", "Offset"));
    EXPECT_GT(score("save", "Save"), score("save", "Save a copy"));
    EXPECT_GT(score("mp", "MeshPart"), score("mp", "Ramp"));
}

TEST(Fuzzy, TheMatchedLettersAreTold) {
    EXPECT_EQ(marked("fs", "File: Save"), "File: Save");
    EXPECT_EQ(marked("save", "Show all: save"), "show all: SAVE");
    EXPECT_EQ(marked("SAVE fi", "file: save"), "FIle: SAVE");
    EXPECT_EQ(marked("op", "Loop options"), "loop OPtions");
}

TEST(Fuzzy, AnyBytesHold) {
    std::mt19937 random(1);
    for (int i = 0; i < 20000; ++i) {
        std::string pattern(random() % 40, ' '), text(random() % 200, ' ');
        for (char& c : pattern) c = "ab \xc3\xa9"[random() % 5];
        for (char& c : text) c = "abAB: \xc3\xa9"[random() % 8];
        const auto match = fuzzy_match(pattern, text);
        for (std::size_t at = 0; match && at < fuzzy_text_bytes; ++at) {
            if (match->at(at)) {
                ASSERT_LT(at, text.size());
            }
        }
    }
}

}  // namespace
}  // namespace lapfx::ui
