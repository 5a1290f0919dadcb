#include "ui/widgets/rows.h"

#include <gmock/gmock.h>

#include <array>

namespace lapfx::ui {
namespace {

using testing::ElementsAre;

TEST(Selection, KeepsItsKeysInOrderAndOnce) {
    Selection s;
    for (const std::uint64_t key : {7, 3, 7, 5}) s.add(key);
    EXPECT_THAT(s.keys, ElementsAre(3, 5, 7));
    s.toggle(5);
    EXPECT_THAT(s.keys, ElementsAre(3, 7));
    EXPECT_EQ(s.current, 5U);
    s.toggle(4);
    EXPECT_TRUE(s.has(4));
    EXPECT_FALSE(s.has(5));
    s.only(9);
    EXPECT_THAT(s.keys, ElementsAre(9));
    EXPECT_EQ(s.anchor, 9U);
    s.clear();
    EXPECT_TRUE(s.keys.empty());
    EXPECT_EQ(s.current, no_key);
}

TEST(ItemAfter, InAListGoesByOneAPageAndToTheEnds) {
    const auto to = [](Key key, std::size_t at) { return item_after(key, at, 100, 1, 10); };
    EXPECT_EQ(to(Key::down, 5), 6U);
    EXPECT_EQ(to(Key::down, 99), 99U);
    EXPECT_EQ(to(Key::up, 5), 4U);
    EXPECT_EQ(to(Key::up, 0), 0U);
    EXPECT_EQ(to(Key::page_down, 5), 15U);
    EXPECT_EQ(to(Key::page_down, 95), 99U);
    EXPECT_EQ(to(Key::page_up, 15), 5U);
    EXPECT_EQ(to(Key::page_up, 5), 0U);
    EXPECT_EQ(to(Key::home, 50), 0U);
    EXPECT_EQ(to(Key::end, 50), 99U);
    EXPECT_EQ(to(Key::down, no_row), 0U);
    EXPECT_EQ(to(Key::enter, 5), no_row);
    EXPECT_EQ(item_after(Key::down, no_row, 0, 1, 10), no_row);
}

TEST(ItemAfter, InAGridKeepsItsColumn) {
    // 0 1 2 / 3 4 5 / 6 7
    const auto to = [](Key key, std::size_t at) { return item_after(key, at, 8, 3, 2); };
    EXPECT_EQ(to(Key::down, 1), 4U);
    EXPECT_EQ(to(Key::up, 7), 4U);
    EXPECT_EQ(to(Key::right, 2), 3U);
    EXPECT_EQ(to(Key::left, 3), 2U);
    EXPECT_EQ(to(Key::right, 7), 7U);
    EXPECT_EQ(to(Key::left, 0), 0U);
    EXPECT_EQ(to(Key::down, 5), 7U) << "there is something below, though not in its column";
    EXPECT_EQ(to(Key::down, 7), 7U);
    EXPECT_EQ(to(Key::up, 2), 2U);
    EXPECT_EQ(to(Key::page_down, 1), 7U);
    EXPECT_EQ(to(Key::page_up, 7), 1U);
}

TEST(ItemAfter, NeverLeavesTheGrid) {
    for (std::size_t count = 1; count < 20; ++count) {
        for (std::size_t columns = 1; columns < 7; ++columns) {
            for (std::size_t at = 0; at < count; ++at) {
                for (const Key key : {Key::up, Key::down, Key::left, Key::right, Key::page_up, Key::page_down})
                    ASSERT_LT(item_after(key, at, count, columns, 3), count);
                ASSERT_LE(item_after(Key::up, at, count, columns, 3), at);
                ASSERT_GE(item_after(Key::page_down, at, count, columns, 3), at);
            }
        }
    }
}

}  // namespace
}  // namespace lapfx::ui
