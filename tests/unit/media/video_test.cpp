// Reading videos as a player shows them, compared with ffmpeg's pictures of the same files and with known colours.
#include "lapfx/authoring/video.h"

#include <fstream>
#include <random>

#include "support/clips.h"
#include "unit/media/decoder_support.h"

namespace lapfx {
namespace {

constexpr const char* quarters = "-f lavfi -i color=red:size=64x48:rate=10:duration=1 ";

class VideoTest : public media::DecoderTest {
  protected:
    void SetUp() override {
        if (!media::have_ffmpeg()) GTEST_SKIP() << "no ffmpeg program to make videos with";
    }

    /// All frames of a video by ffmpeg, upright, RGB.
    std::string by_ffmpeg(const std::filesystem::path& video, const std::string& filter = "") const {
        make("-i '" + video.string() + "' " + filter +
             " -sws_flags bilinear+accurate_rnd+full_chroma_int+full_chroma_inp -fps_mode passthrough -pix_fmt rgb24 "
             "-f rawvideo frames.raw");
        return test::read_text(folder / "frames.raw");
    }
};

glm::ivec3 pixel(const Image& image, int x, int y) {
    const std::size_t at =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
    EXPECT_EQ(image.pixels.at(at + 3), 255);
    return {image.pixels[at], image.pixels[at + 1], image.pixels[at + 2]};
}

int largest_difference(const Image& image, const std::string& rgb, std::size_t frame) {
    const std::size_t pixels = image.pixels.size() / 4;
    if (rgb.size() < (frame + 1) * pixels * 3) return 256;
    int largest = 0;
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const int other = static_cast<unsigned char>(rgb[(frame * pixels + i) * 3 + c]);
            largest = std::max(largest, std::abs(image.pixels[4 * i + c] - other));
        }
    return largest;
}

TEST_F(VideoTest, EveryFrameIsTheOneThatFfmpegShows) {
    const auto path = make(std::string(media::moving) + "-c:v libx264 -g 8 -pix_fmt yuv444p video.mp4");
    VideoReader video(path);
    EXPECT_EQ(video.info().size, glm::ivec2(64, 48));
    EXPECT_EQ(video.info().frames, 30);
    EXPECT_NEAR(video.info().duration, 3.0, 1e-6);
    EXPECT_NEAR(video.info().frames_per_second, 10.0, 1e-6);
    EXPECT_EQ(video.info().codec, "h264");
    EXPECT_EQ(video.info().warning, "");
    const std::string frames = by_ffmpeg(path);
    Image image;
    for (const int frame : {0, 1, 17, 29, 3}) {
        ASSERT_TRUE(video.read(frame, image));
        EXPECT_LE(largest_difference(image, frames, static_cast<std::size_t>(frame)), 2) << frame;
        EXPECT_GT(largest_difference(image, frames, static_cast<std::size_t>((frame + 5) % 30)), 20) << frame;
    }
}

TEST_F(VideoTest, TimesOutsideShowTheFirstAndTheLastFrame) {
    const VideoReader video(make(std::string(media::moving) + "-c:v libx264 video.mp4"));
    EXPECT_EQ(video.frame_at(-3), 0);
    EXPECT_EQ(video.frame_at(0.1499), 1);
    EXPECT_EQ(video.frame_at(99), 29);
    EXPECT_NEAR(video.time_of(12), 1.2, 1e-6);
}

TEST_F(VideoTest, ItIsTurnedAsTheFileAsks) {
    const auto plain = make(std::string(media::moving) + "-c:v libx264 -pix_fmt yuv444p plain.mp4");
    for (const char* degrees : {"90", "180", "270"}) {
        const auto path = make("-i plain.mp4 -c copy -metadata:s:v rotate=" + std::string(degrees) + " turned.mp4");
        VideoReader video(path);
        EXPECT_EQ(video.info().size, std::string(degrees) == "180" ? glm::ivec2(64, 48) : glm::ivec2(48, 64))
            << degrees;
        Image image;
        ASSERT_TRUE(video.read(4, image));
        EXPECT_LE(largest_difference(image, by_ffmpeg(path), 4), 2) << degrees;
    }
}

TEST_F(VideoTest, PixelsThatAreNotSquareAreWidened) {
    const auto path = make(std::string(media::moving) + "-vf setsar=4/3 -c:v libx264 -pix_fmt yuv444p wide.mp4");
    VideoReader video(path);
    EXPECT_EQ(video.info().size, glm::ivec2(85, 48));
    Image image;
    ASSERT_TRUE(video.read(7, image));
    EXPECT_LE(largest_difference(image, by_ffmpeg(path, "-vf scale=85:48"), 7), 12);
    VideoReader high(make(std::string(media::moving) + "-vf setsar=1/2 -c:v libx264 high.mp4"));
    EXPECT_EQ(high.info().size, glm::ivec2(64, 96));
}

TEST_F(VideoTest, ColoursAreThoseOfTheFilesOwnColourSpace) {
    for (const char* space : {"bt709", "smpte170m"}) {
        const std::string matrix = std::string("scale=out_color_matrix=") + space;
        VideoReader video(make(std::string(quarters) + "-vf " + matrix +
                               " -c:v libx264 -crf 1 -pix_fmt yuv444p -colorspace " + space + " red.mp4"));
        Image image;
        ASSERT_TRUE(video.read(3, image));
        const glm::ivec3 c = pixel(image, 30, 20);
        EXPECT_NEAR(c.r, 253, 4) << space;
        EXPECT_NEAR(c.g, 0, 4) << space;
        EXPECT_NEAR(c.b, 0, 4) << space;
    }
}

TEST_F(VideoTest, OpacityIsShownOverBlack) {
    VideoReader image_file(make("-f lavfi -i color=red@0.5:size=8x8,format=rgba -frames:v 1 half.png"));
    Image image;
    ASSERT_TRUE(image_file.read(0, image));
    EXPECT_NEAR(pixel(image, 4, 4).r, 128, 2);
}

TEST_F(VideoTest, NumberedImagesAreAVideo) {
    make(std::string(media::moving) + "-frames:v 6 frame_%03d.png");
    VideoReader video(folder / "frame_%03d.png");
    EXPECT_EQ(video.info().frames, 6);
    EXPECT_NEAR(video.info().frames_per_second, 25.0, 1e-9);
    Image image, before;
    ASSERT_TRUE(video.read(2, before));
    std::filesystem::remove(folder / "frame_004.png");
    EXPECT_FALSE(video.read(3, image)) << "gone";
    EXPECT_EQ(image.pixels, before.pixels) << "the one before it is shown";
}

TEST_F(VideoTest, AStopIsHeeded) {
    const auto path = make(std::string(media::moving) + "-c:v libx264 -g 30 video.mp4");
    std::atomic<bool> stop = true;
    EXPECT_EQ(test::faults_of([&] { VideoReader(path, &stop); }, Failure::runtime),
              std::vector{path.string() + ": was not read to its end"});
    VideoReader video(path);
    Image image{.width = 1, .height = 1, .pixels = {1, 2, 3, 4}, .name = ""};
    EXPECT_FALSE(video.read(29, image, &stop));
    EXPECT_EQ(image.pixels, (std::vector<std::uint8_t>{1, 2, 3, 4})) << "as it was";
}

TEST_F(VideoTest, WhatIsNoVideoIsAFaultThatSaysWhy) {
    const auto text = folder.write("notes.mp4", "no video, just words");
    EXPECT_EQ(test::faults_of([&] { VideoReader{text}; }),
              std::vector{text.string() + ": is not a video that can be decoded"});
    EXPECT_EQ(test::faults_of([&] { VideoReader{folder / "none.mp4"}; }),
              std::vector{(folder / "none.mp4").string() + ": no such file"});
    const auto list = folder.write("list.m3u8", "#EXTM3U\n/etc/passwd\n");
    EXPECT_EQ(test::faults_of([&] { VideoReader{list}; }),
              std::vector{list.string() + ": is a playlist; a clip is a single video file"});
}

/// Any damaged file is read or refused, and every frame has the reported size.
TEST_F(VideoTest, DamagedVideosAreReadOrRefused) {
    const auto path = make(std::string(media::moving) + "-vf setsar=4/3 -c:v libx264 -pix_fmt yuv420p video.mp4");
    const std::string whole = test::read_text(path);
    int read = 0, refused = 0;
    for (unsigned seed = 0; seed < 60; ++seed) {
        std::mt19937 random(seed);
        std::string data = whole;
        for (int i = 0; i < 12; ++i) data[random() % data.size()] = static_cast<char>(random());
        if (seed % 3 == 0) data.resize(random() % data.size());
        folder.write("damaged.mp4", data);
        try {
            VideoReader video(folder / "damaged.mp4");
            Image image;
            for (int frame = 0; frame < video.info().frames; frame += 7) {
                video.read(frame, image);
                ASSERT_EQ(glm::ivec2(image.width, image.height), video.info().size) << seed;
            }
            ++read;
        } catch (const Error& error) {
            EXPECT_EQ(error.failure(), Failure::bad_input) << error.what();
            ++refused;
        }
    }
    EXPECT_GT(read, 5);
    EXPECT_GT(refused, 5);
}

}  // namespace
}  // namespace lapfx
