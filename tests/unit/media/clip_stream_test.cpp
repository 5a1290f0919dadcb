#include "media/clip_stream.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <set>

#include "support/clips.h"
#include "support/idle.h"
#include "unit/preset/support.h"

namespace lapfx::media {
namespace {

constexpr int frames = 12;

/// The number of the frame of a clip made by write_clip(), from its luma plane; -1 for none.
int number_of(std::span<const std::uint8_t> bytes, const PictureFormat& format) {
    if (bytes.empty()) return -1;
    const auto luma = bytes.begin();
    const auto end = luma + static_cast<std::ptrdiff_t>(format.color_bytes());
    return test::number_of_level(std::accumulate(luma, end, 0.0) / static_cast<double>(format.color_bytes()));
}

class ClipStreamTest : public testing::TestWithParam<int> {
  protected:
    test::Folder folder;
    std::filesystem::path clip = test::write_clip(folder / "c.avi", frames);
    DecodePool pool{2};
    std::vector<std::uint8_t> kept = std::vector<std::uint8_t>(frames);
    double waited = 0.0;

    ClipStream open(int buffers, Loop loop = {0, frames - 1}) {
        return {pool, Decoder(clip, Layout::planar), loop, buffers, &kept};
    }
    /// The number that frame `index` shows, which should be `index`; -1 when it is late.
    int shown(ClipStream& stream, int index, Policy policy = Policy::wait) {
        return number_of(stream.frame(index, policy, waited).bytes, {.size = {64, 48}});
    }
    int peeked(ClipStream& stream, int index) { return number_of(stream.peek(index).bytes, {.size = {64, 48}}); }
};

TEST_P(ClipStreamTest, PlaysForwardAndRoundTheLoop) {
    ClipStream stream = open(GetParam());
    for (int i = 0; i < 3 * frames; ++i) ASSERT_EQ(shown(stream, i % frames), i % frames) << i;
}

TEST_P(ClipStreamTest, AnyOrderGivesTheRightFrame) {
    ClipStream stream = open(GetParam());
    std::mt19937 random(3);
    for (int i = 0; i < 60; ++i) {
        const int index = static_cast<int>(random() % frames);
        ASSERT_EQ(shown(stream, index), index) << "step " << i;
    }
}

TEST_P(ClipStreamTest, PlaysBackwardsSkipsAndRepeats) {
    ClipStream stream = open(GetParam());
    for (int i = frames - 1; i >= 0; --i) ASSERT_EQ(shown(stream, i), i);
    for (int i = 0; i < 2 * frames; i += 3) ASSERT_EQ(shown(stream, i % frames), i % frames);
    for (int i = 0; i < 5; ++i) ASSERT_EQ(shown(stream, 4), 4);
}

TEST_P(ClipStreamTest, StartsOverWithinItsLoop) {
    ClipStream stream = open(GetParam(), {3, 6});
    for (int i = 0; i < 20; ++i) ASSERT_EQ(shown(stream, 3 + i % 4), 3 + i % 4) << i;
    EXPECT_EQ(shown(stream, 9), 9) << "outside of it frames are there all the same";
    stream.set_loop({8, 8});
    for (int i = 0; i < 3; ++i) ASSERT_EQ(shown(stream, 8), 8);
}

TEST_P(ClipStreamTest, DecodesNothingThatIsKept) {
    ClipStream stream = open(GetParam());
    for (int i = 0; i < frames; ++i) {
        ASSERT_EQ(shown(stream, i), i);
        const std::lock_guard lock(pool.mutex());
        kept[static_cast<std::size_t>(i)] = 1;
    }
    pool.wake();
    ASSERT_TRUE(stream.rest());
    EXPECT_EQ(stream.memory(), 0u) << "resting, it holds nothing";
    const auto decoded = stream.work().decoded;
    EXPECT_EQ(decoded, static_cast<std::uint64_t>(frames)) << "each frame once";
    {
        const std::lock_guard lock(pool.mutex());
        kept[5] = 0;
    }
    EXPECT_EQ(shown(stream, 5), 5) << "what is no longer kept is decoded again";
}

TEST_P(ClipStreamTest, ClosesItsFileWhileAllOfItIsKept) {
    ClipStream stream = open(GetParam());
    for (int i = 0; i < frames; ++i) {
        ASSERT_EQ(shown(stream, i), i);
        const std::lock_guard lock(pool.mutex());
        kept[static_cast<std::size_t>(i)] = 1;
    }
    EXPECT_FALSE(stream.closed());
    ASSERT_TRUE(stream.rest());
    EXPECT_TRUE(test::wait_until([&] { return stream.closed(); }));
    stream.aim(3);
    ASSERT_TRUE(stream.rest());
    EXPECT_TRUE(stream.closed()) << "where it is looked at makes no difference";
    {
        const std::lock_guard lock(pool.mutex());
        kept[5] = 0;
    }
    EXPECT_EQ(shown(stream, 5), 5) << "it is opened again";
    EXPECT_FALSE(stream.closed());
    EXPECT_EQ(stream.work().decoded, static_cast<std::uint64_t>(frames + 1));
    EXPECT_EQ(stream.work().broken, 0);
}

INSTANTIATE_TEST_SUITE_P(Buffers, ClipStreamTest, testing::Values(1, 2, 3, 8, 64));

using ClipStreamOnce = ClipStreamTest;

TEST_F(ClipStreamOnce, AClipOfOneFrameAlwaysShowsIt) {
    ClipStream stream(pool, Decoder(test::write_clip(folder / "one.avi", 1), Layout::planar), {0, 0}, 4);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(shown(stream, 0), 0);
    EXPECT_EQ(stream.work().decoded, 1u);
}

TEST_F(ClipStreamOnce, LatestDoesNotWaitAndSaysWhatItShows) {
    ClipStream stream = open(3);
    std::mt19937 random(5);
    int late = 0;
    for (int i = 0; i < 3000; ++i) {
        const int index = static_cast<int>(random() % frames);
        const ClipStream::LentFrame shown = stream.frame(index, Policy::latest, waited);
        ASSERT_EQ(number_of(shown.bytes, {.size = {64, 48}}), shown.index);
        late += shown.index != index ? 1 : 0;
    }
    EXPECT_GT(late, 0);
    EXPECT_EQ(waited, 0.0);
    EXPECT_TRUE(test::wait_until([&] { return shown(stream, 9, Policy::latest) == 9; }))
        << "asking sets the worker to it";
}

TEST_F(ClipStreamOnce, AClipThatTakesLongerToDecodeThanToPlayIsShownInSlowMotion) {
    // Large enough that a frame takes milliseconds; played by a thousand frames a second.
    const std::filesystem::path slow = test::write_clip(folder / "slow.avi", 25, {1920, 1440});
    DecodePool one(1);
    std::vector<std::uint8_t> done(25);
    ClipStream stream(one, Decoder(slow, Layout::planar), {0, 24}, 3, &done);
    std::set<int> seen;
    int asked = 0;
    EXPECT_TRUE(test::wait_until([&] {
        for (int i = 0; i < 25 && done[static_cast<std::size_t>(asked)] != 0; ++i) asked = (asked + 1) % 25;
        if (done[static_cast<std::size_t>(asked)] != 0) return true;  // all are kept
        const ClipStream::LentFrame shown = stream.frame(asked, Policy::latest, waited);
        if (!shown.bytes.empty()) {
            seen.insert(shown.index);
            const std::lock_guard lock(one.mutex());
            done[static_cast<std::size_t>(shown.index)] = 1;
        }
        asked = (asked + 1) % 25;
        return false;
    })) << seen.size()
        << " frames seen";
    EXPECT_EQ(seen.size(), 25u) << "what is shown and kept grows, though none is ever there in time";
    EXPECT_LE(stream.work().decoded, 60u) << "next to nothing is decoded in vain";
}

TEST_F(ClipStreamOnce, FewerBuffersHoldLess) {
    ClipStream stream = open(8);
    ASSERT_EQ(shown(stream, 0), 0);
    const std::size_t frame_bytes = PictureFormat{.size = {64, 48}}.bytes();
    ASSERT_TRUE(test::wait_until([&] { return stream.memory() >= 8 * frame_bytes; }));
    stream.set_buffers(2);
    EXPECT_TRUE(test::wait_until([&] { return stream.memory() <= 4 * frame_bytes; }));
    for (int i = 0; i < 2 * frames; ++i) ASSERT_EQ(shown(stream, i % frames), i % frames);
    EXPECT_LE(stream.memory(), 4 * frame_bytes);
}

TEST_F(ClipStreamOnce, PeekFindsTheNextFrameAndDoesNotMove) {
    ClipStream stream = open(4);
    ASSERT_EQ(shown(stream, 5), 5);
    EXPECT_TRUE(test::wait_until([&] { return peeked(stream, 6) == 6; }));
    EXPECT_TRUE(stream.peek(2).bytes.empty());
    const ClipStream::LentFrame any = stream.peek_any();
    EXPECT_EQ(number_of(any.bytes, {.size = {64, 48}}), any.index);
}

TEST_F(ClipStreamOnce, WithOneBufferTheNextFrameIsDecodedWhenItIsAimedAt) {
    DecodePool one{1};
    ClipStream stream(one, Decoder(clip, Layout::planar), {0, frames - 1}, 1, &kept);
    test::Idle idle(one);
    ASSERT_EQ(shown(stream, 3), 3);
    idle.wait();
    const auto decoded = stream.work().decoded;
    EXPECT_EQ(peeked(stream, 4), -1) << "figure 3: not before the signal";
    stream.aim(4);
    EXPECT_TRUE(test::wait_until([&] { return peeked(stream, 4) == 4; }));
    EXPECT_EQ(stream.work().decoded, decoded + 1);
}

TEST_F(ClipStreamOnce, ACorruptFrameIsTheOneBeforeAndIsCountedOnce) {
    const std::string whole = test::read_text(test::write_clip(folder / "whole.avi", frames, {320, 240}));
    std::string broken = whole;
    const std::size_t middle = whole.size() / 2;
    std::fill_n(broken.begin() + static_cast<std::ptrdiff_t>(middle), whole.size() / 16, '\0');
    Decoder decoder(folder.write("broken.avi", broken), Layout::planar);
    const int count = decoder.info().frame_count();  // the damage may have removed some from the container's index
    ASSERT_GE(count, frames - 2);
    ClipStream stream(pool, std::move(decoder), {0, count - 1}, 3);
    for (int i = 0; i < 3 * count; ++i) {
        ASSERT_EQ(stream.frame(i % count, Policy::wait, waited).bytes.size(),
                  (PictureFormat{.size = {320, 240}}).bytes());
    }
    EXPECT_LE(stream.work().broken, 2) << "counted once, however often the loop comes by";
    EXPECT_EQ(number_of(stream.frame(0, Policy::wait, waited).bytes, {.size = {320, 240}}), 0);
    EXPECT_EQ(number_of(stream.frame(count - 1, Policy::wait, waited).bytes, {.size = {320, 240}}), frames - 1);
}

TEST_F(ClipStreamOnce, PlaysOnWhenItsFileVanishes) {
    ClipStream stream = open(2);
    ASSERT_EQ(shown(stream, 5), 5);
    std::filesystem::remove(clip);
    for (const int index : {0, 1, 3, 11}) EXPECT_EQ(shown(stream, index), index) << "the file stays open";
}

TEST_F(ClipStreamOnce, EndsWhileTheWorkerIsBusy) {
    for (int i = 0; i < 20; ++i) {
        ClipStream stream = open(8);
        stream.frame(frames - 1, Policy::latest, waited);
    }
}

TEST_F(ClipStreamOnce, ManyShareFewThreads) {
    DecodePool one(1);
    std::vector<std::unique_ptr<ClipStream>> streams;
    for (int i = 0; i < 20; ++i)
        streams.push_back(std::make_unique<ClipStream>(one, Decoder(clip, Layout::planar), Loop{0, frames - 1}, 2));
    for (int i = 0; i < 2 * frames; ++i)
        for (auto& stream : streams) ASSERT_EQ(shown(*stream, i % frames), i % frames);
    streams.erase(streams.begin() + 5, streams.begin() + 15);  // others play meanwhile
    for (auto& stream : streams) ASSERT_EQ(shown(*stream, 7), 7);
}

}  // namespace
}  // namespace lapfx::media
