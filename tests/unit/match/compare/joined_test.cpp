#include "match/compare/joined.h"

#include <gtest/gtest.h>

#include <vector>

namespace lapfx::match {
namespace {

std::string of(const std::vector<std::string>& parts) {
    return joined(parts);
}

TEST(Joined, ReadsAsASentenceDoes) {
    EXPECT_EQ(of({}), "");
    EXPECT_EQ(of({"a"}), "a");
    EXPECT_EQ(of({"a", "b"}), "a and b");
    EXPECT_EQ(of({"a", "b", "c", "d"}), "a, b, c and d");
}

}  // namespace
}  // namespace lapfx::match
