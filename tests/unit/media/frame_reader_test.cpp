#include "media/frame_reader.h"

#include <gmock/gmock.h>

#include "media/clip_index.h"
#include "support/clips.h"
#include "unit/media/decoder_support.h"

namespace lapfx::media {
namespace {

class FrameReaderTest : public DecoderTest {
  protected:
    /// The numbers of all frames from the current position.
    static std::vector<int> numbers(FrameReader& reader, const ClipIndex& index) {
        const libav::Frame frame(libav::made(av_frame_alloc()));
        std::vector<int> all;
        for (int number = -1; reader.next(index, *frame, number, nullptr) == Step::frame;) all.push_back(number);
        return all;
    }
};

TEST_F(FrameReaderTest, OfFramesWithOneTimeTheFirstIsGiven) {
    if (!have_ffmpeg()) GTEST_SKIP() << "no ffmpeg program to make clips with";
    const fs::path clip = make(
        "-f lavfi -i testsrc2=size=64x48:rate=10:duration=1,setpts=floor\\(N/2\\)*0.2/TB "
        "-fps_mode passthrough -enc_time_base 1:10 -c:v ffv1 -g 1 twice.mkv");
    FrameReader reader(clip);
    const ClipIndex index = index_clip(reader.file(), clip, 100);
    ASSERT_EQ(index.times.size(), 5u);
    reader.restart();
    EXPECT_THAT(numbers(reader, index), testing::ElementsAre(0, 1, 2, 3, 4));
    ASSERT_EQ(index.points.size(), 5u);
    ASSERT_TRUE(reader.seek(index.points[2]));
    EXPECT_THAT(numbers(reader, index), testing::ElementsAre(2, 3, 4));
    const std::vector<Bytes> frames = frames_of(clip);
    ASSERT_EQ(frames.size(), 5u);
    Decoder decoder(clip, Layout::planar);
    Picture picture;
    for (const int number : {4, 1, 3, 0, 2}) {
        EXPECT_TRUE(decoder.read(number, picture));
        EXPECT_EQ(picture.bytes, frames[static_cast<std::size_t>(number)]) << number;
    }
}

TEST_F(FrameReaderTest, AFileThatIsNoVideoAnyMoreGivesNothingAndFailsToRestart) {
    const fs::path clip = test::write_clip(folder / "c.avi", 5);
    FrameReader reader(clip);
    const ClipIndex index = index_clip(reader.file(), clip, 100);
    ASSERT_FALSE(index.points.empty());
    folder.write("c.avi", std::string(500, '\x01'));  // in place: it is the file that was opened
    EXPECT_EQ(test::faults_of([&] { reader.restart(); }), std::vector{clip.string() + ": " + not_decodable});
    EXPECT_THAT(numbers(reader, index), testing::IsEmpty());
    EXPECT_FALSE(reader.seek(index.points[0]));
}

}  // namespace
}  // namespace lapfx::media
