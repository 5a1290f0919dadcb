// Pictures that a camera has stored lying, made here: an upright picture turned back, and EXIF's number of the turn.
#include "media/orientation.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "lapfx/authoring/video.h"
#include "unit/media/decoder_support.h"

namespace lapfx::media {
namespace {

class OrientationTest : public DecoderTest {
  protected:
    static ReadAt reader_of(const std::string& bytes) {
        return [&bytes](std::int64_t offset, std::size_t size) {
            const std::size_t at = std::min(bytes.size(), static_cast<std::size_t>(offset));
            const std::string part = bytes.substr(at, size);
            return std::vector<std::uint8_t>(part.begin(), part.end());
        };
    }
    static std::string big(std::uint32_t value, int bytes = 4) {
        std::string text;
        for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(value >> (8 * i) & 0xff);
        return text;
    }
    static std::string little(std::uint32_t value, int bytes = 4) {
        const std::string text = big(value, bytes);
        return {text.rbegin(), text.rend()};
    }
    /// A TIFF of two tags, of which the second one is the orientation.
    static std::string exif(std::uint32_t number) {
        return std::string("MM\0\x2a", 4) + big(8) + big(2, 2) + big(0x0100, 2) + big(4, 2) + big(1) + big(7) +
               big(0x0112, 2) + big(3, 2) + big(1) + big(number, 2) + big(0, 2) + big(0);
    }
    static std::string png_chunk(const std::string& name, const std::string& data) {
        std::uint32_t sum = 0xffffffff;
        for (const char byte : name + data) {
            sum ^= static_cast<std::uint8_t>(byte);
            for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ ((sum & 1) != 0 ? 0xedb88320 : 0);
        }
        return big(static_cast<std::uint32_t>(data.size())) + name + data + big(~sum);
    }
    static std::string encoded(const char* extension, const cv::Mat& pixels) {
        std::vector<unsigned char> bytes;
        const std::vector<int> lossless =
            std::string(extension) == ".webp" ? std::vector<int>{cv::IMWRITE_WEBP_QUALITY, 101} : std::vector<int>{};
        EXPECT_TRUE(cv::imencode(extension, pixels, bytes, lossless));
        return {bytes.begin(), bytes.end()};
    }
    static std::string png(const cv::Mat& pixels, std::uint32_t number) {
        std::string file = encoded(".png", pixels);
        return file.insert(file.find("IDAT") - 4, png_chunk("eXIf", exif(number)));
    }
    /// In the extended format, with the EXIF data behind the picture.
    static std::string webp(const cv::Mat& pixels, std::uint32_t number) {
        const std::string file = encoded(".webp", pixels), picture = file.substr(12), tags = exif(number);
        const std::string chunks = "VP8X" + little(10) + std::string("\x08\0\0\0", 4) +
                                   little(static_cast<std::uint32_t>(pixels.cols - 1), 3) +
                                   little(static_cast<std::uint32_t>(pixels.rows - 1), 3) + picture + "EXIF" +
                                   little(static_cast<std::uint32_t>(tags.size())) + tags;
        return "RIFF" + little(static_cast<std::uint32_t>(chunks.size() + 4)) + "WEBP" + chunks;
    }
    static std::string tiff(const cv::Mat& bgr, std::uint32_t number) {
        cv::Mat rgb;
        cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
        const auto bytes = static_cast<std::uint32_t>(rgb.total() * rgb.elemSize());
        const auto tag = [](std::uint32_t name, std::uint32_t type, std::uint32_t count, std::uint32_t value) {
            return little(name, 2) + little(type, 2) + little(count) + little(value);
        };
        constexpr std::uint32_t count = 9, bits_at = 8 + 2 + 12 * count + 4, pixels_at = bits_at + 6;
        return "II" + little(42, 2) + little(8) + little(count, 2) +
               tag(256, 4, 1, static_cast<std::uint32_t>(rgb.cols)) +
               tag(257, 4, 1, static_cast<std::uint32_t>(rgb.rows)) + tag(258, 3, 3, bits_at) + tag(259, 3, 1, 1) +
               tag(262, 3, 1, 2) + tag(273, 4, 1, pixels_at) + tag(274, 3, 1, number) + tag(277, 3, 1, 3) +
               tag(279, 4, 1, bytes) + little(0) + little(8, 2) + little(8, 2) + little(8, 2) +
               std::string(reinterpret_cast<const char*>(rgb.data), bytes);
    }
    /// As it is stored, so that EXIF's `number` turns it upright.
    static cv::Mat lying(const cv::Mat& upright, int number) {
        cv::Mat stored = upright.clone();
        if (number >= 5) stored = stored.t();
        const bool mirror_x = number == 2 || number == 3 || number == 7 || number == 8;
        const bool mirror_y = number == 3 || number == 4 || number == 6 || number == 7;
        if (mirror_x) cv::flip(stored, stored, 1);
        if (mirror_y) cv::flip(stored, stored, 0);
        return stored;
    }
};

TEST_F(OrientationTest, EveryTurnOfEveryFormatIsUndone) {
    cv::Mat upright(16, 24, CV_8UC3, cv::Scalar(60, 170, 60));
    upright(cv::Rect(0, 0, 12, 8)).setTo(cv::Scalar(40, 40, 200));
    upright(cv::Rect(20, 12, 4, 4)).setTo(cv::Scalar(250, 10, 90));
    cv::Mat wanted;
    cv::cvtColor(upright, wanted, cv::COLOR_BGR2RGBA);
    for (std::uint32_t number = 1; number <= 8; ++number) {
        const cv::Mat stored = lying(upright, static_cast<int>(number));
        for (const auto& [name, bytes] : {std::pair{"a.png", png(stored, number)},
                                          {"a.webp", webp(stored, number)},
                                          {"a.tif", tiff(stored, number)}}) {
            folder.write(name, bytes);
            VideoReader video(folder / name);
            Image image;
            ASSERT_TRUE(video.read(0, image)) << name << ' ' << number;
            ASSERT_EQ(video.info().size, glm::ivec2(24, 16)) << name << ' ' << number;
            EXPECT_EQ(cv::norm(wanted, cv::Mat(16, 24, CV_8UC4, image.pixels.data()), cv::NORM_INF), 0)
                << name << ' ' << number;
        }
    }
}

TEST_F(OrientationTest, WhatIsNotSaidOrBrokenIsUpright) {
    const cv::Mat pixels(4, 6, CV_8UC3, cv::Scalar(1, 2, 3));
    const std::string good = png(pixels, 6);
    EXPECT_EQ(exif_orientation(reader_of(good)), 6);
    EXPECT_EQ(exif_orientation(reader_of(webp(pixels, 8))), 8);
    const std::string none = encoded(".png", pixels), wrong = png(pixels, 9), nought = png(pixels, 0);
    for (const std::string* bytes : {&none, &wrong, &nought}) EXPECT_EQ(exif_orientation(reader_of(*bytes)), 1);
    for (const std::string& whole : {good, webp(pixels, 8), tiff(pixels, 3)})
        for (std::size_t size = 0; size < whole.size(); ++size) {
            const std::string cut = whole.substr(0, size);
            const int found = exif_orientation(reader_of(cut));
            EXPECT_TRUE(found >= 1 && found <= 8) << size;
        }
}

}  // namespace
}  // namespace lapfx::media
