#include "smoke/clip_stream.h"

#include <gtest/gtest.h>

#include <chrono>
#include <random>

#include "support/clips.h"
#include "unit/preset/support.h"

namespace lapfx::smoke {
namespace {

constexpr int frames = 12;

class ClipStreamTest : public testing::TestWithParam<int> {
  protected:
    test::Folder folder;
    std::filesystem::path clip = test::write_clip(folder / "c.avi", frames);

    /// The number that frame `index` shows, which should be `index`; -1 when it is late.
    static int shown(ClipStream& stream, int index, Policy policy = Policy::wait) {
        const cv::Mat* image = stream.frame(index, policy);
        return image == nullptr ? -1 : test::frame_number(*image);
    }
    /// Asks without waiting until the frame is there.
    static int polled(ClipStream& stream, int index) {
        const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (std::chrono::steady_clock::now() < until) {
            if (const int number = shown(stream, index, Policy::latest); number >= 0) return number;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return -1;
    }
};

TEST_P(ClipStreamTest, PlaysForwardAndRoundTheLoop) {
    ClipStream stream(clip, GetParam());
    EXPECT_EQ(stream.info().frame_count, frames);
    for (int i = 0; i < 3 * frames; ++i) ASSERT_EQ(shown(stream, i % frames), i % frames) << i;
    EXPECT_EQ(stream.misses(), 0u);
}

TEST_P(ClipStreamTest, AnyOrderGivesTheRightFrame) {
    ClipStream stream(clip, GetParam());
    std::mt19937 random(3);
    for (int i = 0; i < 60; ++i) {
        const int index = static_cast<int>(random() % frames);
        ASSERT_EQ(shown(stream, index), index) << "step " << i;
    }
}

TEST_P(ClipStreamTest, PlaysBackwardsSkipsAndRepeats) {
    ClipStream stream(clip, GetParam());
    for (int i = frames - 1; i >= 0; --i) ASSERT_EQ(shown(stream, i), i);
    for (int i = 0; i < 2 * frames; i += 3) ASSERT_EQ(shown(stream, i % frames), i % frames);
    for (int i = 0; i < 5; ++i) ASSERT_EQ(shown(stream, 4), 4);
}

INSTANTIATE_TEST_SUITE_P(Buffers, ClipStreamTest, testing::Values(2, 3, 8, 64));

using ClipStreamOnce = ClipStreamTest;

TEST_F(ClipStreamOnce, AClipOfOneFrameAlwaysShowsIt) {
    ClipStream stream(test::write_clip(folder / "one.avi", 1), 4);
    ASSERT_EQ(stream.info().frame_count, 1);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(shown(stream, 0), 0);
}

TEST_F(ClipStreamOnce, LatestDoesNotWaitAndCountsTheMiss) {
    ClipStream stream(clip, 2);  // it holds frames 0 and 1 at most, so 9 cannot be there
    EXPECT_EQ(shown(stream, 9, Policy::latest), -1);
    EXPECT_EQ(stream.misses(), 1u);
    EXPECT_EQ(polled(stream, 9), 9) << "asking for it has set the worker to it";
    const auto misses = stream.misses();
    EXPECT_EQ(shown(stream, 9, Policy::latest), 9);
    EXPECT_EQ(stream.misses(), misses) << "a frame that is there is no miss";
    EXPECT_EQ(shown(stream, 2, Policy::latest), -1);
    EXPECT_EQ(stream.misses(), misses + 1);
}

TEST_F(ClipStreamOnce, LatestNeverShowsAWrongFrame) {
    ClipStream stream(clip, 3);
    std::mt19937 random(5);
    for (int i = 0; i < 3000; ++i) {
        const int index = static_cast<int>(random() % frames);
        const int number = shown(stream, index, Policy::latest);
        ASSERT_TRUE(number == -1 || number == index) << index << " shows " << number;
    }
}

TEST_F(ClipStreamOnce, PeekFindsTheNextFrameAndDoesNotMove) {
    ClipStream stream(clip, 4);
    ASSERT_EQ(shown(stream, 5), 5);
    ASSERT_EQ(shown(stream, 6), 6);
    ASSERT_EQ(shown(stream, 5), 5);
    const cv::Mat* next = stream.peek(6);
    ASSERT_NE(next, nullptr) << "it was decoded for the call before";
    EXPECT_EQ(test::frame_number(*next), 6);
    EXPECT_EQ(stream.peek(2), nullptr);
    EXPECT_EQ(stream.misses(), 0u);
}

TEST_F(ClipStreamOnce, ATruncatedClipPlaysWhatItHas) {
    const std::string whole = test::read_text(test::write_clip(folder / "whole.avi", frames, {320, 240}));
    ClipStream stream(folder.write("half.avi", whole.substr(0, whole.size() * 6 / 10)), 3);
    const int count = stream.info().frame_count;
    ASSERT_GE(count, 3);
    ASSERT_LT(count, frames);
    for (int i = 0; i < count - 1; ++i) EXPECT_EQ(shown(stream, i), i);  // the last may be cut through
    EXPECT_EQ(shown(stream, 0), 0);
}

TEST_F(ClipStreamOnce, WhenTheFileVanishesTheLastGoodFrameStays) {
    ClipStream stream(clip, 2);
    ASSERT_EQ(shown(stream, 5), 5);
    std::filesystem::remove(clip);
    // Back at the start the file would have to be opened again. The worker may have been one frame ahead.
    for (const int index : {0, 1, 3}) {
        const int number = shown(stream, index);
        EXPECT_TRUE(number == 5 || number == 6) << index << " shows " << number;
    }
    test::write_clip(clip, frames);
    ASSERT_EQ(shown(stream, 10), 10) << "it has come back";
    EXPECT_EQ(shown(stream, 2), 2);
}

TEST_F(ClipStreamOnce, WhenTheFileBecomesGarbageTheLastGoodFrameStays) {
    ClipStream stream(clip, 2);
    ASSERT_EQ(shown(stream, 5), 5);
    std::filesystem::remove(clip);
    folder.write("c.avi", "no video any more");
    const int number = shown(stream, 0);
    EXPECT_TRUE(number == 5 || number == 6) << number;
}

TEST_F(ClipStreamOnce, EndsWhileTheWorkerIsBusy) {
    for (int i = 0; i < 20; ++i) {
        ClipStream stream(clip, 8);
        stream.frame(frames - 1, Policy::latest);
    }
}

TEST_F(ClipStreamOnce, WhatCannotBeOpenedIsAnError) {
    EXPECT_EQ(test::faults_of([&] { ClipStream(folder / "none.avi", 2); }),
              std::vector{(folder / "none.avi").string() + ": no such file"});
}

}  // namespace
}  // namespace lapfx::smoke
