#include "ui/text/index_table.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <string>

namespace lapfx::ui {
namespace {

TEST(IndexTable, AgreesWithAMapWhateverIsPutInAndTakenOut) {
    // Few different hashes, many of them neighbours around the end of the table: chains that wrap and shift.
    IndexTable table(16);
    std::map<std::uint64_t, std::uint32_t> expected;
    std::mt19937 random(7);
    for (std::uint32_t step = 0; step < 20000; ++step) {
        const std::uint64_t hash = (random() % 24 + 4084) % 4096 + (random() % 3 << 20);
        const std::uint32_t found = table.find(hash, [](std::uint32_t) { return true; });
        const auto known = expected.find(hash);
        ASSERT_EQ(found, known == expected.end() ? IndexTable::none : known->second);
        if (known == expected.end()) {
            table.insert(hash, step);
            expected[hash] = step;
        } else {
            for (std::size_t slot = 0; slot < table.slots(); ++slot) {
                if (table.in_slot(slot) != found) continue;
                table.erase_slot(slot);
                break;
            }
            expected.erase(known);
        }
        ASSERT_EQ(table.size(), expected.size());
    }
    EXPECT_GE(table.slots(), 2 * table.size());
}

TEST(IndexTable, TellsEqualHashesApartByWhatTheyStandFor) {
    IndexTable table(16);
    table.insert(5, 0);
    table.insert(5, 1);
    EXPECT_EQ(table.find(5, [](std::uint32_t i) { return i == 1; }), 1U);
    EXPECT_EQ(table.find(5, [](std::uint32_t i) { return i == 2; }), IndexTable::none);
}

TEST(HashOf, DiffersForEveryByteAndLength) {
    std::set<std::uint64_t> hashes;
    std::size_t texts = 0;
    for (std::size_t size = 0; size <= 40; ++size) {
        const std::string base(size, 'a');
        hashes.insert(hash_of(base, 1)), ++texts;
        for (std::size_t at = 0; at < size; ++at) {
            std::string other = base;
            other[at] = 'b';
            hashes.insert(hash_of(other, 1)), ++texts;
        }
    }
    EXPECT_EQ(hashes.size(), texts);
    EXPECT_NE(hash_of("a", 1), hash_of("a", 2));
}

TEST(HashOf, SpreadsNumbersOverTheLowBits) {
    std::set<std::uint64_t> slots;
    for (int i = 0; i < 1000; ++i) slots.insert(hash_of(std::to_string(i) + ".25", 14) & 0xffff);
    EXPECT_GT(slots.size(), 970U);  // 992 expected of an even spread
}

}  // namespace
}  // namespace lapfx::ui
