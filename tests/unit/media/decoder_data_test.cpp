// Clips that are not part of the project; skipped if they are missing. Of many only one in four is looked at, or with
// `tests/run --deep` every one.
#include <algorithm>
#include <opencv2/videoio.hpp>
#include <set>

#include "lapfx/authoring/clip.h"
#include "support/deep.h"
#include "unit/media/decoder_support.h"
#include "unit/organ/fixtures.h"

namespace lapfx::media {
namespace {

class DecoderData : public DecoderTest {
  protected:
    void SetUp() override {
        data = test::data_folder();
        if (data.empty()) GTEST_SKIP() << "no test data";
    }
    std::vector<fs::path> files(const fs::path& under) const {
        static const std::set<std::string> kinds{".mp4", ".mov", ".avi", ".webm", ".mkv",
                                                 ".gif", ".flv", ".wmv", ".png"};
        std::vector<fs::path> found;
        for (const auto& entry : fs::recursive_directory_iterator(data / under))
            if (entry.is_regular_file() && kinds.contains(entry.path().extension().string()))
                found.push_back(entry.path());
        std::sort(found.begin(), found.end());
        return found;
    }
    fs::path data;
};

int frames_by_opencv(const fs::path& file) {
    cv::VideoCapture capture(file.string(), cv::CAP_FFMPEG);
    int count = 0;
    while (capture.isOpened() && capture.grab()) ++count;
    return count;
}

TEST_F(DecoderData, TheFramesToldAreThoseThatDecode) {
    int seen = 0, number = 0;
    for (const char* folder_name : {"smoke", "video"})
        for (const fs::path& file : files(folder_name)) {
            const bool has_two_streams = file.filename() == "nasa_13013.mp4";
            if (number++ % test::one_in(4) != 0 && !has_two_streams) continue;
            const int expected = frames_by_opencv(file);
            if (expected == 0) {  // broken on purpose
                EXPECT_NE(fault(file), "0 faults") << file;
                continue;
            }
            ++seen;
            Decoder decoder(file, Layout::planar);
            // Two video streams: OpenCV takes the first one, we take the one with more pixels.
            const int frames = has_two_streams ? 390 : expected;
            EXPECT_EQ(decoder.info().frame_count(), frames) << file;
            EXPECT_EQ(decoder.info().warning, "") << file;
            Picture picture;
            for (int i = 0; i < decoder.info().frame_count(); ++i)
                if (!decoder.read(i, picture)) ADD_FAILURE() << file << ", frame " << i;
        }
    EXPECT_GT(seen, 30 / test::one_in(4));
}

TEST_F(DecoderData, SurgeryVideosAreTold) {
    int number = 0;
    for (const fs::path& file : files("surgery")) {
        if (file.extension() == ".png" || number++ % test::one_in(4) != 0) continue;
        const ClipReport report = report_clip(file);
        EXPECT_EQ(report.frames, frames_by_opencv(file)) << file;
        EXPECT_FALSE(report.variable_frame_rate) << file;
        EXPECT_GT(report.duration, 0.3) << file;
    }
}

TEST_F(DecoderData, AWebmsOpacityIsTheMatteBesideIt) {
    const fs::path clip = data / "smoke/fire-smoke-video-augmentation/prep_smoke_vid/smoke-0.webm";
    Decoder smoke(clip, Layout::planar);
    Decoder matte(clip.parent_path() / "smoke-0_alpha.mp4", Layout::planar);
    ASSERT_TRUE(smoke.info().alpha);
    ASSERT_EQ(smoke.info().pixel_format, "yuva420p");
    ASSERT_EQ(smoke.info().size, matte.info().size);
    Picture picture, mask;
    for (const int index : {20, 120, 240}) {
        ASSERT_TRUE(smoke.read(index, picture) && matte.read(index, mask));
        const PictureFormat format = smoke.format();
        const std::uint8_t* alpha = picture.bytes.data() + format.color_bytes() + format.chroma_bytes();
        double off = 0.0;
        for (std::size_t i = 0; i < format.alpha_bytes();
             ++i)  // the matte's luma has full range, although the file does not say so
            off += std::abs(static_cast<double>(alpha[i]) - static_cast<double>(mask.bytes[i]));
        EXPECT_LT(off / static_cast<double>(format.alpha_bytes()), 2.0) << index;
    }
}

}  // namespace
}  // namespace lapfx::media
