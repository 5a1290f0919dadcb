// What a clip shows and sends while its decoding is blocked: the policies of media/policy.h.
#include "media/clip_player.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>
#include <thread>

#include "support/clips.h"
#include "support/gpu_test.h"
#include "support/idle.h"
#include "unit/preset/support.h"

namespace lapfx::media {
namespace {

constexpr int frames = 25;
constexpr int buffers = 4;  // frames decoded ahead

/// While it is shut, it keeps the only decoding thread busy.
class Gate : private DecodePool::Job {
  public:
    explicit Gate(DecodePool& pool) : pool_(pool) { pool.join(*this); }
    ~Gate() override {
        open();
        pool_.leave(*this);
    }
    void shut() {
        {
            const std::lock_guard lock(pool_.mutex());
            shut_ = true;
        }
        pool_.wake();
        while (!inside_) std::this_thread::yield();
    }
    void open() {
        shut_ = false;
        while (inside_) std::this_thread::yield();
    }

  private:
    int urgency() override { return shut_ ? 0 : -1; }
    void begin() override {}
    void run() noexcept override {
        inside_ = true;
        while (shut_) std::this_thread::sleep_for(std::chrono::microseconds(100));
        inside_ = false;
    }
    void end() override {}

    DecodePool& pool_;
    std::atomic<bool> shut_{false}, inside_{false};
};

class ClipPlayerTest : public test::GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        test::write_clip(folder / "a.avi", frames);
        play(Scheme::buffered);
    }
    void play(Scheme scheme) {
        const std::filesystem::path path = folder / "a.avi";
        Decoder decoder(path, Layout::rgb);
        player.reset();
        file = std::make_shared<ClipFile>(path, stamp_of(path), decoder);
        player = std::make_unique<ClipPlayer>(
            pool, file, std::move(decoder), SmokeClip{.file = "a.avi", .start = ClipStart::beginning}, scheme, buffers);
    }
    void TearDown() override {
        player.reset();
        file.reset();
        GpuTest::TearDown();
    }
    /// The number that is shown when `index` is due; -1: nothing.
    int shown(int index, Policy policy) {
        const ClipFrame frame = player->frame(0, index, policy, times);
        if (frame.color == 0) return -1;
        std::vector<std::uint8_t> pixels(frame.format.bytes());
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glGetTextureSubImage(frame.color, 0, 0, 0, frame.layer, frame.format.size.x, frame.format.size.y, 1, GL_RGB,
                             GL_UNSIGNED_BYTE, static_cast<GLsizei>(pixels.size()), pixels.data());
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
        return test::number_of_level(pixels[0]);
    }
    /// A cycle: what it shows.
    int cycle(int index, Policy policy) {
        const int number = shown(index, policy);
        player->end_cycle(cycles++, times);
        return number;
    }

    test::Folder folder;
    DecodePool pool{1};
    std::shared_ptr<ClipFile> file;
    std::unique_ptr<ClipPlayer> player;
    test::Idle idle{pool};
    StreamingTimes times;
    std::uint64_t cycles = 0;
};

TEST_F(ClipPlayerTest, SkipLeavesOutWhatCameLateAndKeepsItsTime) {
    Gate gate(pool);
    idle.wait();  // 0 to 3 are decoded
    gate.shut();
    std::vector<int> order;
    for (int i = 0; i < 6; ++i) order.push_back(cycle(i, Policy::skip));
    EXPECT_THAT(order, testing::ElementsAre(0, 1, 2, 3, 3, 3)) << "what there was, then the last one again";
    EXPECT_EQ(player->misses(), 2u);
    gate.open();
    order.clear();
    for (int i = 6; i < 14; ++i) {
        idle.wait();
        order.push_back(cycle(i, Policy::skip));
    }
    EXPECT_THAT(order, testing::ElementsAre(3, 7, 8, 9, 10, 11, 12, 13)) << "4 to 6 are left out";
    EXPECT_EQ(times.wait, 0.0);
}

TEST_F(ClipPlayerTest, PipelineSkipsNothingAndGoesOnAfterALateFrame) {
    play(Scheme::pipeline);
    Gate gate(pool);
    idle.wait();
    gate.shut();
    for (int i = 0; i < 8; ++i) cycle(i, Policy::skip);
    EXPECT_GT(player->misses(), 0u);
    gate.open();
    int last = -1;
    for (int i = 8; i < 16; ++i) {
        idle.wait();
        last = cycle(i, Policy::skip);
    }
    EXPECT_GE(last, 7) << "it is not stuck at the frame that was late";
}

TEST_F(ClipPlayerTest, SkipShowsOneFrameForTwoCyclesWhereTheDisplayIsLate) {
    std::vector<int> order;
    std::vector<std::uint64_t> sent;
    for (int i = 0; i < 16; ++i) {  // each cycle takes two frames' time
        idle.wait();
        const std::uint64_t before = times.uploaded;
        order.push_back(cycle(2 * i % frames, Policy::skip));
        sent.push_back(times.uploaded - before);
    }
    EXPECT_THAT(std::vector(order.begin() + 8, order.end()), testing::ElementsAre(14, 18, 18, 22, 22, 1, 1, 5));
    EXPECT_THAT(std::vector(sent.begin() + 8, sent.end()), testing::ElementsAre(1, 0, 1, 0, 1, 0, 1, 0));
    EXPECT_EQ(times.wait, 0.0);
}

TEST_F(ClipPlayerTest, SkipShowsSomethingNewHoweverSlowTheDecoderIs) {
    Gate gate(pool);
    idle.wait();
    std::set<int> seen;
    for (int i = 0; i < 60; ++i) {
        gate.shut();
        seen.insert(cycle(i % frames, Policy::skip));
        if (i % 5 != 0) continue;
        gate.open();  // a little decoding in every fifth cycle
        idle.wait();
    }
    EXPECT_GE(seen.size(), 6u);
    EXPECT_EQ(seen.count(-1), 0u);
}

TEST_F(ClipPlayerTest, BufferingDecodesEachFrameOnceIntoMemoryThatItGivesBack) {
    for (int i = 0; i < 2 * frames; ++i) ASSERT_EQ(cycle(i % frames, Policy::wait), i % frames) << i;
    idle.wait();
    EXPECT_LE(player->work().decoded, 2u * frames + 2 + buffers) << "what has been sent is not decoded again";
    EXPECT_LE(times.uploaded, 2u * frames + 2) << "nor is it sent again";
    const std::size_t bytes = file->format.bytes();
    EXPECT_EQ(player->memory(), (buffers + 1 + 4) * bytes) << "decoded ahead, one on its way, four sent";
    player->set_buffers(2);
    EXPECT_EQ(player->memory(), (2 + 1 + 4) * bytes);
    for (int i = 0; i < frames; ++i) ASSERT_EQ(cycle(i, Policy::wait), i);
    EXPECT_EQ(player->memory(), (2 + 1 + 4) * bytes);
    idle.wait();
    Gate gate(pool);
    gate.shut();
    player->set_buffers(buffers);
    EXPECT_EQ(player->memory(), (buffers + 1 + 4) * bytes) << "at once, before anything is decoded to it";
    gate.open();
    for (int i = 0; i < frames; ++i) ASSERT_EQ(cycle(i, Policy::wait), i);
    idle.wait();
    EXPECT_EQ(player->memory(), (buffers + 1 + 4) * bytes);
}

/// Replaces glUnmapNamedBuffer while it lives: the driver loses the unmapped data `losses` times.
class LossyDriver {
  public:
    explicit LossyDriver(int losses) {
        left = losses;
        unmap = glad_glUnmapNamedBuffer;
        glad_glUnmapNamedBuffer = [](GLuint buffer) -> GLboolean {
            const GLboolean kept = unmap(buffer);
            return left-- > 0 ? GLboolean{GL_FALSE} : kept;
        };
    }
    ~LossyDriver() { glad_glUnmapNamedBuffer = unmap; }
    LossyDriver(const LossyDriver&) = delete;
    LossyDriver& operator=(const LossyDriver&) = delete;

  private:
    static inline int left = 0;
    static inline PFNGLUNMAPNAMEDBUFFERPROC unmap = nullptr;
};

TEST_F(ClipPlayerTest, WhatTheDriverLosesIsDecodedAgainWhereItIsWaitedFor) {
    EXPECT_EQ(cycle(0, Policy::wait), 0);
    {
        const LossyDriver driver(2);
        EXPECT_EQ(shown(10, Policy::wait), 10);
    }
    player->end_cycle(cycles++, times);
    EXPECT_EQ(cycle(11, Policy::wait), 11);
    EXPECT_EQ(player->misses(), 0u);
    {
        const LossyDriver driver(1000);
        EXPECT_EQ(shown(20, Policy::wait), 11) << "not tried for ever";
        EXPECT_EQ(player->misses(), 1u);
    }
    player->end_cycle(cycles++, times);
    EXPECT_EQ(cycle(21, Policy::wait), 21);
}

TEST_F(ClipPlayerTest, AfterAJumpTheRightFrameComesWithoutWaitingForItsTurn) {
    for (int i = 0; i < 4; ++i) cycle(i, Policy::wait);
    EXPECT_EQ(shown(20, Policy::wait), 20);
    player->end_cycle(cycles++, times);
    EXPECT_EQ(cycle(21, Policy::wait), 21);
}

}  // namespace
}  // namespace lapfx::media
