#include "media/decoder.h"

#include <opencv2/imgcodecs.hpp>
#include <random>

#include "lapfx/authoring/clip.h"
#include "media/clip_file.h"
#include "support/clips.h"
#include "support/open_files.h"
#include "unit/media/decoder_support.h"

namespace lapfx::media {
namespace {

TEST_F(DecoderTest, TellsWhatAClipIs) {
    const Decoder decoder(test::write_clip(folder / "c.avi", 7, {80, 32}, 12.5), Layout::planar);
    const ClipInfo& info = decoder.info();
    EXPECT_EQ(info.size, glm::ivec2(80, 32));
    EXPECT_EQ(info.frame_count(), 7);
    EXPECT_EQ(info.codec, "mjpeg");
    EXPECT_FALSE(info.alpha);
    EXPECT_EQ(info.warning, "");
    EXPECT_NEAR(info.duration, 7 / 12.5, 1e-6);
    for (int i = 0; i < 7; ++i) EXPECT_NEAR(info.times[static_cast<std::size_t>(i)], i / 12.5, 1e-6) << i;
    EXPECT_EQ(info.frame_at(0.0), 0);
    EXPECT_EQ(info.frame_at(0.081), 1);
    EXPECT_EQ(info.frame_at(-1.0), 0);
    EXPECT_EQ(info.frame_at(100.0), 6);
}

TEST_F(DecoderTest, AStopLeavesThePictureAndTheNextReadIsRight) {
    const fs::path clip = test::write_clip(folder / "c.avi", 12);
    const std::vector<Bytes> frames = frames_of(clip);
    Decoder decoder(clip, Layout::planar);
    Picture picture{.bytes = {1, 2, 3}};
    const std::atomic<bool> stop = true;
    for (const int index : {11, 2, 0, 5}) {
        EXPECT_FALSE(decoder.read(index, picture, &stop)) << index;
        EXPECT_EQ(picture.bytes, Bytes({1, 2, 3})) << index;
    }
    EXPECT_TRUE(decoder.read(3, picture));
    EXPECT_EQ(picture.bytes, frames[3]);
}

TEST_F(DecoderTest, AfterARestItGivesTheSameFramesAndHoldsNoFileInBetween) {
    const fs::path clip = test::write_clip(folder / "c.avi", 9);
    const std::vector<Bytes> frames = frames_of(clip);
    const auto before = test::open_files();
    Decoder decoder(clip, Layout::planar);
    EXPECT_EQ(test::open_files(), before + 1);
    Picture picture;
    for (const int index : {4, 5, 0, 8}) {
        decoder.rest();
        EXPECT_TRUE(decoder.rests());
        EXPECT_EQ(test::open_files(), before);
        EXPECT_TRUE(decoder.read(index, picture)) << index;
        EXPECT_EQ(picture.bytes, frames[static_cast<std::size_t>(index)]) << index;
        EXPECT_FALSE(decoder.rests());
    }
    decoder.rest();
    test::write_clip(folder / "other.avi", 12);
    fs::rename(folder / "other.avi", clip);
    EXPECT_FALSE(decoder.read(2, picture)) << "another file under its name";
    EXPECT_EQ(picture.bytes, frames[8]) << "nothing of that is shown";
    fs::remove(clip);
    EXPECT_FALSE(decoder.read(2, picture));
}

TEST_F(DecoderTest, TheSameFileOnceMore) {
    const fs::path clip = test::write_clip(folder / "c.avi", 9);
    const std::vector<Bytes> frames = frames_of(clip);
    const Decoder first(clip, Layout::planar);
    Decoder second(clip, Layout::planar, first.info());
    EXPECT_EQ(second.format(), first.format());
    Picture picture;
    for (const int index : {4, 0, 8}) {
        EXPECT_TRUE(second.read(index, picture));
        EXPECT_EQ(picture.bytes, frames[static_cast<std::size_t>(index)]);
    }
    fs::remove(clip);
    EXPECT_EQ(test::faults_of([&] { Decoder(clip, Layout::planar, first.info()); }),
              std::vector{clip.string() + ": no such file"});
    EXPECT_TRUE(second.read(1, picture)) << "an open file stays, whatever becomes of its name";
    EXPECT_EQ(picture.bytes, frames[1]);
}

TEST_F(DecoderTest, WhatIsNoClipIsNamed) {
    EXPECT_EQ(fault(folder / "none.avi"), "no such file");
    EXPECT_EQ(fault(folder.path()), "is a folder; a video file is needed");
    EXPECT_EQ(fault(folder.write("empty.avi", "")), "is empty");
    EXPECT_EQ(fault("/dev/null"), "is not a plain file");
    EXPECT_EQ(fault(folder.write("text.avi", "This is no video, whatever its name says.\n")), not_decodable);
    EXPECT_EQ(fault(folder.write("noise.mp4", std::string(3000, '\x01'))), not_decodable);
    for (const char* name : {"http://localhost/c.avi", "concat:c.avi|c.avi", "pipe:0", "data:image/gif,x", "-"})
        EXPECT_EQ(fault(name), "no such file") << name;
}

TEST_F(DecoderTest, PlaylistsAndOtherFormatsAreNotFollowed) {
    test::write_clip(folder / "real.avi", 3);
    EXPECT_EQ(fault(folder.write("a.avi", "#EXTM3U\n#EXTINF:1,\nreal.avi\n#EXT-X-ENDLIST\n")),
              "is a playlist; a clip is a single video file");
    EXPECT_EQ(fault(folder.write("b.avi", "ffconcat version 1.0\nfile real.avi\n")),
              "is a playlist; a clip is a single video file");
    // With a byte that no text has, so that FFmpeg guesses the format.
    EXPECT_EQ(
        fault(folder.write("c.avi", std::string("#EXTM3U\n#EXTINF:1,\nreal.avi\n\0#EXT-X-ENDLIST\n", 43)).string()),
        "is a playlist; a clip is a single video file");
    EXPECT_EQ(fault(folder.write("d.avi", std::string("\n#EXTM3U\n#EXTINF:1,\nreal.avi\n\0", 31))), not_decodable);
    EXPECT_EQ(fault(folder.write("e.avi", std::string("\nffconcat version 1.0\nfile real.avi\n\0", 37))),
              not_decodable);
}

/// A GIF's header and nothing else.
std::string gif_header(int width, int height) {
    const auto bytes = [](int n) { return std::string{static_cast<char>(n & 255), static_cast<char>(n >> 8)}; };
    return "GIF89a" + bytes(width) + bytes(height) + std::string("\0\0\0", 3);
}

TEST_F(DecoderTest, MoreThan8KIsRefusedBeforeItIsDecoded) {
    const std::string frame("\x2c\0\0\0\0\x01\0\x01\0\0\x02\x02\x44\x01\0\x3b", 16);
    EXPECT_EQ(fault(folder.write("wide.gif", gif_header(9000, 10) + frame)),
              "is 9000x10 pixels; at most 8192 a side are allowed");
    EXPECT_EQ(fault(folder.write("high.gif", gif_header(10, 65535) + frame)),
              "is 10x65535 pixels; at most 8192 a side are allowed");
}

TEST_F(DecoderTest, AFileThatBreaksWhileItPlaysLeavesTheLastGoodFrame) {
    const fs::path clip = folder / "c.avi";
    {  // noise, so that the file is larger than the part read ahead
        cv::VideoWriter writer(clip.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 10.0,
                               {320, 240});
        cv::Mat noise(240, 320, CV_8UC3);
        cv::RNG random(3);
        for (int i = 0; i < 20; ++i) {
            random.fill(noise, cv::RNG::UNIFORM, 0, 256);
            writer.write(noise);
        }
    }
    ASSERT_GT(fs::file_size(clip), 300'000u);
    const std::vector<Bytes> frames = frames_of(clip);
    Decoder decoder(clip, Layout::planar);
    Picture picture;
    ASSERT_TRUE(decoder.read(3, picture));
    fs::resize_file(clip, 0);
    EXPECT_FALSE(decoder.read(19, picture));
    const auto shown = std::find(frames.begin(), frames.end(), picture.bytes);
    EXPECT_GE(shown - frames.begin(), 3);
    EXPECT_LE(shown - frames.begin(), 10) << "of what had been read ahead, at most";
    for (const int index : {0, 7, 19}) {  // there is nothing left of it
        EXPECT_FALSE(decoder.read(index, picture)) << index;
        EXPECT_EQ(picture.bytes, *shown) << index;
    }
    Picture empty;
    EXPECT_FALSE(decoder.read(0, empty));
    EXPECT_EQ(empty.bytes.size(), decoder.format().bytes());
}

TEST_F(DecoderTest, AnImagesOwnSizeIsEnoughToRefuseIt) {
    const std::string png("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x75\x30\0\0\x2e\xe0\x08\x02\0\0\0", 29);
    for (const char* name : {"large.png", "large.mp4"})
        EXPECT_EQ(fault(folder.write(name, png + std::string(200, '\0'))),
                  "is 30000x12000 pixels; at most 8192 a side are allowed");
}

class SequenceTest : public DecoderTest {
  protected:
    /// A flat image whose grey level is its number.
    void write_image(int number, cv::Size size = {20, 10}) {
        char name[32];
        std::snprintf(name, sizeof name, "s_%03d.png", number);
        cv::imwrite((folder / name).string(), cv::Mat(size, CV_8UC3, cv::Scalar::all(number * 10)));
    }
    const fs::path pattern = folder / "s_%03d.png";
};

TEST_F(SequenceTest, NumberedImagesAreFramesFromTheLowestOnUntilOneIsMissing) {
    for (const int number : {3, 4, 5, 6, 8}) write_image(number);
    Decoder decoder(pattern, Layout::rgb);
    EXPECT_EQ(decoder.info().frame_count(), 4);
    EXPECT_EQ(decoder.info().codec, "png");
    EXPECT_DOUBLE_EQ(decoder.info().duration, 4 / 25.0);
    EXPECT_DOUBLE_EQ(decoder.info().times[3], 3 / 25.0);
    Picture picture;
    for (const int index : {0, 1, 2, 3, 1, 3, 0}) {
        EXPECT_TRUE(decoder.read(index, picture));
        EXPECT_EQ(rgb_at(picture, decoder.format(), {7, 5}), glm::vec3(static_cast<float>((index + 3) * 10)));
    }
    EXPECT_EQ(find_clip("s_%03d.png", folder.path(), {}), pattern);
}

TEST_F(SequenceTest, ABrokenImageRepeatsTheOneBeforeAndOtherSizesAreScaled) {
    for (const int number : {0, 1, 3}) write_image(number);
    folder.write("s_002.png", "no image");
    write_image(4, {40, 30});
    Decoder decoder(pattern, Layout::rgb);
    ASSERT_EQ(decoder.info().frame_count(), 5);
    Picture picture;
    for (const int round : {0, 1}) {
        EXPECT_FALSE(decoder.read(2, picture)) << round;
        EXPECT_EQ(rgb_at(picture, decoder.format(), {7, 5}), glm::vec3(10.0f));
        EXPECT_TRUE(decoder.read(4, picture)) << round;
        EXPECT_EQ(picture.bytes.size(), 3u * 20 * 10);
        EXPECT_EQ(rgb_at(picture, decoder.format(), {7, 5}), glm::vec3(40.0f));
    }
}

TEST_F(SequenceTest, AnImageThatIsGoneIsNotLookedForInEveryFrame) {
    for (int number = 0; number < 6; ++number) write_image(number);
    Decoder decoder(pattern, Layout::rgb);
    for (const int number : {2, 3, 4}) fs::remove(folder / ("s_00" + std::to_string(number) + ".png"));
    Picture picture;
    EXPECT_FALSE(decoder.read(4, picture));
    EXPECT_EQ(rgb_at(picture, decoder.format(), {7, 5}), glm::vec3(10.0f));
    write_image(3);
    EXPECT_FALSE(decoder.read(3, picture)) << "it was looked for once";
    EXPECT_EQ(rgb_at(picture, decoder.format(), {7, 5}), glm::vec3(10.0f));
    EXPECT_TRUE(decoder.read(5, picture));
    EXPECT_EQ(rgb_at(picture, decoder.format(), {7, 5}), glm::vec3(50.0f));
}

TEST_F(SequenceTest, OnlyOneNumberInTheNameOfAFile) {
    write_image(1);
    for (const char* name : {"s_%s.png", "s_%03d%d.png", "s_%n.png", "s_%-3d.png", "s_%", "s_%0d.png", "s_%0999d.png"})
        EXPECT_EQ(fault(folder / name), "no such file") << name;
    fs::create_directory(folder / "0");
    EXPECT_EQ(fault(folder / "%d" / "s_001.png"), "no such file");
    EXPECT_EQ(fault(folder / "t_%03d.png"), "no such file") << "there is none";
}

}  // namespace
}  // namespace lapfx::media
