#include "lapfx/tool_queue.h"

#include <gtest/gtest.h>

#include <thread>

namespace lapfx {
namespace {

ToolSample numbered(double number) {
    return {.time = number,
            .position = {number, 2.0 * number, 3.0 * number},
            .touching = true,
            .action = ToolAction::cut,
            .power = 0.5,
            .strength = 4.0 * number};
}

bool is_numbered(const ToolSample& s, double number) {
    return s.time == number && s.position == glm::dvec3(number, 2.0 * number, 3.0 * number) && s.touching &&
           s.action == ToolAction::cut && s.power == 0.5 && s.strength == 4.0 * number;
}

TEST(ToolQueue, GivesWhatItGotInOrder) {
    ToolQueue queue(8);
    ToolSample sample;
    EXPECT_FALSE(queue.pop(sample));
    for (int round = 0; round < 5; ++round) {
        for (int i = 0; i < 6; ++i) ASSERT_TRUE(queue.push(numbered(i)));
        for (int i = 0; i < 6; ++i) {
            ASSERT_TRUE(queue.pop(sample));
            EXPECT_TRUE(is_numbered(sample, i));
        }
        EXPECT_FALSE(queue.pop(sample));
    }
    EXPECT_EQ(queue.missed(), 0u);
}

TEST(ToolQueue, WhenFullItKeepsTheOldAndCountsTheMissed) {
    ToolQueue queue(4);
    ASSERT_EQ(queue.capacity(), 4u);
    for (int i = 0; i < 7; ++i) EXPECT_EQ(queue.push(numbered(i)), i < 4) << i;
    EXPECT_EQ(queue.missed(), 3u);
    ToolSample sample;
    ASSERT_TRUE(queue.pop(sample));
    EXPECT_TRUE(is_numbered(sample, 0));
    EXPECT_TRUE(queue.push(numbered(9))) << "there is room again";
    for (const double wanted : {1.0, 2.0, 3.0, 9.0}) {
        ASSERT_TRUE(queue.pop(sample));
        EXPECT_TRUE(is_numbered(sample, wanted));
    }
}

TEST(ToolQueue, HasRoomForAtLeastOne) {
    EXPECT_EQ(ToolQueue(0).capacity(), 1u);
    EXPECT_EQ(ToolQueue(5).capacity(), 8u);
    EXPECT_EQ(ToolQueue().capacity(), 8192u);
}

TEST(ToolQueue, CarriesAMillionSamplesFromThreadToThread) {
    constexpr int count = 1'000'000;
    ToolQueue queue(1024);
    std::uint64_t refused = 0;
    std::jthread producer([&] {
        for (int i = 0; i < count; ++i)
            while (!queue.push(numbered(i))) {
                ++refused;
                std::this_thread::yield();
            }
    });
    int wrong = 0;
    for (int i = 0; i < count;) {
        ToolSample sample;
        if (!queue.pop(sample)) {
            std::this_thread::yield();
            continue;
        }
        wrong += !is_numbered(sample, i++);
    }
    producer.join();
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(queue.missed(), refused);
}

}  // namespace
}  // namespace lapfx
