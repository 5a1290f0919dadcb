// Real frames that are not part of the project; skipped if they are missing. Of most videos fewer frames are measured
// than with `tests/run --deep`.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <opencv2/imgproc.hpp>

#include "lapfx/authoring/video.h"
#include "lapfx/error.h"
#include "match/picture/colors.h"
#include "match/picture/overlay.h"
#include "match/picture/traps.h"
#include "match/picture/view.h"
#include "match/video/measure.h"
#include "support/deep.h"
#include "unit/organ/fixtures.h"
#include "unit/preset/support.h"

namespace lapfx::match {
namespace {

namespace fs = std::filesystem;

class RealFrames : public ::testing::Test {
  protected:
    void SetUp() override {
        data = lapfx::test::data_folder();
        if (data.empty()) GTEST_SKIP() << "no test data";
    }
    fs::path clip(int number) const {
        return data / "surgery/cholec80-5s-clips/train/high" / ("video01_" + std::to_string(number) + ".mp4");
    }
    /// Of frames, every n-th of those of a video: '-' none, 'b' a bag, 't' a trocar.
    static std::string traps_of(const fs::path& file, int every = 1) {
        VideoReader reader(file);
        std::string found;
        Image image;
        cv::Mat code;
        for (int frame = 0; frame < reader.info().frames; frame += every) {
            reader.read(frame, image);
            shrink(image, {256, 256 * image.height / image.width}, code);
            found += "-bt"[static_cast<int>(trap_of(code, view_of(code)))];
        }
        return found;
    }
    fs::path data;
};

/// Tissue, out through a trocar, and a bag; a bag; a bag, what is outside the body, and back into the trocar.
TEST_F(RealFrames, ABagAndATrocarAreToldFrameByFrame) {
    const std::string leaves = traps_of(clip(292)), outside = traps_of(clip(293)), comes = traps_of(clip(294));
    ASSERT_EQ(leaves.size(), 125U);
    EXPECT_EQ(leaves.find_first_not_of('-'), 36U) << leaves;
    EXPECT_EQ(leaves.substr(36, 18), std::string(18, 't'));
    EXPECT_EQ(leaves.substr(70), std::string(55, 'b'));
    EXPECT_EQ(outside, std::string(125, 'b'));
    EXPECT_EQ(comes.substr(0, 15), std::string(15, 'b'));
    EXPECT_EQ(comes.substr(112), std::string(13, 't'));
}

/// Smoke over tissue, thin and so dense that a viewer hardly sees what is behind.
TEST_F(RealFrames, SmokeIsNoTrap) {
    const int every = lapfx::test::one_in(5, 1);
    for (const int number : {288, 289, 290, 291, 296, 297})
        EXPECT_EQ(traps_of(clip(number), every).find_first_not_of('-'), std::string::npos) << number;
    EXPECT_EQ(traps_of(clip(295)).find_last_not_of('-'), 9U) << "it comes in through the trocar";
    for (const auto& file : fs::directory_iterator(data / "surgery/DeSmoke-LAP/video clips/Input"))
        if (file.path().extension() == ".avi") {
            EXPECT_EQ(traps_of(file.path(), every).find_first_not_of('-'), std::string::npos) << file.path();
        }
}

/// 36 frames of tissue, then a trocar and a bag.
TEST_F(RealFrames, ShotsEndWhereNoTissueIsInView) {
    VideoReader reader(clip(292));
    const Measurement found = measure(reader, {});
    ASSERT_EQ(found.shots.size(), 2U);
    EXPECT_EQ(found.shots[0].last, 35);
    EXPECT_TRUE(found.shots[0].baseline);
    EXPECT_LE(reader.frame_at(*found.shots[0].baseline), 35);
    EXPECT_EQ(found.shots[1].why, WithoutBaseline::bag);
    for (std::size_t i = 0; i < 125; ++i) EXPECT_EQ(found.frames[i].measurable(), i < 36) << i;
    for (std::size_t i = 70; i < 125; ++i) EXPECT_EQ(found.frames[i].flags, told::bag) << i;
}

/// Two frames per second: the camera moves from each to the next.
TEST_F(RealFrames, FramesThatAreFarApartAreNotCut) {
    for (const char* name : {"input_2.avi", "input_6.avi", "input_7.avi"}) {
        VideoReader reader(data / "surgery/DeSmoke-LAP/video clips/Input" / name);
        EXPECT_EQ(find_shots(reader, 0.0, reader.info().duration, {}).size(), 1U) << name;
    }
}

/// The bag alone, and what is outside the body.
TEST_F(RealFrames, AVideoWithoutTissueIsRefused) {
    for (const int number : {293, 294}) {
        VideoReader reader(clip(number));
        const auto faults = lapfx::test::faults_of([&] { measure(reader, {}); });
        ASSERT_EQ(faults.size(), 1U) << number;
        EXPECT_NE(faults[0].find("has no frame that is measurable (of 125 frames "), std::string::npos) << faults[0];
        EXPECT_NE(faults[0].find(number == 293 ? "125 bag" : " trocar"), std::string::npos) << faults[0];
    }
}

/// It opens hazy, clears while the camera comes near, and smoke builds up from frame 60 on.
TEST_F(RealFrames, AHazyStartIsNoBaseline) {
    VideoReader reader(clip(288));
    const std::vector<Shot> shots = find_shots(reader, 0.0, reader.info().duration, {});
    const Shot& shot = *main_shot(shots);
    ASSERT_TRUE(shot.baseline);
    EXPECT_GE(reader.frame_at(*shot.baseline), 30);
    EXPECT_LE(reader.frame_at(*shot.baseline), 60);
}

/// Smoke fills the view from the first frame to the last.
TEST_F(RealFrames, SmokeFromBeginningToEndHasNoLevel) {
    for (const int number : {289, 297}) {
        VideoReader reader(clip(number));
        const Measurement found = measure(reader, {.every = lapfx::test::one_in(5, 1)});
        EXPECT_FALSE(found.baseline) << number;
        EXPECT_TRUE(found.course_only) << number;
        EXPECT_FALSE(found.veil.peak || found.veil.onset) << number;
    }
}

/// Pale tissue with little smoke before it serves, and it is said that it may be hazy.
TEST_F(RealFrames, PaleTissueIsABaselineAndSmokeIsNone) {
    const auto main_of = [this](int number) {
        VideoReader reader(clip(number));
        return *main_shot(find_shots(reader, 0.0, reader.info().duration, {}));
    };
    const Shot pale = main_of(295);
    ASSERT_TRUE(pale.baseline);
    EXPECT_GT(*pale.baseline, 3.0) << "it clears towards the end";
    EXPECT_TRUE(pale.hazy);
    const Shot smoke = main_of(296);
    EXPECT_FALSE(smoke.baseline);
    EXPECT_EQ(smoke.why, WithoutBaseline::hazy);
}

/// In few frames much of what moves keeps its value by chance.
TEST_F(RealFrames, OverlaysAreFoundWhereThereIsOneAlone) {
    constexpr double told = 0.002;  // of the picture
    int without = 0, with = 0, all = 0;
    cv::RNG random(7);
    for (const int number : {198, 200, 203, 204}) {
        VideoReader reader(clip(number));
        std::vector<Image> frames(25);
        for (int i = 0; i < 25; ++i) reader.read(5 * i, frames[static_cast<std::size_t>(i)]);
        for (int tried = 0; tried < 16; ++tried) {
            OverlaySurvey plain, burnt;
            for (int i = 0; i < 5; ++i) {
                Image picture = frames[static_cast<std::size_t>(random.uniform(0, 25))];
                plain.add(picture);
                const cv::Mat whole(picture.height, picture.width, CV_8UC4, picture.pixels.data());
                cv::putText(whole, "OR 4  23.11.2026", {70, 120}, cv::FONT_HERSHEY_SIMPLEX, 0.5, cv::Scalar::all(255),
                            2);
                burnt.add(picture);
            }
            const auto is_told = [](const OverlaySurvey& survey) {
                const cv::Mat found = survey.found({256, 256});
                return cv::countNonZero(found) >= told * static_cast<double>(found.total());
            };
            ++all, without += is_told(plain) ? 1 : 0, with += is_told(burnt) ? 1 : 0;
        }
    }
    EXPECT_LE(without, 1) << "of " << all;
    EXPECT_GE(with, 9 * all / 10);
}

/// Tissue is pulled and an instrument goes away: nothing bleeds.
TEST_F(RealFrames, TissueThatMovesIsNoBlood) {
    VideoReader reader(data / "surgery/cholec80-5s-clips/train/high/video01_013.mp4");
    const Measurement found = measure(reader, {.baseline = 0.0, .every = lapfx::test::one_in(10, 5)});
    int with_blood = 0;
    for (const FrameAmounts& f : found.frames) with_blood += f.blood.value > 0.03 ? 1 : 0;
    EXPECT_LE(with_blood, static_cast<int>(found.frames.size()) / 10);
}

/// The wound is torn open a little, in the middle of the clip.
TEST_F(RealFrames, NewBloodOfAWoundIsFound) {
    VideoReader reader(data / "surgery/cholec80-5s-clips/train/high/video01_071.mp4");
    const Measurement found = measure(reader, {.baseline = 0.0, .from = 3.0, .to = 3.4});
    ASSERT_FALSE(found.frames.empty());
    for (const FrameAmounts& f : found.frames) EXPECT_GT(f.blood.value, 0.015) << f.time;
}

TEST_F(RealFrames, SmokeThatBuildsUpIsSeenToRise) {
    VideoReader reader(data / "surgery/cholec80-5s-clips/train/high/video01_288.mp4");
    const double frame = 1.0 / reader.info().frames_per_second;
    const Measurement found =
        measure(reader, {.baseline = 50 * frame, .from = 45 * frame, .every = lapfx::test::one_in(10, 5)});
    double early = 0, late = 0;
    for (const FrameAmounts& f : found.frames) {
        if (f.time < 60 * frame) early = std::max(early, f.veil.value);
        if (f.time > 100 * frame) late = std::max(late, f.veil.value);
    }
    EXPECT_GT(late, early + 0.15);
}

}  // namespace
}  // namespace lapfx::match
