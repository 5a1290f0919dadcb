// Interlaced videos, made of progressive ones by the ffmpeg program, against these and against FFmpeg's bwdif.
#include "media/deinterlacer.h"

#include <fstream>
#include <random>

#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/video.h"
#include "media/clip_index.h"
#include "unit/media/decoder_support.h"

namespace lapfx::media {
namespace {

class DeinterlacerTest : public DecoderTest {
  protected:
    void SetUp() override {
        if (!have_ffmpeg()) GTEST_SKIP() << "no ffmpeg program to make videos with";
        // Textured, and moving by some pixels from field to field.
        make(
            "-f lavfi -i mandelbrot=size=640x480:rate=50:end_scale=0.2 -t 1 -vf "
            "crop=160:128:60+2*n:90+n,format=yuv420p -c:v ffv1 fields.mkv");
        make("-i fields.mkv -vf framestep=2 -c:v ffv1 whole.mkv");
    }
    /// An interlaced video of 25 frames; the field of the top rows comes first, or the other.
    fs::path interlaced(bool top, const std::string& format = "yuv420p") const {
        const std::string order = top ? "tff" : "bff", flag = top ? "tff=1" : "bff=1";
        return make("-i fields.mkv -vf interlace=scan=" + order + ":lowpass=off,format=" + format +
                    " -c:v libx264 -qp 0 -g 8 -x264opts " + flag + " " + order + "_" + format + ".mkv");
    }
    static std::vector<Image> images_of(const fs::path& path) {
        VideoReader video(path);
        std::vector<Image> images(static_cast<std::size_t>(video.info().frames));
        for (std::size_t i = 0; i < images.size(); ++i) EXPECT_TRUE(video.read(static_cast<int>(i), images[i]));
        return images;
    }
    /// Root of the mean square difference, in code values; the first and last frame have no neighbour.
    static double apart(const std::vector<Image>& one, const std::vector<Image>& other) {
        EXPECT_EQ(one.size(), other.size());
        double sum = 0.0, count = 0.0;
        for (std::size_t i = 1; i + 1 < std::min(one.size(), other.size()); ++i)
            for (std::size_t k = 0; k < one[i].pixels.size(); ++k) {
                const double difference = one[i].pixels[k] - other[i].pixels[k];
                sum += difference * difference;
                ++count;
            }
        return std::sqrt(sum / count);
    }
};

TEST_F(DeinterlacerTest, FramesAreThoseOfTheProgressiveVideo) {
    const std::vector<Image> whole = images_of(folder / "whole.mkv");
    for (const bool top : {true, false}) {
        const fs::path path = interlaced(top);
        VideoReader video(path);
        EXPECT_EQ(video.info().frames, 25);
        EXPECT_NEAR(video.info().duration, 1.0, 1e-3);
        EXPECT_EQ(video.info().warning, "");
        EXPECT_EQ(report_clip(path).scan,
                  top ? "interlaced, top field first; deinterlaced" : "interlaced, bottom field first; deinterlaced");
        const std::string name = path.filename().string();
        const double ours = apart(images_of(path), whole);
        const double bwdif =
            apart(images_of(make("-i " + name + " -vf bwdif=mode=send_frame -c:v ffv1 by.mkv")), whole);
        const double comb =
            apart(images_of(make("-i " + name + " -vf setfield=prog -c:v ffv1 -field_order progressive c.mkv")), whole);
        EXPECT_LT(ours, 1.05 * bwdif) << name;
        EXPECT_LT(ours, 0.7 * comb) << name;
    }
}

TEST_F(DeinterlacerTest, WhatStandsStillKeepsEveryRow) {
    make("-i fields.mkv -vf trim=end_frame=1,loop=49:1:0,setpts=N/50/TB -r 50 -c:v ffv1 still.mkv");
    const fs::path path =
        make("-i still.mkv -vf interlace=scan=tff:lowpass=off -c:v libx264 -qp 0 -x264opts tff=1 woven.mkv");
    ASSERT_EQ(report_clip(path).scan, "interlaced, top field first; deinterlaced");
    std::vector<Image> whole = images_of(folder / "still.mkv");
    whole.resize(25);
    EXPECT_EQ(apart(images_of(path), whole), 0.0);
}

TEST_F(DeinterlacerTest, AFrameIsTheSameFromWhereverDecodingStarts) {
    const fs::path path = interlaced(true);
    const std::vector<Bytes> frames = frames_of(path);
    Decoder decoder(path, Layout::planar);
    std::mt19937 random(3);
    Picture picture;
    for (int step = 0; step < 60; ++step) {
        const std::size_t index = random() % frames.size();
        ASSERT_TRUE(decoder.read(static_cast<int>(index), picture));
        ASSERT_EQ(picture.bytes, frames[index]) << index;
    }
}

TEST_F(DeinterlacerTest, ManyBrokenFramesInARowAreSearchedInFewDecodes) {
    make("-f lavfi -i testsrc2=size=160x128:rate=50:duration=2.4,format=yuv420p -c:v ffv1 long.mkv");
    const fs::path path =
        make("-i long.mkv -vf interlace=scan=tff:lowpass=off -c:v libx264 -qp 20 -g 1 -x264opts tff=1 intra.mkv");
    constexpr int first = 5, last = 44, broken = last - first + 1;
    {
        const Decoder whole(path, Layout::planar);
        ASSERT_TRUE(whole.info().interlaced);
        ASSERT_EQ(whole.info().frame_count(), 60);
        const std::vector<SeekPoint>& points = whole.info().index->points;
        ASSERT_EQ(points.size(), 60u) << "every frame can be decoded alone";
        std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
        for (std::size_t i = first; i <= last; ++i) {
            constexpr std::int64_t headers = 64;  // bytes of the container
            const std::int64_t from = points[i].position + headers, to = points[i + 1].position - headers;
            ASSERT_GT(to, from);
            file.seekp(from);
            file << std::string(static_cast<std::size_t>(to - from), '\x5a');
        }
    }
    const std::vector<Bytes> frames = frames_of(path);
    for (const int index : {last, last - 7, first + 1}) {
        Decoder decoder(path, Layout::planar);
        const std::int64_t before = decoder.decoded_packets();
        Picture picture;
        EXPECT_FALSE(decoder.read(index, picture)) << index << " is broken";
        EXPECT_EQ(picture.bytes, frames[first - 1]) << index;
        EXPECT_LT(decoder.decoded_packets() - before, 10 * broken) << index;
    }
    Decoder decoder(path, Layout::planar);
    const std::int64_t before = decoder.decoded_packets();
    Picture picture;
    ASSERT_TRUE(decoder.read(last + 1, picture));
    EXPECT_EQ(picture.bytes, frames[last + 1]) << "the good frame before it is that before the broken ones";
    EXPECT_LT(decoder.decoded_packets() - before, 10 * broken);
}

TEST_F(DeinterlacerTest, AStreamThatBeginsProgressiveIsInterlacedInPlaces) {
    make("-i whole.mkv -vf trim=end_frame=2 -c:v libx264 -bf 0 progressive.ts");
    make(
        "-i fields.mkv -vf interlace=scan=tff:lowpass=off -c:v libx264 -qp 10 -bf 0 -g 8 -x264opts tff=1 "
        "-output_ts_offset 0.08 interlaced.ts");
    const fs::path path =
        folder.write("both.ts", test::read_text(folder / "progressive.ts") + test::read_text(folder / "interlaced.ts"));
    EXPECT_EQ(report_clip(path).scan, "interlaced in places; deinterlaced");
    // With the frame before it a frame is not only of its own rows.
    const std::vector<Image> whole = images_of(folder / "whole.mkv"), both = images_of(path);
    ASSERT_EQ(both.size(), 27u);
    const std::vector<Image> from_third(both.begin() + 2, both.end());
    EXPECT_LT(apart(from_third, whole), 1.05 * apart(images_of(folder / "interlaced.ts"), whole));
}

TEST_F(DeinterlacerTest, TenBitsAreDeinterlacedToo) {
    const std::vector<Image> whole = images_of(folder / "whole.mkv");
    const fs::path path = interlaced(true, "yuv420p10le");
    ASSERT_EQ(report_clip(path).scan, "interlaced, top field first; deinterlaced");
    EXPECT_LT(apart(images_of(path), whole), 1.1 * apart(images_of(interlaced(true)), whole));
}

TEST_F(DeinterlacerTest, ProgressiveFramesAreNotTouched) {
    const ClipReport report = report_clip(folder / "whole.mkv");
    EXPECT_EQ(report.scan, "");
    EXPECT_TRUE(Deinterlacer::can(AV_PIX_FMT_YUV420P));
    EXPECT_TRUE(Deinterlacer::can(AV_PIX_FMT_UYVY422));
    EXPECT_TRUE(Deinterlacer::can(AV_PIX_FMT_P010LE));
    for (const AVPixelFormat format : {AV_PIX_FMT_PAL8, AV_PIX_FMT_MONOBLACK, AV_PIX_FMT_RGB565LE, AV_PIX_FMT_GRAYF32LE,
                                       AV_PIX_FMT_YUV420P10BE, AV_PIX_FMT_VAAPI})
        EXPECT_FALSE(Deinterlacer::can(format)) << format;
}

}  // namespace
}  // namespace lapfx::media
