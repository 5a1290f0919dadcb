#include "media/clip_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <numeric>
#include <random>
#include <thread>

#include "media/clip_player.h"
#include "media/schemes.h"
#include "support/clips.h"
#include "support/folders.h"
#include "support/gpu_test.h"
#include "support/open_files.h"
#include "support/wait_until.h"
#include "unit/preset/support.h"

namespace lapfx::media {
namespace {

constexpr int frames = 12;
constexpr glm::ivec2 size{64, 48};

/// Mean code value of the layer of luma or RGB that a frame names.
double level(const ClipFrame& frame) {
    const bool planar = frame.format.layout == Layout::planar;
    const std::size_t bytes = frame.format.color_bytes();
    std::vector<std::uint8_t> pixels(bytes);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureSubImage(frame.color, 0, 0, 0, frame.layer, frame.format.size.x, frame.format.size.y, 1,
                         planar ? GL_RED : GL_RGB, GL_UNSIGNED_BYTE, static_cast<GLsizei>(bytes), pixels.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    return std::accumulate(pixels.begin(), pixels.end(), 0.0) / static_cast<double>(bytes);
}

class ClipSetTest : public test::GpuTest, public testing::WithParamInterface<Scheme> {
  protected:
    test::Folder folder;
    void SetUp() override {
        GpuTest::SetUp();
        for (const char* name : {"a.avi", "b.avi", "c.avi"}) test::write_clip(folder / name, frames);
    }
    static std::vector<SmokeClip> clips(std::initializer_list<const char*> names, double crossfade = 0.0) {
        std::vector<SmokeClip> all;
        for (const char* name : names)
            all.push_back({.file = name, .crossfade = crossfade, .start = ClipStart::beginning});
        return all;
    }
    void set(ClipSet& set, const std::vector<SmokeClip>& clips) { set.set(clips, folder.path(), {}); }
    static int shown(ClipSet& set, std::size_t clip, int index, Policy policy = Policy::wait, int head = 0) {
        return test::number_of_level(level(set.frame(clip, head, index, policy)));
    }
    /// Plays one loop of every clip.
    static void play(ClipSet& set, int loops = 1) {
        for (int i = 0; i < loops * frames; ++i) {
            for (std::size_t clip = 0; clip < set.size(); ++clip) ASSERT_EQ(shown(set, clip, i % frames), i % frames);
            set.end_cycle();
        }
    }
    static std::size_t frame_bytes() { return PictureFormat{.size = size}.bytes(); }
};

TEST_P(ClipSetTest, ShowsTheFrameThatIsAskedForInAnyOrder) {
    ClipSet set({.scheme = GetParam()});
    this->set(set, clips({"a.avi", "b.avi", "a.avi"}));
    play(set, 2);
    std::mt19937 random(7);
    for (int i = 0; i < 60; ++i) {
        for (std::size_t clip = 0; clip < set.size(); ++clip) {
            const int index = static_cast<int>(random() % frames);
            ASSERT_EQ(shown(set, clip, index), index);
        }
        set.end_cycle();
    }
    for (const ClipStatus& clip : set.status()) EXPECT_EQ(clip.misses, 0u);
}

TEST_P(ClipSetTest, CrossFadesFromTwoPlacesAtOnce) {
    ClipSet set({.scheme = GetParam()});
    this->set(set, clips({"a.avi"}, 0.2));  // 4 frames at 20 a second
    for (int i = 0; i < 3 * frames; ++i) {
        const int at = i % 8;
        ASSERT_EQ(shown(set, 0, at), at);
        if (at < 4) {
            ASSERT_EQ(shown(set, 0, 8 + at, Policy::wait, 1), 8 + at);
        }
        set.end_cycle();
    }
}

TEST_P(ClipSetTest, LatestNeverWaitsAndShowsNothingBeforeThereIsSomething) {
    ClipSet set({.scheme = GetParam()});
    this->set(set, clips({"a.avi"}));
    int in_time = 0, late = 0, i = 0;
    const auto cycle = [&] {
        const int index = i++ % frames;
        const ClipFrame frame = set.frame(0, 0, index, Policy::latest);
        if (frame.color == 0) {
            ASSERT_EQ(in_time, 0) << "what was shown once stays";
            ++late;
        } else {
            const int number = test::number_of_level(level(frame));
            ASSERT_TRUE(number >= 0 && number < frames);
            number == index ? ++in_time : ++late;
        }
        set.end_cycle();
    };
    EXPECT_TRUE(test::wait_until([&] { return in_time == 100 || HasFatalFailure(); }, cycle))
        << "frames this small are there in time, if not always on a busy machine";
    EXPECT_EQ(set.times().wait, 0.0);
    EXPECT_EQ(set.status()[0].misses, static_cast<std::uint64_t>(late));
}

TEST_P(ClipSetTest, ClipsComeAndGoWhileOthersPlay) {
    ClipSet set({.scheme = GetParam()});
    for (int i = 0; i < 12; ++i) {
        this->set(set, i % 3 == 0   ? clips({"a.avi", "b.avi"})
                       : i % 3 == 1 ? clips({"b.avi"})
                                    : clips({"c.avi", "b.avi", "a.avi"}));
        for (std::size_t clip = 0; clip < set.size(); ++clip) set.frame(clip, 0, i % frames, Policy::latest);
        set.end_cycle();
        ASSERT_EQ(shown(set, 0, i % frames), i % frames);
    }
    this->set(set, {});
    EXPECT_EQ(set.size(), 0u);
    set.end_cycle();
}

TEST_P(ClipSetTest, AClipThatCannotBeUsedLeavesTheOthersPlaying) {
    ClipSet set({.scheme = GetParam()});
    this->set(set, clips({"a.avi"}));
    EXPECT_THAT(test::faults_of([&] {
                    this->set(set, clips({"b.avi", "none.avi"}));
                }),
                testing::ElementsAre(testing::HasSubstr("none.avi: no such clip")));
    ASSERT_EQ(set.size(), 1u);
    play(set);
}

std::vector<Scheme> all_schemes() {
    std::vector<Scheme> all;
    for (const SchemeRow& row : scheme_rows) all.push_back(row.scheme);
    return all;
}
INSTANTIATE_TEST_SUITE_P(Schemes, ClipSetTest, testing::ValuesIn(all_schemes()));

using ClipSetOnce = ClipSetTest;

/// All bytes of the picture that a frame names.
std::vector<std::uint8_t> pixels(const ClipFrame& frame) {
    std::vector<std::uint8_t> all(frame.format.color_bytes());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureSubImage(frame.color, 0, 0, 0, frame.layer, frame.format.size.x, frame.format.size.y, 1, GL_RGB,
                         GL_UNSIGNED_BYTE, static_cast<GLsizei>(all.size()), all.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    return all;
}

void wait_for_decoded(const ClipSet& set, std::uint64_t count) {
    ASSERT_TRUE(test::wait_until([&] { return set.times().decoded >= count; })) << "decoding stands still";
}

/// Waits until each of `clips` has decoded ahead into all of its buffers.
void wait_for_decoding(const ClipSet& set, int clips) {
    const int buffers = std::clamp(64 / clips, 2, 8);
    wait_for_decoded(set, set.times().uploaded + static_cast<std::uint64_t>(clips * buffers));
}

TEST_F(ClipSetOnce, PipelineSendsEveryFrameInItsCycle) {
    ClipSet set({.scheme = Scheme::pipeline});
    this->set(set, clips({"a.avi", "b.avi"}));
    for (int i = 0; i < frames; ++i) {
        shown(set, 0, i);
        shown(set, 1, i);
        EXPECT_EQ(set.times().uploaded, static_cast<std::uint64_t>(2 * (i + 1))) << "before it is drawn";
        set.end_cycle();
        EXPECT_EQ(set.times().uploaded, static_cast<std::uint64_t>(2 * (i + 1))) << "and nothing after it";
    }
}

// Table 1 and figure 5: two frames of a clip in one cycle, none in the next.
TEST_F(ClipSetOnce, BufferedSendsTwoFramesInEverySecondCycleEvenlyOverItsClips) {
    for (const Policy policy : {Policy::wait, Policy::latest, Policy::skip})
        for (int count = 1; count <= 15; ++count) {
            ClipSet set({.scheme = Scheme::buffered});
            this->set(set, std::vector<SmokeClip>(static_cast<std::size_t>(count), clips({"a.avi"})[0]));
            const auto half = static_cast<std::uint64_t>(count / 2), rest = static_cast<std::uint64_t>(count) - half;
            for (int i = 0; i < frames; ++i) {
                wait_for_decoding(set, count);
                const std::uint64_t before = set.times().uploaded;
                for (std::size_t clip = 0; clip < set.size(); ++clip) ASSERT_EQ(shown(set, clip, i, policy), i);
                const std::uint64_t drawing = set.times().uploaded;
                set.end_cycle();
                EXPECT_EQ(drawing - before, i == 0 ? rest + half : 0u) << "nothing is sent before it is drawn";
                const std::uint64_t first = 2 * rest + half, sent = 2 * (i % 2 == 0 ? rest : half);
                EXPECT_EQ(set.times().uploaded - drawing, i == 0 ? first : sent) << count << " clips, cycle " << i;
            }
            EXPECT_EQ(set.times().wait, 0.0);
        }
}

TEST_F(ClipSetOnce, BothPlacesOfACrossFadeTakeTurns) {
    ClipSet set({.scheme = Scheme::buffered});
    this->set(set, clips({"a.avi"}, 0.2));  // 4 frames: 0 to 3 under 8 to 11
    for (int i = 0; i < 3; ++i) {
        wait_for_decoded(set, 8 + 4);  // all frames of both
        shown(set, 0, i);
        shown(set, 0, 8 + i, Policy::wait, 1);
        const std::uint64_t before = set.times().uploaded;
        set.end_cycle();
        EXPECT_EQ(set.times().uploaded - before, i == 0 ? 3u : 2u) << i;
    }
}

TEST_F(ClipSetOnce, WhileNothingIsLateEveryPolicyShowsTheBytesOfThePipeline) {
    ClipSet pipeline({.scheme = Scheme::pipeline});
    this->set(pipeline, clips({"a.avi"}));
    for (const Policy policy : {Policy::latest, Policy::skip}) {
        ClipSet buffered({.scheme = Scheme::buffered});
        this->set(buffered, clips({"a.avi"}));
        for (int i = 0; i < 2 * frames; ++i) {
            wait_for_decoding(buffered, 1);
            EXPECT_EQ(pixels(buffered.frame(0, 0, i % frames, policy)),
                      pixels(pipeline.frame(0, 0, i % frames, Policy::wait)));
            buffered.end_cycle();
            pipeline.end_cycle();
        }
        EXPECT_EQ(buffered.status()[0].misses, 0u);
    }
}

TEST_F(ClipSetOnce, AClipThatPlaysSlowerThanTheDisplayStillGoesTwoFramesAtATime) {
    ClipSet set({.scheme = Scheme::buffered});
    this->set(set, clips({"a.avi"}));
    std::vector<std::uint64_t> sent;
    for (int i = 0; i < 2 * frames; ++i) {  // each frame for two cycles
        wait_for_decoding(set, 1);
        const std::uint64_t before = set.times().uploaded;
        ASSERT_EQ(shown(set, 0, i / 2), i / 2);
        EXPECT_EQ(set.times().uploaded - before, i == 0 ? 1u : 0u);
        set.end_cycle();
        sent.push_back(set.times().uploaded - before);
    }
    EXPECT_THAT(std::vector(sent.begin() + 3, sent.begin() + 15),
                testing::ElementsAre(0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2));
}

TEST_F(ClipSetOnce, ResidentSendsEachFrameOnceAndThenNothing) {
    const std::ptrdiff_t before = test::open_files();
    ClipSet set({.scheme = Scheme::resident});
    this->set(set, clips({"a.avi", "a.avi"}));
    play(set);
    EXPECT_EQ(set.status()[0].resident, frames);
    // A frame may still be being decoded. Decoders that have nothing more to do close their files, and only then.
    ASSERT_TRUE(test::wait_until([before] { return test::open_files() == before; }));
    const StreamingTimes whole = set.times();
    EXPECT_EQ(whole.uploaded, static_cast<std::uint64_t>(frames)) << "two clips of one file share its frames";
    play(set, 3);
    EXPECT_EQ(set.times().uploaded, whole.uploaded);
    EXPECT_EQ(set.times().upload, whole.upload);
    EXPECT_EQ(set.times().decoded, whole.decoded);
}

TEST_F(ClipSetOnce, AJumpingClipBecomesResidentToo) {
    ClipSet set({.scheme = Scheme::resident});
    this->set(set, clips({"a.avi"}));
    int i = 0;
    const auto cycle = [&] {
        shown(set, 0, i++ * 4 % frames);  // only every fourth frame is shown
        set.end_cycle();
    };
    EXPECT_TRUE(test::wait_until([&] { return set.status()[0].resident == frames; }, cycle));
}

TEST_F(ClipSetOnce, MemoryGoesToWholeClipsInTheirOrder) {
    // Two buffers for each of three clips, one whole clip, and the frames of the other two on the GPU or on the way
    // there.
    const std::size_t room = (3 * 3 + frames + 2 * 6) * frame_bytes();
    ClipSet set({.scheme = Scheme::resident, .memory = room});
    this->set(set, clips({"a.avi", "b.avi", "c.avi"}));
    play(set, 2);
    const auto status = set.status();
    EXPECT_EQ(status[0].resident, frames);
    EXPECT_EQ(status[0].warning, "");
    for (const std::size_t i : {1u, 2u}) {
        EXPECT_EQ(status[i].resident, 0);
        EXPECT_THAT(status[i].warning, testing::HasSubstr("does not fit into the memory"));
    }
    std::size_t used = 0;
    for (const ClipStatus& clip : status) used += clip.memory;
    EXPECT_LE(used, room);
}

TEST_F(ClipSetOnce, WithTooLittleMemoryEverythingStillPlays) {
    ClipSet set({.scheme = Scheme::resident, .memory = 1});
    this->set(set, clips({"a.avi", "b.avi"}));
    play(set, 2);
    for (const ClipStatus& clip : set.status())
        EXPECT_LE(clip.memory, 9 * frame_bytes()) << "two buffers, one to read from, four sent, two on their way";
}

TEST_F(ClipSetOnce, AClipThatComesBackIsStillThereAndTheOldestGoesFirst) {
    // One that plays, and one that is kept.
    const std::size_t room = head_memory({.size = size}, Scheme::resident, 8) + (2 * frames + 1) * frame_bytes();
    ClipSet set({.scheme = Scheme::resident, .memory = room, .kept_memory = room});
    for (const char* name : {"a.avi", "b.avi"}) {
        this->set(set, clips({name}));
        play(set);
    }
    const auto sent = set.times().uploaded;
    this->set(set, clips({"a.avi"}));
    EXPECT_EQ(set.status()[0].resident, frames) << "kept for when it comes back";
    play(set);
    EXPECT_EQ(set.times().uploaded, sent);
    this->set(set, clips({"c.avi"}));  // a was drawn last, so b goes
    play(set);
    this->set(set, clips({"a.avi"}));
    EXPECT_EQ(set.status()[0].resident, frames);
    this->set(set, clips({"b.avi"}));
    EXPECT_EQ(set.status()[0].resident, 0);
}

TEST_F(ClipSetOnce, AClipThatLeavesThePresetLeavesTheMemory) {
    ClipSet set({.scheme = Scheme::resident});
    this->set(set, clips({"a.avi"}));
    play(set);
    const std::size_t one = set.memory();
    EXPECT_EQ(one, frames * frame_bytes()) << "resting, it has its frames and nothing else";
    for (const char* other : {"b.avi", "c.avi"}) {
        this->set(set, clips({"a.avi", other}));
        play(set);
        EXPECT_EQ(set.memory(), 2 * one);
        this->set(set, clips({"a.avi"}));
        EXPECT_EQ(set.memory(), one) << other;
    }
    const auto sent = set.times().uploaded;
    play(set);
    EXPECT_EQ(set.times().uploaded, sent) << "what stayed was not decoded again";
    this->set(set, {});
    EXPECT_EQ(set.memory(), 0u);
}

TEST_F(ClipSetOnce, WhatIsKeptForLaterIsBounded) {
    const std::size_t clip = frames * frame_bytes();
    ClipSet set({.scheme = Scheme::resident, .kept_memory = clip});
    for (const char* name : {"a.avi", "b.avi", "c.avi"}) {
        this->set(set, clips({name}));
        play(set);
    }
    EXPECT_EQ(set.memory(), 2 * clip) << "c plays, b is kept";
}

TEST_F(ClipSetOnce, AnotherFileUnderTheSameNameIsAnotherClip) {
    ClipSet set({.scheme = Scheme::resident});
    this->set(set, clips({"a.avi"}));
    play(set);
    test::write_clip(folder / "a.avi", 5);
    std::filesystem::last_write_time(folder / "a.avi",
                                     std::filesystem::file_time_type::clock::now() + std::chrono::hours(1));
    this->set(set, clips({"a.avi"}));
    EXPECT_EQ(set.info(0).frame_count(), 5);
}

TEST_F(ClipSetOnce, InAndOutChangeWhatIsKept) {
    ClipSet set({.scheme = Scheme::resident});
    std::vector<SmokeClip> part = clips({"a.avi"});
    part[0].out = 0.2;  // 4 frames
    this->set(set, part);
    for (int i = 0; i < 12; ++i) {
        ASSERT_EQ(shown(set, 0, i % 4), i % 4);
        set.end_cycle();
    }
    EXPECT_EQ(set.status()[0].resident, 4);
    this->set(set, clips({"a.avi"}));
    play(set);
    EXPECT_EQ(set.status()[0].resident, frames);
}

TEST_F(ClipSetOnce, AShorterLoopGivesMemoryBack) {
    const std::filesystem::path samples = test::source_folder() / "samples/clips";
    std::vector<SmokeClip> one = clips({"plume_thick.mp4"});  // 150 frames, 30 a second
    ClipSet set({.scheme = Scheme::resident});
    set.set(one, samples, {});
    for (int i = 0; i < set.info(0).frame_count(); ++i) {
        set.frame(0, 0, i, Policy::wait);
        set.end_cycle();
    }
    const std::size_t bytes = PictureFormat{.size = set.info(0).size}.bytes();
    EXPECT_EQ(set.status()[0].resident, 150);
    EXPECT_GE(set.status()[0].memory, 150 * bytes);
    one[0].in = 2.2;  // frames 66 to 89: memory is kept in steps of 32
    one[0].out = 3.0;
    set.set(one, samples, {});
    EXPECT_EQ(set.status()[0].resident, 32);
    EXPECT_LE(set.status()[0].memory, 45 * bytes);
    set.frame(0, 0, 70, Policy::wait);
    EXPECT_EQ(set.times().uploaded, 150u) << "what is still played is still there";
}

TEST_F(ClipSetOnce, FramesOfOneFileCountOnce) {
    ClipSet set({.scheme = Scheme::resident});
    this->set(set, clips({"a.avi", "a.avi"}));
    play(set);
    EXPECT_GE(set.status()[0].memory, frames * frame_bytes());
    EXPECT_LT(set.status()[1].memory, frames * frame_bytes());
}

TEST_F(ClipSetOnce, OneMoreClipLeavesTheOthersPlaying) {
    ClipSet set({.scheme = Scheme::buffered_planar});
    std::vector<SmokeClip> eight(8, clips({"a.avi"})[0]);
    this->set(set, eight);
    play(set);
    wait_for_decoding(set, 8);
    const auto decoded = set.times().decoded;  // all buffers are full
    eight.push_back(clips({"b.avi"})[0]);      // 64 / 9 buffers each instead of 64 / 8
    this->set(set, eight);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_NE(set.frame(i, 0, frames - 1, Policy::latest).color, 0u) << i << " shows what it showed";
    }
    wait_for_decoded(set, decoded + 7);
    // What must not come gets half a second for it: on a busy machine less of it is found, and nothing else.
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    EXPECT_EQ(set.times().decoded, decoded + 7) << "the buffers of the new clip, and no other";
}

TEST_F(ClipSetOnce, OneFileWithTwoLoopsIsPaidForBoth) {
    // Two buffers for each of two clips, and almost the whole clip.
    const std::size_t room = (2 * 3 + frames - 1) * frame_bytes();
    ClipSet set({.scheme = Scheme::resident, .memory = room});
    std::vector<SmokeClip> two = clips({"a.avi", "a.avi"});
    two[0].out = 0.1;
    this->set(set, two);
    for (const ClipStatus& clip : set.status()) EXPECT_THAT(clip.warning, testing::HasSubstr("does not fit"));
}

TEST_F(ClipSetOnce, AResidentClipPlaysOnWhenItsFileHasGone) {
    ClipSet set({.scheme = Scheme::resident});
    this->set(set, clips({"a.avi"}));
    play(set);
    std::filesystem::remove(folder / "a.avi");
    play(set, 2);
}

}  // namespace
}  // namespace lapfx::media
