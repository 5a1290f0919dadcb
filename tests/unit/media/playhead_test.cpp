#include "media/playhead.h"

#include <gtest/gtest.h>

namespace lapfx::media {
namespace {

/// `count` frames, `fps` a second.
ClipInfo clip(int count, double fps) {
    ClipInfo info;
    for (int i = 0; i < count; ++i) info.times.push_back(i / fps);
    info.duration = count / fps;
    return info;
}

SmokeClip from_the_beginning() {
    return {.file = "a.mp4", .start = ClipStart::beginning};
}

TEST(Playhead, ShowsEveryFrameOnceInALoopAndStartsOver) {
    const ClipInfo info = clip(50, 30.0);
    for (int i = 0; i < 500; ++i) EXPECT_EQ(playhead(info, from_the_beginning(), 0, i / 30.0).frame, i % 50) << i;
    EXPECT_EQ(playhead(info, from_the_beginning(), 0, -1.0 / 30.0).frame, 49) << "before 0 it plays too";
    EXPECT_EQ(main_loop(info, from_the_beginning()), (Loop{0, 49}));
}

TEST(Playhead, SpeedInAndOut) {
    const ClipInfo info = clip(100, 25.0);
    SmokeClip settings = from_the_beginning();
    settings.speed = 2.0;
    settings.in = 1.0;
    settings.out = 2.0;
    EXPECT_EQ(main_loop(info, settings), (Loop{25, 49}));
    EXPECT_EQ(playhead(info, settings, 0, 0.0).frame, 25);
    EXPECT_EQ(playhead(info, settings, 0, 0.2).frame, 35);
    EXPECT_EQ(playhead(info, settings, 0, 0.5).frame, 25);
    settings.in = 1e3;
    settings.out = 0.0;
    EXPECT_EQ(playhead(info, settings, 0, 5.0).frame, 99) << "beyond the end is the end";
}

TEST(Playhead, CrossFadeLaysTheEndOverTheBeginning) {
    const ClipInfo info = clip(100, 25.0);  // 4 s
    SmokeClip settings = from_the_beginning();
    settings.crossfade = 1.0;
    const Playhead start = playhead(info, settings, 0, 0.0);
    EXPECT_EQ(start.frame, 0);
    EXPECT_EQ(start.fading, 75);
    EXPECT_NEAR(start.fade, 1.0, 1e-5);
    const Playhead half = playhead(info, settings, 0, 0.52);
    EXPECT_EQ(half.frame, 13);
    EXPECT_EQ(half.fading, 88);
    EXPECT_NEAR(half.fade, 0.48, 1e-5);
    EXPECT_EQ(playhead(info, settings, 0, 1.0).fading, -1);
    // At the jump, the last frame of the loop precedes the frame that fades at full strength, so nothing jumps.
    EXPECT_EQ(playhead(info, settings, 0, 2.96).frame, 74);
    EXPECT_EQ(playhead(info, settings, 0, 3.0).fading, 75);
    EXPECT_EQ(main_loop(info, settings), (Loop{0, 74}));
    EXPECT_EQ(fading_loop(info, settings), (Loop{75, 99}));
    settings.crossfade = 30.0;  // a crossfade is at most half
    EXPECT_EQ(main_loop(info, settings), (Loop{0, 49}));
}

TEST(Playhead, TheLoopsHoldEveryFrameThatIsShown) {
    ClipInfo info = clip(37, 23.976);
    info.times[20] += 0.01;  // an uneven frame
    for (const double fade : {0.0, 0.3})
        for (const double in : {0.0, 0.31})
            for (const double out : {0.0, 1.2}) {
                SmokeClip settings{.file = "a.mp4", .speed = 1.3, .in = in, .out = out, .crossfade = fade};
                const Loop first = main_loop(info, settings), second = fading_loop(info, settings);
                for (int i = 0; i < 700; ++i) {
                    const Playhead head = playhead(info, settings, 0x9e3779b9u, i * 0.0173);
                    ASSERT_TRUE(head.frame >= first.first && head.frame <= first.last) << head.frame;
                    if (head.fading < 0) continue;
                    ASSERT_TRUE(head.fading >= second.first && head.fading <= second.last) << head.fading;
                }
            }
}

TEST(Playhead, ChanceSetsWhereASeededClipStarts) {
    const ClipInfo info = clip(100, 25.0);
    EXPECT_EQ(playhead(info, {.file = "a"}, 0x80000000u, 0.0).frame, 50);
    EXPECT_EQ(playhead(info, {.file = "a"}, 0u, 0.0).frame, 0);
    EXPECT_EQ(playhead(info, from_the_beginning(), 0x80000000u, 0.0).frame, 0);
}

TEST(Playhead, OneFrameAndNoLength) {
    ClipInfo still;
    still.times = {0.0};
    EXPECT_EQ(playhead(still, {.file = "a.png", .crossfade = 1.0}, 77, 12.3).frame, 0);
    EXPECT_EQ(main_loop(still, {.file = "a.png"}), (Loop{0, 0}));
}

TEST(Loop, GoesRoundAndComesIn) {
    const Loop loop{3, 5};
    EXPECT_EQ(loop.after(3), 4);
    EXPECT_EQ(loop.after(5), 3);
    EXPECT_EQ(loop.after(0), 3);
    EXPECT_EQ(loop.after(9), 3);
}

}  // namespace
}  // namespace lapfx::media
