// HDR and wide gamut videos against ITU-R BT.2408's figures, and against pictures that FFmpeg's zscale has made HDR.
#include "media/sdr_converter.h"

#include <gmock/gmock.h>

#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/video.h"
#include "unit/media/decoder_support.h"
#include "unit/organ/fixtures.h"

namespace lapfx::media {
namespace {

constexpr const char* pq = "-color_trc smpte2084 -color_primaries bt2020 -colorspace bt2020nc -color_range tv ";
constexpr const char* hlg = "-color_trc arib-std-b67 -color_primaries bt2020 -colorspace bt2020nc -color_range tv ";

class SdrConverterTest : public DecoderTest {
  protected:
    void SetUp() override {
        if (!have_ffmpeg()) GTEST_SKIP() << "no ffmpeg program to make videos with";
    }
    static std::string grey(double share) {
        return "-f lavfi -i color=black:size=32x16:rate=10:duration=0.2,format=yuv420p10le,geq=lum=" +
               std::to_string(std::lround(64 + 876 * share)) + ":cb=512:cr=512 -c:v ffv1 ";
    }
    static glm::vec3 first_pixel(const fs::path& video) {
        Image image;
        EXPECT_TRUE(VideoReader(video).read(0, image));
        return {image.pixels.at(0), image.pixels.at(1), image.pixels.at(2)};
    }
    /// The mean and the largest difference of the first frames of two videos.
    static std::pair<double, int> apart(const fs::path& one, const fs::path& other) {
        Image a, b;
        EXPECT_TRUE(VideoReader(one).read(0, a));
        EXPECT_TRUE(VideoReader(other).read(0, b));
        EXPECT_EQ(a.pixels.size(), b.pixels.size());
        double sum = 0.0;
        int most = 0;
        for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i) {
            const int difference = std::abs(a.pixels[i] - b.pixels[i]);
            sum += difference;
            most = std::max(most, difference);
        }
        return {sum / static_cast<double>(a.pixels.size()) * 4.0 / 3.0, most};
    }
};

TEST_F(SdrConverterTest, GreyOfPqIsItsLight) {
    const auto code = [](double light) { return 255.0 * std::pow(std::min(light / 203.0, 1.0), 1.0 / 2.4); };
    for (const auto& [share, light] :
         {std::pair{0.0, 0.0}, {0.1499, 1.0}, {0.3008, 10.0}, {0.5081, 100.0}, {0.5807, 203.0}, {0.7518, 1000.0}}) {
        const glm::vec3 seen = first_pixel(make(grey(share) + pq + "grey.mkv"));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], code(light), 1.0) << light << " cd/m2";
    }
}

TEST_F(SdrConverterTest, GreyOfHlgIsThatOfADisplayOf1000) {
    for (const auto& [share, code] : {std::pair{0.0, 0.0}, {0.5, 143.1}, {0.75, 255.0}, {1.0, 255.0}}) {
        const glm::vec3 seen = first_pixel(make(grey(share) + hlg + "grey.mkv"));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], code, 1.0) << share;
    }
}

TEST_F(SdrConverterTest, WhatZscaleHasMadeOfAnSdrPictureIsThatPicture) {
    const std::string source =
        "-f lavfi -i 'color=black:size=96x64:duration=0.2:rate=10,format=gbrp,geq=r=90+1.4*X:g=15+1.7*Y:b=10+X+Y/2,"
        "scale=out_color_matrix=bt709:out_range=tv,format=yuv444p' ";
    const std::string tags = "-color_trc bt709 -color_primaries bt709 -colorspace bt709 -color_range tv -c:v ffv1 ";
    const fs::path sdr = make(source + tags + "sdr.mkv");
    const std::string from = "-i sdr.mkv -vf zscale=tin=709:min=709:pin=709:rin=tv:";
    const fs::path as_pq =
        make(from + "t=smpte2084:p=2020:m=2020_ncl:npl=203,format=yuv444p10le -c:v ffv1 " + pq + "pq.mkv");
    const auto [pq_mean, pq_most] = apart(sdr, as_pq);
    EXPECT_LT(pq_mean, 1.5);
    EXPECT_LE(pq_most, 6);
    const fs::path wide = make(from +
                               "t=709:p=2020:m=2020_ncl,format=yuv444p10le -c:v ffv1 -color_trc bt2020-10 "
                               "-color_primaries bt2020 -colorspace bt2020nc -color_range tv wide.mkv");
    const auto [wide_mean, wide_most] = apart(sdr, wide);
    EXPECT_LT(wide_mean, 1.0);
    EXPECT_LE(wide_most, 5);
    const fs::path p3 = make(from +
                             "t=709:p=smpte432:m=709,format=yuv444p10le -c:v ffv1 -color_trc bt709 "
                             "-color_primaries smpte432 -colorspace bt709 -color_range tv p3.mkv");
    const auto [p3_mean, p3_most] = apart(sdr, p3);
    EXPECT_LT(p3_mean, 1.0);
    EXPECT_LE(p3_most, 5);

    for (const auto& [path, transfer, primaries] :
         {std::tuple{sdr, "BT.709", "BT.709"},
          {as_pq, "PQ (SMPTE ST 2084), converted to SDR: 203 cd/m2 are white", "BT.2020, converted to BT.709"},
          {wide, "BT.2020", "BT.2020, converted to BT.709"},
          {p3, "BT.709", "Display P3, converted to BT.709"}}) {
        const ClipReport report = report_clip(path);
        EXPECT_EQ(report.transfer, transfer);
        EXPECT_EQ(report.primaries, primaries);
        EXPECT_EQ(report.warning, "") << path;
    }
}

TEST_F(SdrConverterTest, ClipsShowTheSameInBothLayouts) {
    const fs::path clip = make(
        "-f lavfi -i testsrc2=size=64x48:rate=10:duration=0.3,format=yuv420p10le,geq=lum=300+Y*4:cb=480+X:cr=620-X "
        "-c:v ffv1 " +
        std::string(pq) + "c.mkv");
    Decoder planes(clip, Layout::planar), colors(clip, Layout::rgb);
    Picture planar, rgb;
    for (int frame = 0; frame < 3; ++frame) {
        ASSERT_TRUE(planes.read(frame, planar));
        ASSERT_TRUE(colors.read(frame, rgb));
        for (const glm::ivec2 at : {glm::ivec2(8, 8), {31, 20}, {50, 40}})
            EXPECT_LE(glm::distance(planar_at(planar, planes.format(), planes.info().color, at),
                                    rgb_at(rgb, colors.format(), at)),
                      5.0f);
    }
}

TEST_F(SdrConverterTest, WhatIsNotConvertedIsTold) {
    const std::string source = "-f lavfi -i testsrc2=size=64x48:rate=10:duration=0.3 -c:v ffv1 ";
    EXPECT_EQ(VideoReader(make(source + "-color_trc log100 -color_primaries bt2020 log.mkv")).info().warning,
              "its colours are not converted and look wrong: transfer logarithmic, primaries BT.2020");
    EXPECT_EQ(VideoReader(make(source + "-color_trc smpte428 -color_primaries smpte428 xyz.mkv")).info().warning,
              "its colours are not converted and look wrong: transfer SMPTE ST 428, primaries CIE XYZ (SMPTE ST 428)");
    EXPECT_EQ(VideoReader(make(source + "-colorspace ictcp ictcp.mkv")).info().warning,
              "its colours are not converted and look wrong: matrix ICtCp");
    const ClipReport plain = report_clip(make(source + "plain.mkv"));
    EXPECT_EQ(plain.transfer + plain.primaries + plain.warning, "");
}

TEST_F(SdrConverterTest, FourKindsOfOneSceneAreOnePicture) {
    const fs::path data = test::data_folder();
    if (data.empty() || !fs::exists(data / "reports/hdr")) GTEST_SKIP() << "no test data";
    for (const char* name : {"sdr.mp4", "pq.mp4", "hlg.mp4", "wide_gamut_sdr.mp4"}) {
        VideoReader video(data / "reports/hdr" / name);
        Image image;
        ASSERT_TRUE(video.read(10, image));
        const auto mean = [&image](glm::ivec2 from, glm::ivec2 to) {
            glm::dvec3 sum(0.0);
            for (int y = from.y; y < to.y; ++y)
                for (int x = from.x; x < to.x; ++x)
                    for (int c = 0; c < 3; ++c)
                        sum[c] += image.pixels[4 * static_cast<std::size_t>(y * image.width + x) +
                                               static_cast<std::size_t>(c)];
            return sum / static_cast<double>((to.x - from.x) * (to.y - from.y));
        };
        const glm::dvec3 tissue = mean({5, 5}, {130, 235}), blood = mean({150, 115}, {180, 145});
        EXPECT_LE(glm::distance(tissue, glm::dvec3(189, 109, 94)), 3.0) << name;
        EXPECT_LE(glm::distance(blood, glm::dvec3(120, 14, 11)), 4.0) << name;
    }
}

}  // namespace
}  // namespace lapfx::media
