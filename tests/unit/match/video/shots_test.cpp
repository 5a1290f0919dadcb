#include "match/video/shots.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "match/picture/seen_frame.h"
#include "match/video/measure.h"
#include "unit/match/clips.h"

namespace lapfx::match {
namespace {

constexpr double frame = 0.04;  // s

TEST(Shots, TimesAndSharesAreWrittenForPeople) {
    EXPECT_EQ(seconds_text(12.5), "12.50 s");
    EXPECT_EQ(percent_text(0.1234), "12.3 %");
}

std::vector<Shot> shots_in(const test::Clip& clip, std::optional<double> baseline = {}) {
    VideoReader video(clip.video());
    return find_shots(video, 0.0, video.info().duration, baseline);
}

/// "0-29 30-59".
std::string stretches(const std::vector<Shot>& shots) {
    std::string text;
    for (const Shot& shot : shots)
        text += (text.empty() ? "" : " ") + std::to_string(shot.first) + "-" + std::to_string(shot.last);
    return text;
}

TEST(Shots, EachHasABaselineOfItsOwn) {
    test::Clip clip;
    for (const int seed : {1, 2})
        for (int i = 0; i < 30; ++i) clip.add(test::smoky(test::tissue(seed), i < 15 ? 0.4 : 0.03 * (i - 15)));
    const std::vector<Shot> shots = shots_in(clip);
    ASSERT_EQ(stretches(shots), "0-29 30-59");
    EXPECT_FALSE(shots[0].cut);
    EXPECT_TRUE(shots[1].cut);
    for (const Shot& shot : shots) {
        ASSERT_TRUE(shot.baseline);
        EXPECT_TRUE(shot.suggested);
        EXPECT_FALSE(shot.hazy);
        EXPECT_NEAR(*shot.baseline, shot.from + 15.5 * frame, 1.5 * frame) << "no haze, and not the hazy start";
    }
    VideoReader video(clip.video());
    const Measurement found = measure(video, {});
    for (const std::size_t first : {0, 30}) {
        EXPECT_NEAR(found.frames[first + 5].veil.value, 0.4, 0.06);
        EXPECT_NEAR(found.frames[first + 16].veil.value, 0.03, 0.03);
        EXPECT_NEAR(found.frames[first + 29].veil.value, 0.42, 0.06);
    }
    EXPECT_EQ(found.frames[30].flags & told::cut, told::cut);
    EXPECT_EQ(found.baseline, shots[0].baseline) << "the first of the longest";
    const nlohmann::json json = nlohmann::json::parse(json_of(found))["shots"];
    ASSERT_EQ(json.size(), 2U);
    EXPECT_EQ(json[1]["baseline"]["time"], *shots[1].baseline);
    EXPECT_TRUE(json[1]["without"].is_null());
}

/// Blood grows: what comes before has the least of it.
TEST(Shots, TheBaselineIsTheEarliestThatIsNearlyAsClear) {
    const auto baseline = [](double haze, int instrument) {
        cv::Mat early = test::smoky(test::tissue(), haze);
        cv::rectangle(early, {0, 0, instrument, test::height}, {0.2, 0.2, 0.2}, cv::FILLED);
        test::Clip clip;
        clip.add(early, 15);
        clip.add(test::tissue(), 30);
        const std::vector<Shot> shots = shots_in(clip);
        EXPECT_EQ(stretches(shots), "0-44");
        return shots.front().baseline.value_or(-1.0);
    };
    EXPECT_EQ(baseline(0.0, test::width / 30), 0.0) << "an instrument covers a thirtieth of it";
    EXPECT_GE(baseline(0.0, test::width / 3), 15 * frame - 1e-9) << "a third";
    EXPECT_GE(baseline(0.08, test::width / 30), 15 * frame - 1e-9) << "it is hazy";
}

TEST(Shots, ABagDividesThemAndTheSameTissueSharesTheClearestBaseline) {
    test::Clip clip;
    clip.add(test::tissue(), 25);
    clip.add(test::bag(), 12);
    clip.add(test::smoky(test::tissue(), 0.55), 25);
    const std::vector<Shot> shots = shots_in(clip);
    ASSERT_EQ(stretches(shots), "0-24 25-36 37-61");
    EXPECT_EQ(shots[1].why, WithoutBaseline::bag);
    EXPECT_FALSE(shots[1].baseline);
    ASSERT_TRUE(shots[0].baseline && shots[2].baseline);
    EXPECT_EQ(*shots[2].baseline, *shots[0].baseline);
    VideoReader video(clip.video());
    const Measurement found = measure(video, {});
    EXPECT_NEAR(found.frames[50].veil.value, 0.55, 0.06);
    EXPECT_EQ(found.frames[30].flags, told::bag);
    EXPECT_EQ(nlohmann::json::parse(json_of(found))["shots"][1]["without"], "bag");
}

TEST(Shots, ABaselineThatIsGivenServesAllThatShowItsTissueAndNoOther) {
    test::Clip clip;
    clip.add(test::smoky(test::tissue(1), 0.1), 25);
    clip.add(test::tissue(2), 25);
    clip.add(test::tissue(1), 25);
    const std::vector<Shot> shots = shots_in(clip, 0.2);
    ASSERT_EQ(stretches(shots), "0-24 25-49 50-74");
    EXPECT_EQ(shots[0].baseline, 0.2);
    EXPECT_EQ(shots[2].baseline, 0.2) << "although it has a clearer one";
    EXPECT_FALSE(shots[0].suggested || shots[2].suggested);
    ASSERT_TRUE(shots[1].baseline);
    EXPECT_TRUE(shots[1].suggested);
    EXPECT_GE(*shots[1].baseline, 25 * frame - 1e-9);
    EXPECT_FALSE(shots[0].other || shots[2].other);
    EXPECT_TRUE(shots[1].other);
    for (const Shot& shot : shots_in(clip)) EXPECT_FALSE(shot.other) << "none is given";
}

/// Only what is new is measured, and what a shot's own frames hold is there in all of them.
TEST(Shots, WhereTheGivenBaselineIsNotInViewBloodThatIsThereAlreadyIsNotDenied) {
    cv::Mat bloody = test::tissue(2);
    test::bleed(bloody, {150, 130}, 44);
    const double bled = 3.14159 * 44 * 44 / (test::width * test::height);
    test::Clip clip;
    clip.add(test::tissue(1), 25);
    clip.add(bloody, 25);
    clip.add(test::tissue(5), 6);
    VideoReader video(clip.video());
    const Measurement found = measure(video, {.baseline = 0.0});
    ASSERT_EQ(stretches(found.shots), "0-24 25-49 50-55");
    EXPECT_EQ(found.shots[0].baseline, 0.0);
    EXPECT_LT(found.frames[10].blood.high, 0.03);
    for (const std::size_t i : {25, 40, 49}) {
        EXPECT_LT(found.frames[i].blood.value, 0.01) << i;
        EXPECT_EQ(found.frames[i].blood.low, 0.0) << i;
        EXPECT_GT(found.frames[i].blood.high, bled) << i;
        EXPECT_LT(found.frames[i].blood.high, bled + 0.04) << i;
    }
    EXPECT_THAT(found.notes,
                testing::IsSupersetOf(
                    {"1.00 s to 1.96 s: the baseline at 0.00 s does not show its tissue; it is compared with the frame "
                     "at 1.00 s, and blood that is there already is not seen.",
                     "2.00 s to 2.20 s: the baseline at 0.00 s does not show its tissue; the shot is too short for a "
                     "baseline of its own, and no other one shows its tissue."}));
    const Measurement suggested = measure(video, {});
    EXPECT_LT(suggested.frames[40].blood.high, 0.03) << "its own is the only one";
    for (const std::string& note : suggested.notes) EXPECT_EQ(note.find("already"), std::string::npos) << note;
}

TEST(Shots, ABriefOneHasNone) {
    test::Clip clip;
    clip.add(test::tissue(1), 25);
    clip.add(test::tissue(2), 6);
    clip.add(test::tissue(1), 25);
    const std::vector<Shot> shots = shots_in(clip);
    ASSERT_EQ(stretches(shots), "0-24 25-30 31-55");
    EXPECT_FALSE(shots[1].baseline);
    EXPECT_EQ(shots[1].why, WithoutBaseline::brief);
    VideoReader video(clip.video());
    const Measurement found = measure(video, {});
    EXPECT_EQ(found.frames[28].flags, told::no_baseline);
    EXPECT_FALSE(found.frames[28].course);
    EXPECT_TRUE(found.frames[24].measurable());
    EXPECT_TRUE(found.frames[31].measurable());
}

TEST(Shots, ACameraThatPansMakesNone) {
    cv::Mat wide;
    const std::vector<cv::Mat> beside = {test::tissue(), test::tissue(5)};
    cv::hconcat(beside, wide);
    test::Clip clip;
    for (int x = 0; x <= test::width; x += 10) clip.add(wide(cv::Rect(x, 0, test::width, test::height)).clone());
    EXPECT_EQ(stretches(shots_in(clip)), "0-32");
}

TEST(Shots, AreFoundInThePartThatIsMeasured) {
    test::Clip clip;
    clip.add(test::tissue(1), 20);
    clip.add(test::tissue(2), 40);
    VideoReader video(clip.video());
    const std::vector<Shot> shots = find_shots(video, 30 * frame, 50 * frame, {});
    ASSERT_EQ(stretches(shots), "30-50");
    EXPECT_GE(*shots[0].baseline, 30 * frame - 1e-9);
}

TEST(Shots, WithoutTissueTheVideoIsRefusedAndSaysWhy) {
    test::Clip clip;
    clip.add(test::bag(), 30);
    clip.add(cv::Mat(test::height, test::width, CV_32FC3, cv::Scalar(0, 0, 0)), 10);
    VideoReader video(clip.video());
    EXPECT_EQ(lapfx::test::faults_of([&] { measure(video, {}); }),
              std::vector<std::string>{"has no frame that is measurable (of 40 frames 10 dark, 30 bag); choose a "
                                       "baseline or a part of one view"});
    EXPECT_EQ(lapfx::test::faults_of([&] { suggest_baseline(video, 0.0, 1.0); }),
              std::vector<std::string>{"has no frame that is measurable: no tissue is in view"});
}

TEST(Shots, SmokeThatTakesAllRedIsNoBag) {
    test::Clip clip;
    const HazeLight grey{.color = {0.4, 0.4, 0.4}, .fall_off = 0.2};
    for (int i = 0; i < 40; ++i)
        clip.add(test::veiled(test::tissue(), cv::Mat(test::height, test::width, CV_32F, cv::Scalar(0.024 * i)),
                              test::light_of(grey)));
    VideoReader video(clip.video());
    Image last;
    video.read(39, last);
    ASSERT_EQ(look_at(last).in_view, InView::bag) << "by itself";
    const Measurement found = measure(video, {});
    ASSERT_EQ(stretches(found.shots), "0-39");
    EXPECT_EQ(found.frames[36].flags & told::bag, 0U);
    EXPECT_GT(found.frames[36].veil.value, 0.75);
}

/// Thick smoke from beginning to end that becomes thicker from 1 s to 2 s and goes back from 3 s to 4 s.
double thick(double time) {
    if (time < 1.0 || time > 4.0) return 0.5;
    return 0.5 + 0.35 * (time < 2.0 ? time - 1.0 : std::min(1.0, 4.0 - time));
}

TEST(Course, IsToldWithoutALevelWhereEveryFrameIsHazy) {
    test::Clip clip;
    for (int i = 0; i < 125; ++i) clip.add(test::smoky(test::tissue(), thick(i * frame)));
    VideoReader video(clip.video());
    const Measurement found = measure(video, {});
    ASSERT_EQ(found.shots.size(), 1U);
    EXPECT_EQ(found.shots[0].why, WithoutBaseline::hazy);
    EXPECT_FALSE(found.baseline);
    EXPECT_TRUE(found.course_only);
    EXPECT_FALSE(found.blood.peak);
    EXPECT_FALSE(found.veil.peak || found.veil.mean || found.veil.area) << "no level";
    ASSERT_TRUE(found.veil.onset && found.veil.rise && found.veil.peak_at && found.veil.decay);
    EXPECT_NEAR(*found.veil.onset, 1.1, 0.15);
    EXPECT_NEAR(*found.veil.rise, 0.8, 0.2);
    EXPECT_GE(*found.veil.peak_at, 1.9);
    EXPECT_LE(*found.veil.peak_at, 3.1);
    for (const FrameAmounts& f : found.frames) {
        EXPECT_EQ(f.flags, told::no_baseline);
        ASSERT_TRUE(f.course);
        EXPECT_GE(f.course->value, 0.0);
        EXPECT_LE(f.course->value, 1.0);
    }
    EXPECT_LT(found.frames[10].course->value, 0.1);
    EXPECT_GT(found.frames[62].course->value, 0.9);
    EXPECT_NE(found.notes.front().find("course only, no level"), std::string::npos) << found.notes.front();
    const std::string csv = csv_of(found);
    EXPECT_NE(csv.find("\n0.4000,,,,,,,no_baseline,,,,,,\n"), std::string::npos);
    EXPECT_FALSE(read_amounts(csv, "a.csv")[10].measurable());
    const nlohmann::json json = nlohmann::json::parse(json_of(found));
    EXPECT_TRUE(json["course_only"]);
    EXPECT_TRUE(json["baseline"].is_null());
    EXPECT_TRUE(json["veil"]["peak"].is_null());
    EXPECT_EQ(json["veil"]["onset"], *found.veil.onset);
    EXPECT_TRUE(json["frames"][62]["veil"].is_null());
    EXPECT_EQ(json["frames"][62]["course"], found.frames[62].course->value);
    EXPECT_EQ(json["shots"][0]["without"], "hazy");
    // Its frame to begin with: a person may look for a clearer one from there.
    const double suggested = suggest_baseline(video, 0.0, 5.0);
    EXPECT_TRUE(suggested < 1.1 || suggested > 3.9) << suggested;
}

TEST(Course, OfSmokeThatIsThereFromBeginningToEndHasNoOnset) {
    test::Clip clip;
    cv::RNG random(7);
    for (int i = 0; i < 60; ++i) clip.add(test::smoky(test::tissue(), 0.6 + random.uniform(-0.01, 0.01)));
    VideoReader video(clip.video());
    const Measurement found = measure(video, {});
    EXPECT_TRUE(found.course_only);
    EXPECT_FALSE(found.veil.onset || found.veil.peak_at || found.veil.rise || found.veil.decay);
    EXPECT_EQ(found.notes.back(), "Veil: no change between 0.00 s and 2.36 s beyond the error of measuring.");
}

TEST(Course, IsDrawnWithoutAScale) {
    test::Clip clip;
    for (int i = 0; i < 60; ++i) clip.add(test::smoky(test::tissue(), thick(i * frame)));
    VideoReader video(clip.video());
    Measurement found = measure(video, {});
    const auto dark_at_the_left = [](const Image& plot) {  // numbers of the lower axis
        int dark = 0;
        for (int y = 400; y < 680; ++y)
            for (int x = 10; x < 60; ++x) dark += plot.pixels[4 * static_cast<std::size_t>(y * plot.width + x)] < 128;
        return dark;
    };
    EXPECT_EQ(dark_at_the_left(plot_of(found)), 0);
    for (FrameAmounts& f : found.frames) f.flags = 0, f.course.reset();
    found.course_only = false;
    EXPECT_GT(dark_at_the_left(plot_of(found)), 50);
}

}  // namespace
}  // namespace lapfx::match
