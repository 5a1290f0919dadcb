#include "bench/measure/puffs.h"

#include <gmock/gmock.h>

#include <fstream>

#include "bench/scratch_folder.h"
#include "lapfx/error.h"
#include "support/endoscope.h"

namespace lapfx::bench {
namespace {

constexpr double rate = 25.0;  // of numbered pictures, frames per second

class Puffs : public testing::Test {
  protected:
    std::filesystem::path write(const std::string& text) {
        std::ofstream(folder_.path() / "puffs.csv") << text;
        return folder_.path() / "puffs.csv";
    }
    std::string fault_of(const std::string& text) {
        try {
            known_puffs(write(text));
        } catch (const Error& error) {
            return error.failure() == Failure::bad_input ? error.what() : "another kind of failure";
        }
        return "none";
    }
    ScratchFolder folder_;
};

/// Clear for a second; the veil rises evenly to `most` at 1.6 s and falls to none at 2.6 s.
double veil_at(double time, double most) {
    return most * std::clamp(std::min((time - 1.0) / 0.6, (2.6 - time) / 1.0), 0.0, 1.0);
}

TEST_F(Puffs, TimesOfADrawnPuffAreThoseOfItsVeil) {
    std::vector<Image> frames;
    const Image clear = test::behind_round_view(test::tissue_picture({160, 128}), {80, 64}, 60);
    for (int i = 0; i < 90; ++i)
        frames.push_back(test::behind_round_view(test::veiled(clear, 1.0 - veil_at(i / rate, 0.5)), {80, 64}, 60));
    const std::filesystem::path video = test::write_video(folder_.path(), frames);
    const std::vector<KnownPuff> known =
        known_puffs(write("video,onset,peak,end\n" + video.filename().string() + ",1.06,1.6,2.1\n"));
    ASSERT_EQ(known.size(), 1U);
    EXPECT_EQ(known[0].video, video);
    const MeasuredPuff puff = measured_puff(known[0]);
    EXPECT_TRUE(puff.told);
    for (std::size_t i = 0; i < puff_times.size(); ++i) {
        ASSERT_TRUE(puff.error(i)) << puff_times[i];
        EXPECT_NEAR(*puff.error(i), 0.0, 0.1) << puff_times[i];
    }
}

TEST_F(Puffs, EachTimeCountsWhereItIsKnownByEye) {
    const std::vector<MeasuredPuff> puffs = {
        {.known = {"a", {1.0, 2.0, 3.0}}, .measured = {1.2, 2.21, std::nullopt}, .told = true},
        {.known = {"b", {1.0, 2.0, {}}}, .measured = {0.9, 1.74, 4.0}}};
    EXPECT_NEAR(*puffs[1].error(1), -0.26, 1e-12);
    EXPECT_FALSE(puffs[0].error(2)) << "the curve has no end";
    EXPECT_FALSE(puffs[1].error(2)) << "nobody told it";
    BenchReport report;
    add_puffs(report, puffs);
    ASSERT_EQ(report.rows.size(), 3U);
    EXPECT_EQ(report.rows[1].of.at("puff"), "b");
    EXPECT_EQ(report.rows[0].measured.size(), 3U);
    EXPECT_EQ(report.rows[0].measured.at("told"), 1.0);
    EXPECT_EQ(report.rows[1].measured.at("told"), 0.0);
    EXPECT_NEAR(report.rows[0].measured.at("onset_error_s"), 0.2, 1e-12);
    const std::map<std::string, double> counts = {
        {"onset_within_200_ms", 2}, {"peak_within_200_ms", 0}, {"end_within_200_ms", 0},
        {"onset_within_250_ms", 2}, {"peak_within_250_ms", 1}, {"end_within_250_ms", 0},
        {"onset_known", 2},         {"peak_known", 2},         {"end_known", 1}};
    EXPECT_EQ(report.rows[2].measured, counts);
    EXPECT_THAT(report.table, testing::HasSubstr("2 of 2  0 of 2  0 of 1"));
    EXPECT_THAT(report.table, testing::HasSubstr("+0.20   +0.21    none"));
    EXPECT_THAT(report.table, testing::HasSubstr("-0.10   -0.26       -"));
}

TEST_F(Puffs, AFaultNamesItsLine) {
    const std::string head = "video,onset,peak,end\n";
    EXPECT_THAT(fault_of("video,onset\na,1\n"),
                testing::HasSubstr("puffs.csv: line 1: the columns are not video,onset"));
    EXPECT_THAT(fault_of(head), testing::HasSubstr("no video follows"));
    EXPECT_THAT(fault_of(head + "a,1,2\n"), testing::HasSubstr("line 2: has fewer than four values"));
    EXPECT_THAT(fault_of(head + "a,1,2,3\n,1,2,3\n"), testing::HasSubstr("line 3: names no video"));
    EXPECT_THAT(fault_of(head + "a,1,soon,3\n"), testing::HasSubstr("line 2: peak: \"soon\" is no time in s"));
    EXPECT_THAT(fault_of(head + "a,1,2,nan\n"), testing::HasSubstr("end: \"nan\" is no time in s"));
    EXPECT_THAT(fault_of(head + "a,2,1,3\n"), testing::HasSubstr("onset, peak and end do not follow each other"));
    EXPECT_THAT(fault_of(head + "a,,,\n"), testing::HasSubstr("line 2: has no time"));
    EXPECT_THROW(known_puffs(folder_.path() / "none.csv"), Error);
    const std::vector<KnownPuff> puffs = known_puffs(write(head + "a,b.mp4,1,,3\r\n\n"));
    ASSERT_EQ(puffs.size(), 1U);
    EXPECT_EQ(puffs[0].video, folder_.path() / "a,b.mp4");
    EXPECT_EQ(puffs[0].by_eye, (PuffTimes{1.0, std::nullopt, 3.0}));
}

}  // namespace
}  // namespace lapfx::bench
