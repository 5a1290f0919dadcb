#include "output/video_encoder.h"

#include <gmock/gmock.h>

#include "lapfx/authoring/video.h"
#include "output/files.h"
#include "support/file_limit.h"
#include "unit/preset/support.h"

namespace lapfx::output {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr glm::ivec2 size{96, 64};

/// Frame `number` of something that moves: soft waves and, from `noise` on, grain that no encoder can foresee.
Image moving(int number, glm::ivec2 of = size, int noise = 0) {
    Image image{.width = of.x, .height = of.y, .pixels = {}, .name = ""};
    std::uint32_t random = 12345U + static_cast<std::uint32_t>(number);
    for (int y = 0; y < of.y; ++y)
        for (int x = 0; x < of.x; ++x) {
            random = random * 1664525U + 1013904223U;
            const double wave = std::sin(0.11 * x + 0.3 * number) * std::cos(0.09 * y);
            const int grain = noise == 0 ? 0 : static_cast<int>((random >> 16U) % static_cast<std::uint32_t>(noise));
            for (const double value : {110 + 60 * wave, 80 + 30 * wave, 70 - 20 * wave})
                image.pixels.push_back(static_cast<std::uint8_t>(value + grain));
            image.pixels.push_back(static_cast<std::uint8_t>(x));  // alpha, which no video has
        }
    return image;
}

Image flat(glm::ivec3 color, glm::ivec2 of) {
    Image image{.width = of.x, .height = of.y, .pixels = {}, .name = ""};
    for (int i = 0; i < of.x * of.y; ++i)
        for (const int value : {color.r, color.g, color.b, 255})
            image.pixels.push_back(static_cast<std::uint8_t>(value));
    return image;
}

/// Encodes `count` frames.
fs::path encoded(const fs::path& file, const VideoFormat& format, int count, int noise = 0) {
    VideoEncoder encoder(file, format);
    for (int i = 0; i < count; ++i) encoder.add(moving(i, format.size, noise));
    encoder.finish();
    return file;
}

/// The root of the mean square of all differences, codes.
double difference(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        if (i % 4 != 3) sum += (a.pixels[i] - b.pixels[i]) * (a.pixels[i] - b.pixels[i]);
    return std::sqrt(sum / (0.75 * static_cast<double>(a.pixels.size())));
}

/// Reads all frames back: the largest of their differences.
double difference(const fs::path& file, int noise = 0) {
    VideoReader reader(file);
    Image read;
    double largest = 0;
    for (int i = 0; i < reader.info().frames; ++i) {
        EXPECT_TRUE(reader.read(i, read)) << i;
        largest = std::max(largest, difference(read, moving(i, reader.info().size, noise)));
    }
    return largest;
}

TEST(VideoEncoderTest, EachCodecComesBackFromEachContainer) {
    const test::Folder folder;
    for (const CodecRow& row : codec_rows())
        for (const std::string_view extension : row.extensions) {
            SCOPED_TRACE(std::string(row.key) + std::string(extension));
            testing::internal::CaptureStderr();
            const fs::path file = encoded(folder / (std::string(row.key) + std::string(extension)),
                                          {.fps = 30000.0 / 1001, .size = size, .codec = row.codec}, 12);
            EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
            const VideoReader reader(file);
            EXPECT_EQ(reader.info().codec, row.key == "h265" ? "hevc" : row.key);
            EXPECT_EQ(reader.info().size, size);
            EXPECT_EQ(reader.info().frames, 12);
            EXPECT_NEAR(reader.info().frames_per_second, 30000.0 / 1001, 0.08) << "a .mkv has ms";
            for (int i = 0; i < 12; ++i) EXPECT_NEAR(reader.time_of(i), i * 1001 / 30000.0, 6e-4) << i;
            const double found = difference(file);
            EXPECT_LE(found, row.lossless ? 0 : 4);
        }
}

TEST(VideoEncoderTest, MpegFourStandsInWhereThereIsNoH264) {
    const test::Folder folder;
    constexpr std::string_view there[] = {"no such encoder", "mpeg4"}, none[] = {"no such encoder"};
    for (const char* extension : {".mp4", ".mov", ".mkv", ".avi"})
        for (const glm::ivec2 of : {size, glm::ivec2(96, 720)}) {
            SCOPED_TRACE(extension + std::to_string(of.y));
            const fs::path file = folder / (std::string("v") + extension);
            VideoEncoder encoder(file, {.size = of, .encoders = there});
            const Image sent = flat({170, 30, 25}, of);
            for (int i = 0; i < 5; ++i) encoder.add(sent);
            encoder.finish();
            VideoReader reader(file);
            EXPECT_EQ(reader.info().codec, "mpeg4");
            EXPECT_EQ(reader.info().frames, 5);
            Image read;
            EXPECT_TRUE(reader.read(2, read));
            EXPECT_LT(difference(read, sent), 3) << "its colours too, which an .avi cannot name";
        }
    EXPECT_THAT(
        test::faults_of([&] { encoded(folder / "n.mp4", {.size = size, .encoders = none}, 1); }, Failure::runtime),
        ElementsAre(HasSubstr("n.mp4: H.264 cannot be encoded here: FFmpeg has no encoder for it")));
}

TEST(VideoEncoderTest, FramesHaveTheirTimesExactlyAtAnyRate) {
    const test::Folder folder;
    for (const double fps : {0.1, 12.5, 23.976, 30000.0 / 1001, 59.94, 144.0, 999.9, 1000.0})
        for (const Codec codec : {Codec::h264, Codec::h265}) {
            const VideoReader reader(encoded(folder / "v.mp4", {.fps = fps, .size = size, .codec = codec}, 9));
            ASSERT_EQ(reader.info().frames, 9) << fps;
            for (int i = 0; i < 9; ++i) EXPECT_NEAR(reader.time_of(i), i / fps, 1e-6 / fps) << fps << ' ' << i;
            EXPECT_NEAR(reader.info().frames_per_second, fps, 1e-6 * fps);
        }
    EXPECT_NE(test::read_text(encoded(folder / "v.avi", {.size = size}, 9)).find(" bframes=0 "), std::string::npos)
        << "in an .avi, frames have no time but their place";
    for (const double fps : {0.1, 999.9}) {
        const VideoReader reader(encoded(folder / "v.avi", {.fps = fps, .size = size}, 9));
        for (int i = 0; i < 9; ++i) EXPECT_NEAR(reader.time_of(i), i / fps, 1e-6 / fps) << fps << ' ' << i;
    }
}

TEST(VideoEncoderTest, FfvOneKeepsEveryByte) {
    const test::Folder folder;
    for (const char* name : {"v.mkv", "v.avi"}) {
        const fs::path file = encoded(folder / name, {.size = {642, 38}, .codec = Codec::ffv1}, 4, 40);
        VideoReader reader(file);
        Image read;
        for (int i = 0; i < 4; ++i) {
            ASSERT_TRUE(reader.read(i, read));
            Image expected = moving(i, {642, 38}, 40);
            for (std::size_t p = 3; p < expected.pixels.size(); p += 4) expected.pixels[p] = 255;
            EXPECT_EQ(read.pixels, expected.pixels) << name << ' ' << i;
        }
    }
    const VideoFormat format{.size = size, .codec = Codec::ffv1};
    EXPECT_EQ(test::read_text(encoded(folder / "a.mkv", format, 3)),
              test::read_text(encoded(folder / "b.mkv", format, 3)))
        << "and nothing of chance is in the file";
}

TEST(VideoEncoderTest, BetterQualityIsLargerAndCloser) {
    const test::Folder folder;
    constexpr std::string_view mpeg4[] = {"mpeg4"}, h264[] = {"libx264"}, h265[] = {"libx265"};
    constexpr int grain = 60;  // so much that no encoder takes it for noise to leave out
    struct Way {
        Codec codec;
        std::span<const std::string_view> encoders;
    };
    for (const Way& way : {Way{Codec::h264, h264}, Way{Codec::h265, h265}, Way{Codec::h264, mpeg4}}) {
        std::uintmax_t bytes = 0;
        double error = 1e9;
        for (const QualityRow& row : quality_rows()) {
            const fs::path file = encoded(
                folder / "v.mp4",
                {.size = {192, 128}, .codec = way.codec, .quality = row.quality, .encoders = way.encoders}, 20, grain);
            SCOPED_TRACE(std::string(way.encoders[0]) + " " + std::string(row.key));
            const double found = difference(file, grain);
            EXPECT_GT(fs::file_size(file), bytes + bytes / 5);
            EXPECT_LT(found, 0.9 * error);
            bytes = fs::file_size(file);
            error = found;
        }
    }
}

TEST(VideoEncoderTest, AFileOfQuickTimeSaysItsColoursAndBeginsWithItsIndex) {
    const test::Folder folder;
    for (const Codec codec : {Codec::h264, Codec::h265})
        for (const char* name : {"v.mp4", "v.mov"}) {
            const std::string text = test::read_text(encoded(folder / name, {.size = size, .codec = codec}, 3));
            // nclx (MP4) or nclc (QuickTime); primaries 1, transfer 1, matrix 1: BT.709.
            ASSERT_NE(text.find("colrncl"), std::string::npos) << name;
            const std::string tags = text.substr(text.find("colrncl") + 8, 6);
            EXPECT_EQ(tags, std::string("\0\1\0\1\0\1", 6)) << name;
            EXPECT_LT(text.find("moov"), text.find("mdat")) << name;
            EXPECT_NE(text.find(codec == Codec::h264 ? "avc1" : "hvc1"), std::string::npos) << name;
        }
}

TEST(VideoEncoderTest, AFullDiskIsOneClearLineAndNothingStays) {
    const test::Folder folder;
    for (const CodecRow& row : codec_rows())
        for (const rlim_t room : {0, 100, 8192}) {
            const fs::path file = folder / ("v" + std::string(row.extensions[0]));
            SCOPED_TRACE(file.filename().string() + " " + std::to_string(room));
            const test::FileLimit limit(room);
            testing::internal::CaptureStderr();
            const auto write = [&] {
                VideoFile video(file, 25, {size.x, size.y}, row.codec);
                for (int i = 0; i < 60; ++i) video.add(moving(i, size, 80));
                video.finish();
            };
            EXPECT_EQ(test::faults_of(write, Failure::runtime),
                      std::vector{file.string() + ": writing failed: File too large; is the disk full?"});
            EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
            EXPECT_TRUE(fs::is_empty(folder.path()));
        }
}

TEST(VideoEncoderTest, WhatCannotBeEncodedSaysAsWhat) {
    const test::Folder folder;
    testing::internal::CaptureStderr();
    for (const double fps : {0.0, -1.0, 1e-4, 1e5, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_THAT(test::faults_of(
                        [&] {
                            VideoFile(folder / "v.mp4", fps, {96, 64}, Codec::h265);
                        },
                        Failure::runtime),
                    ElementsAre(HasSubstr("frames a second cannot be encoded here as H.265")))
            << fps;
    EXPECT_THAT(test::faults_of(
                    [&] {
                        VideoFile(folder / "v.mp4", 25, {96, 64}, Codec::ffv1);
                    },
                    Failure::runtime),
                ElementsAre(HasSubstr("v.mp4: \"ffv1\" does not go into .mp4; name the file .mkv or .avi")));
    EXPECT_THAT(test::faults_of(
                    [&] {
                        VideoFile(folder / "v.mkv", 25, {95, 64}, Codec::ffv1);
                    },
                    Failure::runtime),
                ElementsAre(HasSubstr("(the sides must be even)")));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
}  // namespace lapfx::output
