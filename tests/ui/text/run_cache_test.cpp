#include "ui/text/run_cache.h"

#include <gtest/gtest.h>

#include "ui/support/count_allocations.h"

namespace lapfx::ui {
namespace {

void pass_frames(RunCache& cache, int frames) {
    for (int i = 0; i < frames; ++i) cache.next_frame();
}

TEST(RunCache, FindsByTextAndStyle) {
    RunCache cache;
    cache.add("one", 1).width = 11;
    cache.add("one", 2).width = 12;
    cache.add("two", 1).width = 21;
    ASSERT_NE(cache.find("one", 2), nullptr);
    EXPECT_EQ(cache.find("one", 1)->width, 11);
    EXPECT_EQ(cache.find("one", 2)->width, 12);
    EXPECT_EQ(cache.find("two", 1)->width, 21);
    EXPECT_EQ(cache.find("two", 2), nullptr);
    EXPECT_EQ(cache.find("on", 1), nullptr);
}

TEST(RunCache, FindsTextsThatAreAskedForInAnotherOrder) {
    RunCache cache;
    const auto find_all = [&](std::initializer_list<std::string_view> texts) {
        cache.next_frame();
        for (const std::string_view text : texts) {
            const ui::Run* run = cache.find(text, 1);
            if (run == nullptr) {
                ui::Run& added = cache.add(text, 1);
                added.width = static_cast<float>(text.size());
                run = &added;
            }
            EXPECT_EQ(run->width, static_cast<float>(text.size())) << text;
        }
    };
    find_all({"a", "bb", "ccc", "dddd"});
    find_all({"a", "bb", "ccc", "dddd"});
    find_all({"eeeee", "a", "bb", "ccc", "dddd"});
    find_all({"dddd", "ccc"});
    find_all({"dddd", "ccc", "a", "a", "eeeee"});
    EXPECT_EQ(cache.size(), 5U) << "none was added twice";
    pass_frames(cache, 500);
    EXPECT_EQ(cache.size(), 0U);
    EXPECT_EQ(cache.find("dddd", 1), nullptr) << "not by the order of before";
    find_all({"ff", "dddd", "ccc"});
    cache.clear();
    EXPECT_EQ(cache.find("ff", 1), nullptr);
}

TEST(RunCache, KeepsWhatIsUsedAndForgetsWhatIsNot) {
    RunCache cache;
    const ui::Run* used = &cache.add("used", 1);
    for (int i = 0; i < 500; ++i) cache.add(std::to_string(i), 1);
    for (int frame = 0; frame < 120; ++frame) {
        cache.next_frame();
        EXPECT_EQ(cache.find("used", 1), used);
    }
    EXPECT_EQ(cache.size(), 501U) << "patience";
    for (int frame = 0; frame < 90; ++frame) {
        cache.next_frame();
        EXPECT_EQ(cache.find("used", 1), used);
    }
    EXPECT_EQ(cache.size(), 1U);
    EXPECT_EQ(cache.find("7", 1), nullptr);
}

TEST(RunCache, ForgetsSoonerWhenThereAreVeryMany) {
    RunCache cache;
    for (int i = 0; i < 10000; ++i) cache.add(std::to_string(i), 1);
    pass_frames(cache, 40);
    EXPECT_LE(cache.size(), 4096U);
    pass_frames(cache, 200);
    EXPECT_EQ(cache.size(), 0U);
}

TEST(RunCache, GivesEmptyRunsAgainWithTheirMemory) {
    RunCache cache;
    ui::Run& first = cache.add("first", 1);
    first.glyphs.resize(20);
    first.stops.resize(21);
    cache.clear();
    EXPECT_EQ(cache.find("first", 1), nullptr);
    const std::size_t before = test::allocations_so_far();
    ui::Run& second = cache.add("second", 1);
    second.glyphs.resize(20);
    EXPECT_EQ(test::allocations_so_far(), before);
    cache.clear();
    EXPECT_TRUE(cache.add("third", 1).glyphs.empty());
}

}  // namespace
}  // namespace lapfx::ui
