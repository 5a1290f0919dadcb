#include "bench/measure/ranked_pairs.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "output/files.h"
#include "unit/match/pictures.h"
#include "unit/organ/fixtures.h"
#include "unit/preset/support.h"

namespace lapfx::bench {
namespace {

namespace fs = std::filesystem;

class Pairs : public ::testing::Test {
  protected:
    void SetUp() override {
        fs::create_directory(folder / "smoky");
        fs::create_directory(folder / "clear");
    }
    void add(const std::string& place, int seed, double veil) {
        const cv::Mat even(match::test::height, match::test::width, CV_32F, cv::Scalar(veil));
        output::write_png(folder / place,
                          match::test::image_of(match::test::veiled(match::test::tissue(seed), even,
                                                                    match::test::light_of(match::HazeLight{}))));
    }
    std::vector<std::string> faults() {
        return lapfx::test::faults_of([&] { rank_pairs(folder / "smoky", folder / "clear"); });
    }
    lapfx::test::Folder folder;
};

TEST_F(Pairs, AreRankedByTheOrderOfTheirNames) {
    add("smoky/input_2.png", 2, 0.3);
    add("smoky/input_11.png", 11, 0.0);
    add("clear/output_2.png", 2, 0.0);
    add("clear/output_11.png", 11, 0.4);
    std::ofstream(folder / "clear" / "notes.txt") << "no picture";
    const std::vector<RankedPair> found = rank_pairs(folder / "smoky", folder / "clear");
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].smoky, "input_2.png") << "before 11";
    EXPECT_EQ(found[0].clear, "output_2.png");
    EXPECT_EQ(found[0].frames, 1);
    EXPECT_TRUE(found[0].right());
    EXPECT_NEAR(found[0].of_smoky, 0.3, 0.08);
    EXPECT_FALSE(found[1].right());
}

TEST_F(Pairs, NeedAPartnerEach) {
    add("smoky/a.png", 1, 0.2);
    EXPECT_EQ(faults(), std::vector<std::string>{(folder / "clear").string() + ": has no pictures or videos"});
    add("clear/a.png", 1, 0);
    add("clear/b.png", 2, 0);
    EXPECT_EQ(faults(), std::vector<std::string>{(folder / "clear").string() + ": has 2 pictures and videos; " +
                                                 (folder / "smoky").string() + " has 1, and each needs its partner"});
    fs::remove_all(folder / "smoky");
    ASSERT_EQ(faults().size(), 1U);
    EXPECT_NE(faults()[0].find("smoky: cannot be read"), std::string::npos) << faults()[0];
}

TEST_F(Pairs, OfWhichOneIsBlackOrAnotherViewAreNotCompared) {
    for (const char* const place : {"smoky/v_0001.png", "clear/v_0001.png"}) add(place, 1, 0.0);
    fs::remove_all(folder / "smoky");
    fs::create_directories(folder / "smoky");
    output::write_png(
        folder / "smoky/v_0001.png",
        match::test::image_of(cv::Mat(match::test::height, match::test::width, CV_32FC3, cv::Scalar::all(0))));
    const std::string smoky = (folder / "smoky/v_0001.png").string(), clear = (folder / "clear/v_0001.png").string();
    EXPECT_EQ(faults(), std::vector<std::string>{smoky + ": has no frame to compare with " + clear +
                                                 ": 0 cannot be read, 1 are not measurable"});
}

TEST_F(Pairs, OfOtherShapesAreRefused) {
    add("smoky/a.png", 1, 0.2);
    const cv::Mat narrow = match::test::tissue()(cv::Rect(0, 0, match::test::width / 2, match::test::height)).clone();
    output::write_png(folder / "clear/a.png", match::test::image_of(narrow));
    EXPECT_EQ(faults(), std::vector<std::string>{(folder / "clear/a.png").string() +
                                                 ": its pictures of 160x256 have another shape than those of " +
                                                 (folder / "smoky/a.png").string() + ", 320x256"});
}

TEST(RankedPairs, TellOtherLengthsAndWhatWasLeftOut) {
    const RankedPair pair{.smoky = "a.mp4",
                          .clear = "b.mp4",
                          .frames = 20,
                          .missing = 2,
                          .not_measurable = 3,
                          .smoky_frames = 100,
                          .clear_frames = 120};
    EXPECT_EQ(pair.notes(), (std::vector<std::string>{
                                "a.mp4 and b.mp4: 100 and 120 frames; only the first 100 are compared",
                                "a.mp4 and b.mp4: 2 of 25 frames are left out: a file cannot give them",
                                "a.mp4 and b.mp4: 3 of 25 frames are left out: they are black or not of one view"}));
    RankedPair whole;
    whole.frames = 1;
    whole.smoky_frames = whole.clear_frames = 4;
    EXPECT_TRUE(whole.notes().empty());
}

/// Recordings that are not part of the project; skipped if they are missing.
class RealPairs : public ::testing::Test {
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

TEST_F(RealPairs, SmokyOnesOfPairsRankAboveClearOnes) {
    const fs::path folder = data / "surgery/desmoking-pairs-salazar/datasets/laparoscopy";
    const auto [right, all] = right_of_all(folder / "input", folder / "output");
    EXPECT_GE(all, 15);
    EXPECT_GE(right, 0.9 * all);
}

TEST_F(RealPairs, InputsRankAboveTheirDesmokedOutputs) {
    const fs::path folder = data / "surgery/DeSmoke-LAP/video clips";
    const auto [right, all] = right_of_all(folder / "Input", folder / "DeSmoke-LAP");
    EXPECT_GE(all, 7);
    EXPECT_GE(right, all - 1);  // input_2 has hardly any smoke, and its output no less of it
}

}  // namespace
}  // namespace lapfx::bench
