// Videos of painted pictures, in which blood is told by strokes.
#include "match/video/painted_video.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "match/video/measure.h"
#include "unit/match/clips.h"

namespace lapfx::match {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double frame = 0.04;  // s
constexpr int frames = 12, radius = 40;
constexpr double disc = 3.14159 * radius * radius / (test::width * test::height);

BloodStroke stroke(double time, StrokeMark marks, std::vector<PicturePlace> points) {
    for (PicturePlace& point : points) point.x /= test::width, point.y /= test::height;
    return {.time = time, .marks = marks, .radius = 5.0 / test::width, .points = std::move(points)};
}

/// Over the fifth frame.
BloodStrokes strokes() {
    return {.file = "s.json",
            .without_blood = {},
            .strokes = {stroke(4 * frame, StrokeMark::blood, {{130, 120}, {165, 140}}),
                        stroke(4 * frame, StrokeMark::other, {{30, 30}, {120, 40}}),
                        stroke(4 * frame, StrokeMark::other, {{250, 60}, {280, 220}})}};
}

class PaintedVideoTest : public ::testing::Test {
  protected:
    /// A disc of blood from frame `from` on.
    void add(int from) {
        for (int i = 0; i < frames; ++i) {
            cv::Mat picture = test::tissue();
            if (i >= from) test::bleed(picture, {150, 130}, radius);
            clip.add(picture);
        }
    }
    Measurement measured(const BloodStrokes& by, std::optional<double> baseline = 0.0) const {
        VideoReader video(clip.video());
        return measure(video, {.baseline = baseline, .strokes = by});
    }
    std::vector<std::string> faults(const BloodStrokes& by) const {
        return lapfx::test::faults_of([&] { measured(by); });
    }
    test::Clip clip;
};

TEST_F(PaintedVideoTest, BloodThatTheBaselineHoldsIsMeasured) {
    add(0);
    VideoReader video(clip.video());
    EXPECT_LT(measure(video, {.baseline = 0.0}).frames.back().blood.value, 0.005) << "nothing is new";
    const Measurement found = measured(strokes());
    for (const FrameAmounts& amounts : found.frames) {
        EXPECT_NEAR(amounts.blood.value, disc, 0.15 * disc);
        EXPECT_NEAR(amounts.blood.low, 0.5 * amounts.blood.value - 0.005, 1e-12);
    }
    ASSERT_TRUE(found.painted);
    EXPECT_FALSE(found.painted->without_blood) << "the baseline looks as if it had some";
    EXPECT_EQ(found.painted->blood->threshold(), 0.9);
    EXPECT_THAT(found.notes, testing::Contains(HasSubstr("no frame without blood is known")));
}

TEST_F(PaintedVideoTest, TheFrameWithoutBloodIsTheOneThatIsNamedOrTheBaseline) {
    add(2);
    BloodStrokes named = strokes(), in_baseline = strokes();
    named.without_blood = frame;
    in_baseline.strokes[0].time = 5 * frame;
    const Measurement found = measured(strokes()), by_name = measured(named, 5 * frame),
                      marked = measured(in_baseline, 5 * frame);
    EXPECT_EQ(found.painted->without_blood, 0.0);
    EXPECT_EQ(found.painted->blood->threshold(), 0.5);
    EXPECT_LE(found.frames[1].blood.value, 0.005);
    EXPECT_NEAR(found.frames[2].blood.value, disc, 0.15 * disc);
    ASSERT_TRUE(by_name.painted->without_blood);
    EXPECT_NEAR(*by_name.painted->without_blood, frame, 1e-6);
    EXPECT_FALSE(marked.painted->without_blood) << "a stroke marks blood in the baseline";
    EXPECT_THAT(found.notes,
                testing::Contains("Blood is all in view that looks as the strokes of s.json say; the frame "
                                  "at 0.00 s counts as without blood."));
}

TEST_F(PaintedVideoTest, JsonSaysThatBloodIsAbsoluteAndByWhichStrokes) {
    add(2);
    const nlohmann::json with = nlohmann::json::parse(json_of(measured(strokes())))["blood_by_strokes"];
    EXPECT_EQ(with["file"], "s.json");
    EXPECT_EQ(with["absolute"], true);
    EXPECT_EQ(with["without_blood"], 0.0);
    EXPECT_EQ(with["threshold"], 0.5);
    EXPECT_GT(with["found_again"], 0.95);
    VideoReader video(clip.video());
    EXPECT_FALSE(nlohmann::json::parse(json_of(measure(video, {.baseline = 0.0}))).contains("blood_by_strokes"));
}

TEST_F(PaintedVideoTest, StrokesOfBloodThatMarkTissueAreToldOf) {
    add(2);
    const char* told = "of what the strokes mark as blood looks alike enough to be found again";
    EXPECT_THAT(measured(strokes()).notes, Not(testing::Contains(HasSubstr(told))));
    BloodStrokes tissue = strokes();
    tissue.strokes[0] = stroke(4 * frame, StrokeMark::blood, {{40, 100}, {60, 180}, {90, 220}});
    const Measurement found = measured(tissue);
    EXPECT_LT(found.painted->blood->found_again(), 0.5);
    EXPECT_THAT(found.notes, testing::Contains(HasSubstr(told)));
}

TEST_F(PaintedVideoTest, OfAFrameWithoutBloodThatLooksBloodyItIsTold) {
    add(2);
    BloodStrokes wrong = strokes();
    wrong.without_blood = 6 * frame;  // it bleeds there
    EXPECT_THAT(measured(wrong).notes, testing::Contains(HasSubstr("is taken for blood all the same")));
    wrong.without_blood = 0.0;
    EXPECT_THAT(measured(wrong).notes, Not(testing::Contains(HasSubstr("is taken for blood all the same"))));
}

TEST_F(PaintedVideoTest, StrokesOverMoreThanTwentyFramesAreRefused) {
    add(2);
    add(0);
    BloodStrokes many = strokes();
    for (int i = 0; i < 20; ++i) many.strokes.push_back(stroke(i * frame, StrokeMark::other, {{30, 30}, {120, 40}}));
    EXPECT_EQ(measured(many).frames.size(), 2U * frames) << "20 frames, one of them twice";
    many.strokes.push_back(stroke(20 * frame, StrokeMark::other, {{30, 30}, {120, 40}}));
    EXPECT_THAT(faults(many), testing::ElementsAre("s.json: /strokes: lie over 21 frames (allowed: 1 to 20)"));
}

TEST_F(PaintedVideoTest, AFaultNamesTheStroke) {
    add(2);
    BloodStrokes late = strokes(), contrary = strokes(), after = strokes();
    late.strokes[1].time = 9.0;
    EXPECT_THAT(faults(late),
                ElementsAre("s.json: /strokes/1/time: 9.00 s is outside the video (allowed: 0 to 0.48 s)"));
    contrary.without_blood = 4 * frame;
    EXPECT_THAT(faults(contrary), ElementsAre("s.json: /without_blood: stroke 0 marks blood there"));
    after.without_blood = 9.0;
    EXPECT_THAT(faults(after),
                ElementsAre("s.json: /without_blood: 9.00 s is outside the video (allowed: 0 to 0.48 s)"));
}

}  // namespace
}  // namespace lapfx::match
