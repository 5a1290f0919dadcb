#include "media/clip_index.h"

#include <gmock/gmock.h>

#include <random>

#include "lapfx/authoring/video.h"
#include "unit/media/decoder_support.h"

namespace lapfx::media {
namespace {

class ClipIndexTest : public DecoderTest {
  protected:
    void SetUp() override {
        if (!have_ffmpeg()) GTEST_SKIP() << "no ffmpeg program to make clips with";
    }
    /// Two parts of an MPEG transport stream, 2 s each, joined as recorders do it; the first one's clock begins at
    /// `first`, the second one's at `second`, s.
    fs::path joined(double first, double second) const {
        const auto part = [&](const char* name, double clock) {
            return test::read_text(
                make("-f lavfi -i testsrc2=size=64x48:rate=25:duration=2 -c:v libx264 -g 25 -bf 2 "
                     "-pix_fmt yuv420p -output_ts_offset " +
                     std::to_string(clock) + " " + name));
        };
        folder.write("joined.ts", part("a.ts", first) + part("b.ts", second));
        return folder / "joined.ts";
    }
    /// The frames whose times are not those of 25 frames a second.
    static int uneven(const std::vector<double>& times) {
        int count = 0;
        for (std::size_t i = 0; i < times.size(); ++i)
            count += std::abs(times[i] - static_cast<double>(i) / 25.0) < 1e-3 ? 0 : 1;
        return count;
    }
    static void expect_any_order_the_same(const fs::path& path) {
        const std::vector<Bytes> frames = frames_of(path);
        Decoder decoder(path, Layout::planar);
        std::mt19937 random(7);
        Picture picture;
        for (int step = 0; step < 30; ++step) {
            const std::size_t index = random() % frames.size();
            ASSERT_TRUE(decoder.read(static_cast<int>(index), picture)) << index;
            ASSERT_EQ(picture.bytes, frames[index]) << index;
        }
    }
};

TEST_F(ClipIndexTest, AClockThatStepsBackPlaysOn) {
    for (const double back : {30.0, 61.0, 100.0, 5000.0}) {
        const fs::path path = joined(back + 10.0, 10.0);
        const VideoInfo info = VideoReader(path).info();
        EXPECT_EQ(info.frames, 100) << back;
        EXPECT_NEAR(info.duration, 4.0, 1e-3) << back;
        EXPECT_NEAR(info.frames_per_second, 25.0, 1e-2) << back;
        EXPECT_EQ(uneven(Decoder(path, Layout::planar).info().times), 0) << back;
    }
    const fs::path path = joined(110.0, 10.0);
    EXPECT_EQ(VideoReader(path).info().warning,
              "its clock jumps back by 102 s at 2.000 s; it plays on there without a pause");
    expect_any_order_the_same(path);
}

TEST_F(ClipIndexTest, AClockThatIsSetHoursAheadPlaysOn) {
    const fs::path path = joined(10.0, 18'012.0);
    const VideoInfo info = VideoReader(path).info();
    EXPECT_EQ(info.frames, 100);
    EXPECT_NEAR(info.duration, 4.0, 1e-3);
    EXPECT_EQ(uneven(Decoder(path, Layout::planar).info().times), 0);
    EXPECT_EQ(info.warning, "its clock jumps forward by 5.0 h at 2.000 s; it plays on there without a pause");
    expect_any_order_the_same(path);
}

TEST_F(ClipIndexTest, APauseOfMinutesAndASlideShowStayAsTheyAre) {
    const std::string source = "-f lavfi -i testsrc2=size=64x48:rate=10:duration=1 -vf ";
    const std::string into = " -fps_mode passthrough -enc_time_base 1:10 -c:v ffv1 ";
    const VideoInfo pause = VideoReader(make(source + "'setpts=(N+gte(N\\,5)*6000)*0.1/TB'" + into + "p.mkv")).info();
    EXPECT_NEAR(pause.duration, 601.0, 0.11);
    EXPECT_EQ(pause.warning, "");
    const VideoInfo slides = VideoReader(make(source + "setpts=N*7200/TB" + into + "s.mkv")).info();
    EXPECT_NEAR(slides.duration, 9 * 7200.0, 7200.5);
    EXPECT_EQ(slides.warning, "");
}

TEST_F(ClipIndexTest, WarningsOfOneFileAreOneLine) {
    std::string all;
    add_warning(all, "");
    EXPECT_EQ(all, "");
    add_warning(all, "one");
    add_warning(all, "two");
    add_warning(all, "");
    EXPECT_EQ(all, "one; two");
}

}  // namespace
}  // namespace lapfx::media
