#include "app/preview/scene_pace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace lapfx::app {
namespace {

/// A window in simulated time: frames of the UI one after the other, the scene in some of them, an input every 8 ms.
struct Played {
    int frames = 0, scenes = 0;
    double longest = 0;  ///< s from an input to the end of the frame that shows it, once the first 1 s has passed
    double smallest = 1;
};

Played play(ScenePace& pace, double seconds, const std::function<double(double)>& cost, double ui = 0.01) {
    Played played;
    double now = 100, waiting = 100;  // since the oldest input that is not on the screen
    const double begin = now;
    while (now < begin + seconds) {
        const double input = waiting;
        const double frame = now;
        pace.touch(frame);
        if (pace.due(frame)) {
            const double scale = pace.scale(frame);
            now += cost(scale);
            pace.drawn(frame, now);
            ++played.scenes;
            played.smallest = std::min(played.smallest, scale);
        }
        now += ui;
        ++played.frames;
        waiting = frame + 0.008;  // the next movement arrived while this one was drawn
        if (frame > begin + 1) played.longest = std::max(played.longest, now - input);
    }
    return played;
}

TEST(ScenePace, PanelsDoNotWaitForASlowScene) {
    ScenePace pace;
    const Played played = play(pace, 5, [](double scale) { return 0.5 * scale * scale; });
    EXPECT_GT(played.frames, 20 * 5) << "the panels go on";
    EXPECT_LT(played.longest, 0.1);
    EXPECT_GT(played.scenes, 5 * 5) << "and so does the scene";
    EXPECT_LT(played.smallest, 0.36);
}

TEST(ScenePace, WhatFewerPixelsDoNotMakeFasterGetsATurnNowAndThen) {
    ScenePace pace;
    const Played played = play(pace, 20, [](double) { return 0.3; });
    EXPECT_GT(played.frames, 20 * 20 / 0.9 * 0.6) << "two thirds of the time are the panels'";
    EXPECT_GT(played.scenes, 20);
    EXPECT_LT(played.scenes, 20 / 0.3 / 2);
}

TEST(ScenePace, AFastSceneIsDrawnWhole) {
    ScenePace pace;
    const Played played = play(pace, 2, [](double scale) { return 0.008 * scale * scale; });
    EXPECT_EQ(played.smallest, 1);
    EXPECT_FALSE(pace.whole_at() < 1e9);
}

TEST(ScenePace, AtRestItIsDrawnWholeAgain) {
    ScenePace pace;
    EXPECT_TRUE(pace.due(0)) << "nobody works";
    EXPECT_EQ(pace.scale(0), 1);
    pace.expect(0.5);
    pace.touch(10);
    EXPECT_LT(pace.scale(10), 0.36) << "already the first one makes room";
    pace.drawn(10, 10.03);
    EXPECT_FALSE(pace.due(10.04)) << "half of the time";
    EXPECT_TRUE(pace.due(10.061));
    EXPECT_NEAR(pace.whole_at(), 10 + ScenePace::rest, 1e-12);
    EXPECT_LT(pace.scale(10.29), 1);
    EXPECT_EQ(pace.scale(10.31), 1);
    EXPECT_TRUE(pace.due(10.31));
    pace.drawn(10.31, 10.8);
    EXPECT_GT(pace.whole_at(), 1e9) << "it is";
    pace.touch(11);
    EXPECT_LT(pace.scale(11), 0.36) << "what was learned is kept";
    EXPECT_TRUE(pace.due(11));
}

TEST(ScenePace, TellsWhenItsTurnComes) {
    ScenePace pace;
    EXPECT_EQ(pace.due_at(0), 0) << "at once";
    pace.touch(10);
    pace.drawn(10, 10.1);
    pace.touch(10.15);
    EXPECT_FALSE(pace.due(10.15));
    EXPECT_NEAR(pace.due_at(10.15), 10.2, 1e-12) << "after as much time as it took";
    EXPECT_FALSE(pace.due(10.16));
    EXPECT_TRUE(pace.due(pace.due_at(10.16)));
    pace.drawn(10.2, 11.2);
    EXPECT_TRUE(pace.due(11.2)) << "nobody works any more";
    pace.touch(11.25);
    pace.drawn(11.25, 12.25);
    pace.touch(12.3);
    EXPECT_NEAR(pace.due_at(12.3), 12.3 + ScenePace::rest, 1e-12) << "at rest it does not wait for its turn";
}

TEST(ScenePace, WhatIsNotSeenAnyMoreIsNotWaitedFor) {
    ScenePace pace;
    pace.expect(0.5);
    pace.touch(10);
    pace.drawn(10, 10.03);
    pace.left_out(10.1);
    EXPECT_NEAR(pace.whole_at(), 10 + ScenePace::rest, 1e-12) << "as long as a person works it may come back";
    pace.left_out(10.31);
    EXPECT_GT(pace.whole_at(), 1e9);
}

}  // namespace
}  // namespace lapfx::app
