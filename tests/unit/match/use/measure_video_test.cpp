#include "match/use/measure_video.h"

#include <gtest/gtest.h>

#include <utility>

#include "unit/match/clips.h"

namespace lapfx::match {
namespace {

class MeasureVideo : public ::testing::Test {
  protected:
    static constexpr int frames = 12;
    static constexpr double from = 0.2, to = 0.3;  // s

    /// Smoke rises from 0 to 0.3 and blood spreads.
    void SetUp() override {
        const cv::Mat clear = test::tissue();
        for (int i = 0; i < frames; ++i) {
            cv::Mat frame = clear.clone();
            test::bleed(frame, {150, 130}, 5 * i);
            clip.add(test::smoky(frame, 0.3 * i / (frames - 1)));
        }
    }
    static MeasureOptions options() { return {.baseline = 0.0}; }
    MeasuredVideo measured(VideoMeasuring how) const {
        VideoReader reader(clip.video());
        return measure_video(reader, std::move(how));
    }

    test::Clip clip;
};

TEST_F(MeasureVideo, GivesTheColorsOfThePartThatIsAskedFor) {
    PeakColors expected(from, to), of_all;
    MeasureOptions by_hand = options();
    by_hand.measured = [&](const auto& frame, const Estimator* estimator, const FrameAmounts& amounts) {
        expected.add(frame, estimator, amounts);
        of_all.add(frame, estimator, amounts);
    };
    VideoReader reader(clip.video());
    const Measurement found = measure(reader, by_hand);
    const MeasuredVideo video = measured({.options = options(), .colors_of = {{from, to}}});
    EXPECT_EQ(csv_of(video.found), csv_of(found));
    ASSERT_TRUE(video.colors.colors.blood);
    EXPECT_EQ(video.colors.colors.blood, expected.found().blood);
    EXPECT_EQ(video.colors.colors.smoke, expected.found().smoke);
    EXPECT_EQ(video.colors.colors.tissue, expected.found().tissue);
    EXPECT_EQ(video.colors.blood.value, expected.at_peak().blood.value);
    EXPECT_LT(video.colors.veil.value, of_all.at_peak().veil.value) << "of that part alone";
    EXPECT_EQ(video.colors_over_time, nullptr);
}

TEST_F(MeasureVideo, GivesTheColorsOfAnyPartAfterwards) {
    const MeasuredVideo video = measured({.options = options(), .colors_over_time = true});
    ASSERT_NE(video.colors_over_time, nullptr);
    EXPECT_TRUE(video.colors_over_time->at_peak(0.0, 1.0).colors.blood);
    EXPECT_FALSE(video.colors_over_time->at_peak(5.0, 6.0).colors.blood);
    EXPECT_FALSE(video.colors.colors.blood) << "of no part in particular";
}

TEST_F(MeasureVideo, WhoLooksAtEachFrameStillDoes) {
    int seen = 0;
    MeasureOptions watched = options();
    watched.measured = [&seen](const auto&, const Estimator*, const FrameAmounts&) { ++seen; };
    measured({.options = watched, .colors_of = {{from, to}}, .colors_over_time = true});
    EXPECT_EQ(seen, frames);
}

TEST_F(MeasureVideo, OpensAFileForItself) {
    MeasureOptions first = options();
    first.to = 0.05;
    const MeasuredVideo found = measure_video(clip.video(), {.options = first});
    ASSERT_EQ(found.found.frames.size(), 2U);
    EXPECT_EQ(csv_of(found.found), csv_of(measured({.options = first}).found));
    EXPECT_THROW(measure_video("no_such.mp4", {}), Error);
}

TEST(MeasureOptionsOfAScene, FollowItsRow) {
    ReferenceMeasure measure;
    measure.blood.redness = 4.0;
    measure.region = {.x = 0.25, .y = 0.5, .width = 1.0, .height = 0.25};
    measure.parts = {{.corners = {{0.0, 0.0}, {0.5, 0.0}}}, {.corners = {{0.0, 0.0}, {0.5, 0.0}, {0.5, 1.0}}}};
    measure.baseline = 2.5, measure.from = 1.0, measure.to = 0.0;
    const MeasureOptions options = measure_options(measure);
    EXPECT_EQ(options.estimator.blood.redness, 4.0);
    EXPECT_EQ(options.estimator.region, glm::dvec4(0.25, 0.5, 0.75, 0.25)) << "within the picture";
    ASSERT_EQ(options.estimator.masks.size(), 1U) << "two corners are no polygon";
    EXPECT_EQ(options.estimator.masks[0], (MaskPolygon{{0.0, 0.0}, {0.5, 0.0}, {0.5, 1.0}}));
    EXPECT_EQ(options.baseline, 2.5);
    EXPECT_EQ(options.from, 1.0);
    EXPECT_FALSE(options.to);
    EXPECT_FALSE(options.strokes);
}

TEST(MeasureOptionsOfAScene, HaveItsStrokesOnceOneMarksBlood) {
    ReferenceMeasure measure;
    measure.without_blood = 0.4;
    measure.strokes = {{.time = 1.0, .marks = StrokeMark::other, .points = {{0.1, 0.1}}}, {.time = 2.0}};
    EXPECT_FALSE(measure_options(measure).strokes) << "the stroke of blood has no points";
    measure.strokes[1].points = {{0.5, 0.5}};
    const MeasureOptions options = measure_options(measure);
    ASSERT_TRUE(options.strokes);
    ASSERT_EQ(options.strokes->strokes.size(), 2U);
    EXPECT_EQ(options.strokes->strokes[1].time, 2.0);
    EXPECT_EQ(options.strokes->without_blood, 0.4);
    EXPECT_EQ(options.strokes->place, "/reference/measure");
    measure.without_blood = -1.0;
    EXPECT_FALSE(measure_options(measure).strokes->without_blood);
}

}  // namespace
}  // namespace lapfx::match
