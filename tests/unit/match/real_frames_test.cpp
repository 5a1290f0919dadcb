// Real frames that are not part of the project; skipped if they are missing. Of most videos fewer frames are measured
// than with `tests/run --deep`.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "lapfx/authoring/video.h"
#include "lapfx/error.h"
#include "match/measure.h"
#include "match/pairs.h"
#include "support/deep.h"
#include "unit/organ/fixtures.h"

namespace lapfx::match {
namespace {

namespace fs = std::filesystem;

class RealFrames : public ::testing::Test {
  protected:
    void SetUp() override {
        data = lapfx::test::data_folder();
        if (data.empty()) GTEST_SKIP() << "no test data";
    }
    /// Of the pairs in two folders, how many have the more smoke where a viewer sees it.
    static std::pair<int, int> right_of_all(const fs::path& smoky, const fs::path& clear) {
        const std::vector<RankedPair> pairs = rank_pairs(smoky, clear, 4);  // with fewer frames chance decides
        const auto right = std::count_if(pairs.begin(), pairs.end(), [](const RankedPair& p) { return p.right(); });
        return {static_cast<int>(right), static_cast<int>(pairs.size())};
    }
    fs::path data;
};

TEST_F(RealFrames, SmokyOnesOfPairsRankAboveClearOnes) {
    const fs::path folder = data / "surgery/desmoking-pairs-salazar/datasets/laparoscopy";
    const auto [right, all] = right_of_all(folder / "input", folder / "output");
    EXPECT_GE(all, 15);
    EXPECT_GE(right, 0.9 * all);
}

TEST_F(RealFrames, InputsRankAboveTheirDesmokedOutputs) {
    const fs::path folder = data / "surgery/DeSmoke-LAP/video clips";
    const auto [right, all] = right_of_all(folder / "Input", folder / "DeSmoke-LAP");
    EXPECT_GE(all, 7);
    EXPECT_GE(right, all - 1);  // input_2 has hardly any smoke, and its output no less of it
}

/// A trocar and a white bag fill the view: that is not smoke.
TEST_F(RealFrames, ABagAndATrocarAreNotMeasurable) {
    for (const char* name : {"video01_292.mp4", "video01_294.mp4"}) {
        VideoReader reader(data / "surgery/cholec80-5s-clips/train/high" / name);
        Measurement found;
        try {
            found = measure(reader, {.every = lapfx::test::one_in(12, 4)});
        } catch (const Error& error) {
            EXPECT_NE(error.faults().front().reason.find("no frame that is measurable"), std::string::npos) << name;
            continue;
        }
        int not_measurable = 0;
        for (const FrameAmounts& f : found.frames) not_measurable += f.measurable() ? 0 : 1;
        EXPECT_GT(not_measurable, static_cast<int>(found.frames.size()) / 2) << name;
        EXPECT_FALSE(found.veil.peak_at) << name;
    }
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
