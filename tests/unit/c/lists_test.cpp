// The closed lists of the core in other languages: what lapfx.h and lapfx.py have is what the rows have.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "lapfx/amounts.h"
#include "lapfx/tool.h"
#include "support/count_members.h"
#include "support/folders.h"

namespace lapfx {
namespace {

using Words = std::vector<std::string>;

std::string text_of(const std::filesystem::path& file) {
    std::ifstream in(test::source_folder() / "effects" / "c" / file);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// What lies between two words, without the comments of C.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t from = text.find(begin);
    if (from == std::string::npos) return {};
    const std::size_t first = from + begin.size();
    return std::regex_replace(text.substr(first, text.find(end, first) - first), std::regex("//[^\n]*"), "");
}

/// The first group of each place that matches.
Words found(const std::string& text, const std::string& pattern) {
    Words words;
    const std::regex regex(pattern);
    for (std::sregex_iterator i(text.begin(), text.end(), regex), none; i != none; ++i) words.push_back((*i)[1]);
    return words;
}

std::string upper(std::string_view key) {
    std::string text(key);
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
    return text;
}

Words sorted(Words words) {
    std::sort(words.begin(), words.end());
    return words;
}

TEST(ListsOfOtherLanguages, ToolActionsAreTheRows) {
    Words in_c, in_python;
    for (const ToolActionRow& row : tool_actions) {
        in_c.push_back(upper(row.key) + " = " + std::to_string(static_cast<int>(row.action)));
        in_python.emplace_back(row.key);
    }
    // The enum without a name in front of lapfx_contact.
    const std::string header = text_of("include/lapfx.h");
    const std::size_t first = header.find("LAPFX_" + upper(tool_actions[0].key) + " = 0");
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(found(between(header.substr(first - 1), "", "}"), "LAPFX_(\\w+ = \\d+)"), in_c);
    EXPECT_EQ(found(between(text_of("lapfx.py"), "\nACTIONS = (", ")"), "\"(\\w+)\""), in_python);
}

TEST(ListsOfOtherLanguages, AmountsAreTheRows) {
    Words keys;
    for (const AmountRow& row : amount_rows) keys.emplace_back(row.key);
    EXPECT_EQ(amount_count, test::count_members<Amounts>()) << "a member of Amounts without a row, or a row too many";
    const Words in_c =
        found(between(text_of("include/lapfx.h"), "typedef struct lapfx_amounts {\n    size_t size;", "}"), "(\\w+);");
    EXPECT_EQ(sorted(in_c), sorted(keys));
    const std::string fields = between(text_of("lapfx.py"), "class Amounts(_Struct):", "\n\n");
    Words in_python = found(fields, "\\(\"(\\w+)\", ");
    ASSERT_FALSE(in_python.empty());
    EXPECT_EQ(in_python.front(), "size");
    in_python.erase(in_python.begin());
    EXPECT_EQ(in_python, in_c) << "in the order of C";
}

}  // namespace
}  // namespace lapfx
