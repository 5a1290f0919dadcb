#include "ui/value/id.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace lapfx::ui {
namespace {

TEST(HashBytes, DiffersForEveryByteAndLength) {
    std::set<std::uint64_t> hashes;
    std::size_t texts = 0;
    for (std::size_t size = 0; size <= 40; ++size) {
        const std::string base(size, 'a');
        hashes.insert(hash_bytes(1, base)), ++texts;
        for (std::size_t at = 0; at < size; ++at) {
            std::string other = base;
            other[at] = 'b';
            hashes.insert(hash_bytes(1, other)), ++texts;
        }
    }
    EXPECT_EQ(hashes.size(), texts);
    EXPECT_NE(hash_bytes(1, "a"), hash_bytes(2, "a"));
}

TEST(HashBytes, SpreadsNumbersOverTheLowBits) {
    std::set<std::uint64_t> slots;
    for (int i = 0; i < 1000; ++i) slots.insert(hash_bytes(14, std::to_string(i) + ".25") & 0xffff);
    EXPECT_GT(slots.size(), 970U);  // an even spread gives about 992
}

}  // namespace
}  // namespace lapfx::ui
