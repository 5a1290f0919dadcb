// Clips of many codecs and containers, made by the ffmpeg program; skipped where there is none.
#include <gmock/gmock.h>

#include <random>

#include "lapfx/authoring/clip.h"
#include "media/libav.h"
#include "media/playhead.h"
#include "unit/media/decoder_support.h"

namespace lapfx::media {
namespace {

class CodecTest : public DecoderTest {
  protected:
    void SetUp() override {
        if (!have_ffmpeg()) GTEST_SKIP() << "no ffmpeg program to make clips with";
    }
    /// Overwrites a part of a file, in shares of its size, with noise.
    static void damage(const fs::path& path, double from, double to) {
        std::string data = test::read_text(path);
        std::mt19937 random(5);
        const auto size = static_cast<double>(data.size());
        for (auto i = static_cast<std::size_t>(from * size); i < static_cast<std::size_t>(to * size); ++i)
            data[i] = static_cast<char>(random());
        std::ofstream(path, std::ios::binary) << data;
    }
    static void expect_any_order_the_same(const fs::path& path) {
        const std::vector<Bytes> frames = frames_of(path);
        Decoder decoder(path, Layout::planar);
        std::mt19937 random(7);
        Picture picture;
        for (int step = 0; step < 60; ++step) {
            const std::size_t index = random() % frames.size();
            decoder.read(static_cast<int>(index), picture);
            ASSERT_EQ(picture.bytes, frames[index]) << path << ", step " << step << ", frame " << index;
        }
    }
};

struct Made {
    const char* name;
    const char* options;  ///< of the encoder
};

class EveryCodec : public CodecTest, public testing::WithParamInterface<Made> {};

/// ffmpeg's own decoding of a clip, each frame's Y, then Cb and Cr interleaved.
std::vector<Bytes> truth(const std::string& raw, std::size_t frame_bytes) {
    std::vector<Bytes> frames;
    for (std::size_t at = 0; at + frame_bytes <= raw.size(); at += frame_bytes)
        frames.emplace_back(raw.begin() + static_cast<std::ptrdiff_t>(at),
                            raw.begin() + static_cast<std::ptrdiff_t>(at + frame_bytes));
    return frames;
}

TEST_P(EveryCodec, GivesAllFramesExactlyInAnyOrder) {
    const fs::path clip = make(std::string(moving) + "-pix_fmt yuv420p " + GetParam().options + " " + GetParam().name);
    const fs::path raw =
        make(std::string("-i ") + GetParam().name + " -fps_mode passthrough -pix_fmt nv12 -f rawvideo truth.raw");
    const std::vector<Bytes> expected = truth(test::read_text(raw), 64 * 48 * 3 / 2);
    Decoder decoder(clip, Layout::planar);
    ASSERT_EQ(decoder.info().frame_count(), 30);
    ASSERT_EQ(expected.size(), 30u);
    EXPECT_NEAR(decoder.info().duration, 3.0, 0.11);
    EXPECT_EQ(decoder.info().warning, "");
    Picture picture;
    for (int i = 0; i < 30; ++i) {
        EXPECT_TRUE(decoder.read(i, picture)) << i;
        EXPECT_EQ(picture.bytes, expected[static_cast<std::size_t>(i)]) << i;
        EXPECT_NEAR(decoder.info().times[static_cast<std::size_t>(i)], i / 10.0, 1.1e-3) << i;
    }
    expect_any_order_the_same(clip);
}

INSTANTIATE_TEST_SUITE_P(
    Codecs, EveryCodec,
    testing::Values(Made{"h264.mp4", "-c:v libx264 -bf 3 -g 8"}, Made{"h264.mkv", "-c:v libx264 -bf 3 -g 8"},
                    Made{"h264.ts", "-c:v libx264 -bf 3 -g 8"}, Made{"h264.avi", "-c:v libx264 -bf 3 -g 8"},
                    Made{"raw.h264", "-c:v libx264 -bf 3 -g 8"},
                    Made{"open.mp4", "-c:v libx264 -bf 3 -g 8 -x264-params open-gop=1"},
                    Made{"refresh.mp4", "-c:v libx264 -bf 3 -g 8 -x264-params intra-refresh=1"},
                    Made{"hevc.mp4", "-c:v libx265 -x265-params log-level=none:keyint=8:open-gop=1:bframes=3"},
                    Made{"vp9.webm", "-c:v libvpx-vp9 -g 10 -lag-in-frames 20 -auto-alt-ref 1"},
                    Made{"vp8.webm", "-c:v libvpx -g 10 -lag-in-frames 16 -auto-alt-ref 1"},
                    Made{"mpeg4.mp4", "-c:v mpeg4 -bf 2 -g 6"}, Made{"mpeg4.avi", "-c:v mpeg4 -g 6"},
                    Made{"mpeg4_b.avi", "-c:v mpeg4 -bf 2 -g 6"}, Made{"mpeg2.ts", "-c:v mpeg2video -bf 2 -g 6"},
                    Made{"wmv2.wmv", "-c:v wmv2 -g 6"}, Made{"flv.flv", "-c:v flv -g 6"},
                    Made{"ffv1.mkv", "-c:v ffv1 -g 6"}, Made{"y4m.y4m", ""}),
    [](const auto& made) {
        std::string name = made.param.name;
        std::replace(name.begin(), name.end(), '.', '_');
        return name;
    });

TEST_F(CodecTest, OtherFormatsGiveTheSameInAnyOrder) {
    for (const char* options : {"a.gif", "-c:v apng -f apng a.apng", "-c:v qtrle q.mov", "-c:v cinepak c.avi",
                                "-c:v prores_ks p.mov", "-c:v mjpeg m.mov"}) {
        const fs::path clip = make(std::string(moving) + options);
        Decoder decoder(clip, Layout::rgb);
        EXPECT_EQ(decoder.info().frame_count(), 30) << options;
        EXPECT_FALSE(decoder.info().alpha) << options << ": all of it is opaque";
        expect_any_order_the_same(clip);
    }
}

TEST_F(CodecTest, FramesThatAreNeverShownDoNotCount) {
    // Only with a second pass libvpx makes hidden frames that others refer to: 64 packets for 60 frames.
    const std::string encode =
        "-f lavfi -i testsrc2=size=160x120:rate=10:duration=6 -pix_fmt yuv420p -c:v libvpx -auto-alt-ref 1 "
        "-lag-in-frames 16 -b:v 300k -quality good -cpu-used 0 -arnr-maxframes 7 -passlogfile log -pass ";
    make(encode + "1 first.webm");
    // WebM gives the hidden ones the time of the next, IVF a time of their own.
    for (const fs::path& clip : {make(encode + "2 hidden.webm"), make("-i hidden.webm -c copy hidden.ivf")}) {
        Decoder decoder(clip, Layout::planar);
        EXPECT_EQ(decoder.info().frame_count(), 60) << clip;
        Picture picture;
        for (int i = 0; i < decoder.info().frame_count(); ++i) EXPECT_TRUE(decoder.read(i, picture)) << clip << i;
    }
}

TEST_F(CodecTest, VariableFrameRatesAreKept) {
    const fs::path clip =
        make(std::string(moving) + "-vf select='not(mod(n\\,3))+gt(n\\,20)' -fps_mode vfr -c:v libx264 -bf 2 v.mp4");
    const std::vector<double> expected{0.0, 0.3, 0.6, 0.9, 1.2, 1.5, 1.8, 2.1, 2.2, 2.3, 2.4, 2.5, 2.6, 2.7, 2.8, 2.9};
    const Decoder decoder(clip, Layout::planar);
    EXPECT_THAT(decoder.info().times, testing::Pointwise(testing::DoubleNear(1e-3), expected));
    EXPECT_NEAR(decoder.info().duration, 3.0, 1e-3);
}

TEST_F(CodecTest, TimesThatCannotBeMeantAreReplaced) {
    const fs::path slow = make(std::string(moving) + "-vf setpts=N*20000000/TB -fps_mode passthrough -c:v ffv1 s.mkv");
    const Decoder decoder(slow, Layout::planar);
    ASSERT_EQ(decoder.info().frame_count(), 30);
    EXPECT_LE(decoder.info().duration, 60.0);
    EXPECT_GT(decoder.info().times[29], 0.1);
}

struct Kind {
    const char* name;
    const char* options;
    bool corner = true;  ///< whether ffmpeg's own conversion gets the last odd column and row right
};

/// 33 x 17 pixels of one colour; by default sources have even sizes.
constexpr const char* odd_orange =
    "-f lavfi -i color=0xC86432:size=34x18:rate=5:duration=1,format=rgb24,crop=33:17:0:0:exact=1 ";

class EveryPixelFormat : public CodecTest, public testing::WithParamInterface<Kind> {};

TEST_P(EveryPixelFormat, KeepsItsColourInBothLayoutsAtOddSizes) {
    const fs::path clip = make(std::string(odd_orange) + GetParam().options + " " + GetParam().name);
    for (const Layout layout : {Layout::planar, Layout::rgb}) {
        Decoder decoder(clip, layout);
        EXPECT_EQ(decoder.info().size, glm::ivec2(33, 17));
        EXPECT_EQ(decoder.info().frame_count(), 5);
        EXPECT_FALSE(decoder.info().alpha);
        Picture picture;
        ASSERT_TRUE(decoder.read(2, picture));
        const PictureFormat format = decoder.format();
        ASSERT_EQ(picture.bytes.size(), format.bytes());
        const glm::ivec2 last = GetParam().corner ? glm::ivec2(32, 16) : glm::ivec2(28, 12);
        for (const glm::ivec2 at : {glm::ivec2(0), last, glm::ivec2(16, 9)}) {
            const glm::vec3 rgb = layout == Layout::rgb ? rgb_at(picture, format, at)
                                                        : planar_at(picture, format, decoder.info().color, at);
            const glm::vec3 off = glm::abs(rgb - glm::vec3(200.0f, 100.0f, 50.0f));
            EXPECT_LE(std::max({off.r, off.g, off.b}), 4.0f) << rgb.r << ' ' << rgb.g << ' ' << rgb.b << " at " << at.x
                                                             << ' ' << at.y << ", layout " << static_cast<int>(layout);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Formats, EveryPixelFormat,
    testing::Values(
        Kind{"yuv420p.mkv", "-c:v ffv1 -pix_fmt yuv420p", false}, Kind{"yuv444p.mkv", "-c:v ffv1 -pix_fmt yuv444p"},
        Kind{"yuv410p.mkv", "-c:v ffv1 -pix_fmt yuv410p", false},
        Kind{"yuv422p10.mkv", "-c:v ffv1 -pix_fmt yuv422p10le", false},
        Kind{"yuv420p16.mkv", "-c:v ffv1 -pix_fmt yuv420p16le", false}, Kind{"bgra.mkv", "-c:v ffv1 -pix_fmt bgra"},
        Kind{"gbrp10.mkv", "-c:v ffv1 -pix_fmt gbrp10le"}, Kind{"rgb48.mkv", "-c:v rawvideo -pix_fmt rgb48le -f nut"},
        Kind{"pal8.gif", "-vf 'split[a][b];[a]palettegen[p];[b][p]paletteuse'"},
        Kind{"full.mkv", "-vf scale=out_range=full,format=yuv420p -color_range pc -c:v ffv1", false},
        Kind{"full444.avi", "-c:v mjpeg -q:v 1 -pix_fmt yuvj444p"},
        Kind{"bt709.mkv", "-vf scale=out_color_matrix=bt709,format=yuv420p -colorspace bt709 -c:v ffv1", false},
        Kind{"bt2020.mkv", "-vf scale=out_color_matrix=bt2020,format=yuv444p -colorspace bt2020nc -c:v ffv1"}),
    [](const auto& kind) {
        const std::string name = kind.param.name;
        return name.substr(0, name.find('.'));
    });

TEST_F(CodecTest, HighDefinitionThatSaysNothingIsBt709) {
    const std::string source = "-f lavfi -i color=0xC86432:size=64x720:rate=5:duration=0.4,format=rgb24 ";
    const fs::path clip = make(source + "-vf scale=out_color_matrix=bt709,format=yuv420p -c:v rawvideo hd.avi");
    Decoder decoder(clip, Layout::rgb);
    Picture picture;
    ASSERT_TRUE(decoder.read(0, picture));
    const glm::vec3 off = glm::abs(rgb_at(picture, decoder.format(), {9, 300}) - glm::vec3(200.0f, 100.0f, 50.0f));
    EXPECT_LE(std::max({off.r, off.g, off.b}), 4.0f);
}

TEST_F(CodecTest, GrayIsOfFullRange) {
    const fs::path clip = make(
        "-f lavfi -i color=0x808080:size=34x18:rate=5:duration=1,format=gray,crop=33:17:0:0:exact=1 -c:v png -pix_fmt "
        "gray g.mov");
    Decoder planar(clip, Layout::planar), rgb(clip, Layout::rgb);
    Picture picture;
    ASSERT_TRUE(planar.read(1, picture));
    const glm::vec3 gray = planar_at(picture, planar.format(), planar.info().color, {32, 16});
    EXPECT_LE(glm::distance(gray, glm::vec3(128.0f)), 5.0f) << gray.r;
    ASSERT_TRUE(rgb.read(1, picture));
    EXPECT_LE(glm::distance(rgb_at(picture, rgb.format(), {32, 16}), glm::vec3(128.0f)), 5.0f);
}

TEST_F(CodecTest, BothLayoutsShowTheSamePicture) {
    for (const char* options :
         {"-c:v mpeg4 -q:v 2 -pix_fmt yuv420p a.mp4", "-c:v mjpeg -q:v 2 -pix_fmt yuvj420p b.avi"}) {
        const fs::path clip =
            make("-f lavfi -i testsrc2=size=98x72:rate=10:duration=1,format=rgb24,crop=97:71:0:0:exact=1 " +
                 std::string(options));
        Decoder planar(clip, Layout::planar), rgb(clip, Layout::rgb);
        Picture planes, colors;
        ASSERT_TRUE(planar.read(5, planes) && rgb.read(5, colors));
        double sum = 0.0;
        for (int y = 0; y < 71; ++y)
            for (int x = 0; x < 97; ++x) {
                const glm::vec3 off = glm::abs(planar_at(planes, planar.format(), planar.info().color, {x, y}) -
                                               rgb_at(colors, rgb.format(), {x, y}));
                sum += off.r + off.g + off.b;
            }
        EXPECT_LT(sum / (3.0 * 97 * 71), 1.0) << options;
    }
}

class Alpha : public CodecTest, public testing::WithParamInterface<Kind> {};

TEST_P(Alpha, IsGivenWhenPresent) {
    // The left half is opaque, the right half transparent; both are red.
    const fs::path clip =
        make(std::string("-f lavfi -i color=red:size=66x34:rate=5:duration=2,format=rgba,") +
             "geq=r=220:g=30:b=40:a='if(lt(X\\,33)\\,255\\,64+N*8)' " + GetParam().options + " " + GetParam().name);
    for (const Layout layout : {Layout::planar, Layout::rgb}) {
        Decoder decoder(clip, layout);
        EXPECT_TRUE(decoder.info().alpha);
        const PictureFormat format = decoder.format();
        Picture picture;
        for (const int index : {0, 9, 4}) {
            ASSERT_TRUE(decoder.read(index, picture));
            ASSERT_EQ(picture.bytes.size(), format.bytes());
            const std::uint8_t* alpha = picture.bytes.data() + format.color_bytes() + format.chroma_bytes();
            EXPECT_NEAR(alpha[5 * 66 + 10], 255, 4);
            EXPECT_NEAR(alpha[20 * 66 + 60], 64 + index * 8, 6) << index;
            const glm::vec3 rgb = layout == Layout::rgb ? rgb_at(picture, format, {10, 5})
                                                        : planar_at(picture, format, decoder.info().color, {10, 5});
            EXPECT_LE(glm::distance(rgb, glm::vec3(220.0f, 30.0f, 40.0f)), 12.0f) << rgb.r << ' ' << rgb.g;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, Alpha,
                         testing::Values(Kind{"vp8.webm", "-c:v libvpx -pix_fmt yuva420p -auto-alt-ref 0 -b:v 2M -g 4"},
                                         Kind{"vp9.webm", "-c:v libvpx-vp9 -pix_fmt yuva420p -b:v 2M -g 4"},
                                         Kind{"qtrle.mov", "-c:v qtrle -pix_fmt argb"},
                                         Kind{"png.mov", "-c:v png -pix_fmt rgba"},
                                         Kind{"prores.mov", "-c:v prores_ks -pix_fmt yuva444p10le"},
                                         Kind{"ffv1.mkv", "-c:v ffv1 -pix_fmt yuva420p"},
                                         Kind{"apng.apng", "-f apng -c:v apng -pix_fmt rgba"}),
                         [](const auto& kind) {
                             const std::string name = kind.param.name;
                             return name.substr(0, name.find('.'));
                         });

TEST_F(CodecTest, OfATruncatedClipTheFramesThatAreThereAreShown) {
    for (const char* options : {"-c:v libx264 -g 8 -movflags +faststart t.mp4", "-c:v libx264 -g 8 t.mkv",
                                "-c:v mpeg2video t.ts", "-c:v mjpeg -q:v 2 t.avi", "-c:v libvpx t.webm", "t.gif"}) {
        const fs::path clip = make(std::string("-f lavfi -i testsrc2=size=160x120:rate=10:duration=3 ") + options);
        const std::vector<Bytes> whole = frames_of(clip);
        const std::uintmax_t bytes = fs::file_size(clip);
        fs::resize_file(clip, bytes * 6 / 10);
        Decoder decoder(clip, Layout::planar);
        const int count = decoder.info().frame_count();
        EXPECT_GT(count, 8) << options;
        EXPECT_LT(count, 29) << options;
        Picture picture;
        for (int i = 0; i + 4 < count; ++i) {  // the last ones may be cut off or lack the frames that they refer to
            EXPECT_TRUE(decoder.read(i, picture)) << options << ' ' << i;
            EXPECT_EQ(picture.bytes, whole[static_cast<std::size_t>(i)]) << options << ' ' << i;
        }
        const std::string name = clip.extension();
        std::string told;  // MPEG-TS says nowhere how long it is, and FFmpeg knows of a GIF only the frame that is cut
        if (name == ".mp4" || name == ".avi")
            told = "frames " + std::to_string(count + 1) + " to 30 could not be decoded: the file ends early";
        if (name == ".gif") told = "frame " + std::to_string(count + 1) + " could not be decoded: the file ends early";
        if (name == ".mkv" || name == ".webm")
            told = "the file ends early: " + std::to_string(bytes * 6 / 10) + " of its " + std::to_string(bytes) +
                   " bytes are there";
        EXPECT_EQ(decoder.info().warning, told) << options;
        expect_any_order_the_same(clip);
    }
}

TEST_F(CodecTest, ClipsThatAreDamagedInTheMiddleGoOn) {
    for (const char* options :
         {"-c:v libx264 -g 8 -movflags +faststart d.mp4", "-c:v libx264 -g 8 d.mkv", "-c:v libx264 -g 8 d.ts",
          "-c:v mpeg4 -g 6 -bf 2 d.mp4", "-c:v mjpeg -q:v 2 d.avi", "-c:v libvpx -g 8 d.webm", "-c:v mpeg4 -bf 2 d.avi",
          "d.gif", "-c:v png d.mov", "-c:v qtrle d.mov"}) {
        const fs::path clip = make(std::string("-f lavfi -i testsrc2=size=160x120:rate=10:duration=6 ") + options);
        const std::vector<Bytes> whole = frames_of(clip);
        damage(clip, 0.45, 0.5);
        Decoder decoder(clip, Layout::planar);
        Picture picture;
        for (int i = 0; i < 20; ++i) {
            EXPECT_TRUE(decoder.read(i, picture)) << options << ' ' << i;
            EXPECT_EQ(picture.bytes, whole[static_cast<std::size_t>(i)]) << options << ' ' << i;
        }
        expect_any_order_the_same(clip);
    }
}

TEST_F(CodecTest, AFrameThatFailsIsTheOneBefore) {
    const fs::path clip = make("-f lavfi -i testsrc2=size=160x120:rate=10:duration=3 -c:v png p.mov");
    const std::vector<Bytes> whole = frames_of(clip);
    damage(clip, 0.48, 0.5);
    Decoder decoder(clip, Layout::planar);
    ASSERT_EQ(decoder.info().frame_count(), 30);
    Picture picture;
    int broken = 0;
    std::size_t last = 0;
    for (int i = 0; i < 30; ++i) {
        const bool good = decoder.read(i, picture);
        if (good) last = static_cast<std::size_t>(i);
        broken += good ? 0 : 1;
        EXPECT_EQ(picture.bytes, whole[last]) << i;
    }
    EXPECT_GE(broken, 1);
    EXPECT_LE(broken, 3);
    EXPECT_EQ(count_decodable_frames(clip).count, 30 - broken);
    EXPECT_EQ(count_decodable_frames(clip).end, decoder.info().duration);
}

TEST_F(CodecTest, WhereTheLastFrameThatDecodesEndsIsTold) {
    const fs::path clip =
        make("-f lavfi -i testsrc2=size=160x120:rate=10:duration=6 -c:v libx264 -g 8 -movflags +faststart e.mp4");
    damage(clip, 0.8, 1.0);
    const ClipReport report = report_clip(clip);
    ASSERT_EQ(report.frames, 60) << "the packets are all there";
    const DecodableFrames found = count_decodable_frames(clip);
    EXPECT_LT(found.count, 55);
    EXPECT_LT(found.end, report.duration - 0.5);
    Decoder decoder(clip, Layout::planar);
    const Loop played = main_loop(decoder.info(), SmokeClip{.file = "e.mp4", .out = found.end});
    EXPECT_EQ(played.first, 0);
    Picture picture;
    EXPECT_TRUE(decoder.read(played.last, picture)) << "out there plays the last one that decodes";
    for (int i = played.last + 1; i < 60; ++i) EXPECT_FALSE(decoder.read(i, picture)) << i;
}

TEST_F(CodecTest, AnotherSizeMidwayIsScaledToTheFirst) {
    for (const char* end : {"ts", "h264"}) {
        const std::string name = end;
        const fs::path small = make(std::string(moving) + "-c:v libx264 -pix_fmt yuv420p small." + name);
        make("-f lavfi -i color=0xC86432:size=96x80:rate=10:duration=1 -c:v libx264 -pix_fmt yuv420p large." + name);
        const fs::path both =
            folder.write("both." + name, test::read_text(small) + test::read_text(folder / ("large." + name)));
        Decoder decoder(both, Layout::rgb);
        ASSERT_EQ(decoder.info().frame_count(), 40);
        EXPECT_EQ(decoder.info().size, glm::ivec2(64, 48));
        EXPECT_NEAR(decoder.info().duration, 4.0, 0.11);
        Picture picture;
        for (const int index : {0, 39, 12, 35}) {
            EXPECT_TRUE(decoder.read(index, picture)) << index;
            ASSERT_EQ(picture.bytes.size(), 64u * 48 * 3);
            if (index >= 30) {
                EXPECT_LE(glm::distance(rgb_at(picture, decoder.format(), {40, 30}), glm::vec3(200.0f, 100.0f, 50.0f)),
                          8.0f);
            }
        }
        expect_any_order_the_same(both);
    }
}

TEST_F(CodecTest, ASingleImageIsAClipOfOneFrame) {
    for (const char* name : {"a.png", "a.jpg", "a.bmp", "a.tiff", "a.webp", "a.gif", "a.mp4"}) {
        const fs::path clip = make(std::string("-f lavfi -i color=0xC86432:size=40x30 -frames:v 1 -pix_fmt ") +
                                   (std::string(name) == "a.jpg"   ? "yuvj420p "
                                    : std::string(name) == "a.gif" ? "rgb8 "
                                                                   : "yuv420p ") +
                                   name);
        Decoder decoder(clip, Layout::planar);
        EXPECT_EQ(decoder.info().frame_count(), 1) << name;
        EXPECT_GT(decoder.info().duration, 0.0) << name;
        Picture picture;
        for (int i = 0; i < 3; ++i) EXPECT_TRUE(decoder.read(0, picture)) << name;
        EXPECT_EQ(picture.bytes.size(), 40u * 30 * 3 / 2) << name;
    }
}

TEST_F(CodecTest, OpenExrHoldsLight) {
    make(
        "-f lavfi -i color=black:size=32x16,format=gbrp,geq=r=51:g=13:b=102 -frames:v 2 -pix_fmt gbrpf32le l_%02d.exr");
    for (const char* name : {"l_01.exr", "l_%02d.exr"}) {
        Decoder decoder(folder / name, Layout::rgb);
        Picture picture;
        ASSERT_TRUE(decoder.read(0, picture)) << name;
        EXPECT_LE(glm::distance(rgb_at(picture, decoder.format(), {5, 5}), glm::vec3(124, 64, 170)), 1.5f) << name;
    }
}

TEST_F(CodecTest, AnimatedPngAndGifPlay) {
    for (const std::string name : {"a.apng", "a.gif"}) {
        const fs::path clip = make(std::string(moving) + "-plays 0 " + name);
        EXPECT_EQ(frames_of(clip).size(), 30u) << name;
        expect_any_order_the_same(clip);
    }
}

TEST_F(CodecTest, FfmpegIsSilentThoughOpencvHasMadeItTalk) {
    const fs::path clip = make(std::string(moving) + "-c:v libx264 -bf 0 -g 10 -pix_fmt yuv420p talks.mkv");
    damage(clip, 0.1, 0.3);
    Decoder decoder(clip, Layout::planar);
    Picture picture;
    testing::internal::CaptureStderr();
    for (const int frame : {29, 0, 15, 2}) {
        av_log_set_level(AV_LOG_ERROR);  // cv::VideoWriter and cv::VideoCapture do the same
        decoder.rest();
        decoder.read(frame, picture);
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(CodecTest, SoundAloneHoldsNoPicture) {
    EXPECT_EQ(fault(make("-f lavfi -i sine=duration=1 -c:a aac s.mp4")), "contains no picture");
    EXPECT_EQ(fault(make("-f lavfi -i sine=duration=1 s.webm")), "contains no picture");
    make("-f lavfi -i color=red:size=32x32 -frames:v 1 cover.png");
    const fs::path cover = make("-i s.mp4 -i cover.png -map 0 -map 1 -c copy -disposition:v:0 attached_pic c.mp4");
    EXPECT_EQ(fault(cover), "contains no picture") << "a cover is no video";
}

TEST_F(CodecTest, WhatComesBeforeAnEditListsStartIsLeftOut) {
    make(std::string(moving) + "-pix_fmt yuv420p -c:v libx264 -g 30 -bf 2 whole.mp4");
    const fs::path cut = make("-ss 1.35 -i whole.mp4 -c copy cut.mp4");
    const Decoder decoder(cut, Layout::planar);
    EXPECT_GE(decoder.info().frame_count(), 16);
    EXPECT_LE(decoder.info().frame_count(), 18);
    EXPECT_EQ(decoder.info().warning, "") << "those frames are not missing";
    expect_any_order_the_same(cut);
}

}  // namespace
}  // namespace lapfx::media
