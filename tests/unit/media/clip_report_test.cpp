#include "lapfx/authoring/clip.h"

#include "support/clips.h"
#include "unit/media/decoder_support.h"

namespace lapfx {
namespace {

class ClipReportTest : public media::DecoderTest {};

TEST_F(ClipReportTest, TellsWhatAVideoHolds) {
    const ClipReport report = report_clip(test::write_clip(folder / "c.avi", 7, {80, 32}, 12.5));
    EXPECT_EQ(report.size, glm::ivec2(80, 32));
    EXPECT_EQ(report.frames, 7);
    EXPECT_NEAR(report.duration, 0.56, 1e-6);
    EXPECT_NEAR(report.frames_per_second, 12.5, 1e-4);
    EXPECT_FALSE(report.variable_frame_rate);
    EXPECT_FALSE(report.alpha);
    EXPECT_EQ(report.codec, "mjpeg");
    EXPECT_EQ(report.warning, "");
}

TEST_F(ClipReportTest, VariableRatesAndRoundedTimesAreToldApart) {
    if (!media::have_ffmpeg()) GTEST_SKIP() << "no ffmpeg program to make clips with";
    const std::string source = "-f lavfi -i testsrc2=size=64x48:rate=30:duration=1 ";
    const ClipReport even = report_clip(make(source + "-c:v ffv1 even.mkv"));  // in steps of 33 and 34 ms
    EXPECT_FALSE(even.variable_frame_rate);
    EXPECT_NEAR(even.frames_per_second, 30.0, 0.1);
    const ClipReport uneven =
        report_clip(make(source + "-vf select='not(between(n\\,10\\,12))' -fps_mode vfr -c:v ffv1 uneven.mkv"));
    EXPECT_TRUE(uneven.variable_frame_rate);
    EXPECT_EQ(uneven.frames, 27);
    EXPECT_NEAR(uneven.frames_per_second, 27.0, 0.1);
}

TEST_F(ClipReportTest, FramesThatCanBeDecodedAreCountedUnlessStopped) {
    const std::filesystem::path clip = test::write_clip(folder / "c.avi", 7, {80, 32}, 12.5);
    std::vector<double> shares;
    EXPECT_EQ(count_decodable_frames(clip, [&](double share) { return shares.push_back(share), true; }).count, 7);
    EXPECT_EQ(shares.back(), 1.0);
    EXPECT_EQ(test::faults_of([&] { count_decodable_frames(clip, [](double share) { return share < 0.5; }); },
                              Failure::runtime),
              std::vector{clip.string() + ": was not read to its end"});
}

TEST_F(ClipReportTest, WhatIsNoVideoIsAFault) {
    EXPECT_EQ(test::faults_of([&] { report_clip(folder / "none.avi"); }),
              std::vector{(folder / "none.avi").string() + ": no such file"});
}

}  // namespace
}  // namespace lapfx
