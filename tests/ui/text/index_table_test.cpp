#include "ui/text/index_table.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace lapfx::ui {
namespace {

TEST(IndexTable, AgreesWithAMapWhateverIsPutInAndTakenOut) {
    // There are few different hashes, many of them neighbours around the end of the table, so that chains wrap and
    // shift.
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

}  // namespace
}  // namespace lapfx::ui
