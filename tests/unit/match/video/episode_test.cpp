#include "match/video/episode.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "match/frame/estimator.h"

namespace lapfx::match {
namespace {

std::vector<FrameAmounts> frames_of(const std::function<double(double)>& smoke, double seconds = 10,
                                    double error = 0.01) {
    std::vector<FrameAmounts> frames;
    for (double time = 0; time <= seconds + 1e-9; time += 0.04) {
        const double value = smoke(time);
        FrameAmounts& f = frames.emplace_back();
        f.time = time;
        f.veil = {value, value - error, value + error};
    }
    return frames;
}

/// 0 until 2 s, to 0.5 at 4 s, 0 again at 8 s.
double tent(double time) {
    if (time < 2 || time > 8) return 0;
    return time < 4 ? 0.25 * (time - 2) : 0.125 * (8 - time);
}

TEST(Episode, OfATentIsAsDrawn) {
    const Episode e = episode_of(frames_of(tent), Curve::veil);
    EXPECT_NEAR(*e.peak, 0.5, 0.02);
    EXPECT_NEAR(*e.peak_at, 4.0, 0.1);
    EXPECT_NEAR(*e.onset, 2.2, 0.05);       // 10 % of the way
    EXPECT_NEAR(*e.rise, 0.8 * 2.0, 0.08);  // 10 % to 90 %
    EXPECT_NEAR(*e.decay, 2.0, 0.1);        // half of the way down
    EXPECT_NEAR(*e.area, 0.5 * 6.0 * 0.5, 0.01);
    EXPECT_NEAR(*e.mean, *e.area / 10.0, 1e-3);
}

TEST(Episode, ThatNeverFallsHasNoDecay) {
    const Episode e = episode_of(frames_of([](double time) { return 0.05 * time; }), Curve::veil);
    EXPECT_FALSE(e.decay);
    EXPECT_TRUE(e.onset);
}

TEST(Episode, WithinTheErrorOfMeasuringIsNone) {
    const auto wobble = [](double time) { return 0.1 + 0.004 * std::sin(3 * time); };
    const Episode e = episode_of(frames_of(wobble), Curve::veil);
    EXPECT_FALSE(e.peak_at);
    EXPECT_FALSE(e.onset);
    EXPECT_NEAR(*e.mean, 0.1, 0.002);
}

TEST(Episode, IsNoneWhereTheIntervalsOfFloorAndPeakOverlap) {
    EXPECT_TRUE(episode_of(frames_of(tent, 10, 0.2), Curve::veil).peak_at);
    const Episode e = episode_of(frames_of(tent, 10, 0.3), Curve::veil);
    EXPECT_FALSE(e.peak_at);
    EXPECT_FALSE(e.onset);
    EXPECT_NEAR(*e.peak, 0.5, 0.02) << "the amount itself is told";
}

TEST(Episode, IsToldByTheIntervalsOfItsOwnFloorAndPeak) {
    // Dense smoke is less sure than none.
    std::vector<FrameAmounts> frames = frames_of(tent);
    for (FrameAmounts& f : frames) {
        f.veil.low = std::max(f.veil.value - 0.02 - 0.7 * f.veil.value, 0.0);
        f.veil.high = f.veil.value + 0.02 + 0.7 * f.veil.value;
    }
    EXPECT_NEAR(*episode_of(frames, Curve::veil).peak_at, 4.0, 0.1);
    for (FrameAmounts& f : frames) f.veil.high += 0.15;
    EXPECT_FALSE(episode_of(frames, Curve::veil).peak_at) << "the floor may be as high as the peak may be low";
}

TEST(Episode, ThatFallsFromTheStartHasNoOnset) {
    const Episode e = episode_of(frames_of([](double time) { return 0.5 - 0.05 * time; }), Curve::veil);
    EXPECT_TRUE(e.peak_at);
    EXPECT_FALSE(e.onset);
    EXPECT_FALSE(e.rise);
    EXPECT_TRUE(e.decay);
}

TEST(Episode, SumsUpNothingAcrossWhatIsNotMeasurable) {
    std::vector<FrameAmounts> frames = frames_of([](double) { return 0.5; });
    for (FrameAmounts& f : frames)
        if (f.time > 2.0 && f.time < 8.0) f.flags = told::not_measurable;
    const Episode e = episode_of(frames, Curve::veil);
    EXPECT_NEAR(*e.area, 0.5 * 4.0, 0.05);
    EXPECT_NEAR(*e.mean, 0.5, 1e-9);
}

TEST(Episode, LeavesOutWhatIsNotMeasurable) {
    std::vector<FrameAmounts> frames = frames_of(tent);
    for (FrameAmounts& f : frames)
        if (f.time < 1.0) {
            f.veil = {0.9, 0.8, 1.0};
            f.flags = told::not_measurable;
        }
    const Episode e = episode_of(frames, Curve::veil);
    EXPECT_NEAR(*e.peak, 0.5, 0.02);
    EXPECT_FALSE(episode_of({}, Curve::blood).peak);
}

}  // namespace
}  // namespace lapfx::match
