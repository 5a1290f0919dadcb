// Still images: the libraries below are silent, whatever a file holds, and give the pixels that OpenCV gives.
#include "media/image.h"

#include <gtest/gtest.h>
#include <png.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace lapfx::media {
namespace {

using Bytes = std::vector<std::uint8_t>;

cv::Mat pattern(int type) {
    cv::Mat pixels(24, 40, type);
    cv::randu(pixels, 0, pixels.depth() == CV_16U ? 65535 : 255);
    return pixels;
}

Bytes encoded(const char* extension, const cv::Mat& pixels, const std::vector<int>& options = {}) {
    Bytes bytes;
    EXPECT_TRUE(cv::imencode(extension, pixels, bytes, options));
    return bytes;
}

/// The largest difference from what OpenCV makes of it, in code values; -1: it is not decoded.
int apart(const Bytes& bytes) {
    Image image;
    const std::string fault = decode_image(bytes, image);
    EXPECT_EQ(fault, "");
    if (!fault.empty()) return -1;
    cv::Mat wanted = cv::imdecode(bytes, cv::IMREAD_UNCHANGED), rgba;
    if (wanted.depth() == CV_16U) wanted.convertTo(wanted, CV_8U, 1.0 / 257.0);
    cv::cvtColor(wanted, rgba,
                 wanted.channels() == 1   ? cv::COLOR_GRAY2RGBA
                 : wanted.channels() == 3 ? cv::COLOR_BGR2RGBA
                                          : cv::COLOR_BGRA2RGBA);
    EXPECT_EQ(image.width, rgba.cols);
    EXPECT_EQ(image.height, rgba.rows);
    return static_cast<int>(cv::norm(rgba, cv::Mat(rgba.size(), CV_8UC4, image.pixels.data()), cv::NORM_INF));
}

TEST(DecodeImage, GivesWhatOpenCvGives) {
    for (const int type : {CV_8UC1, CV_8UC3, CV_8UC4, CV_16UC1, CV_16UC3, CV_16UC4})
        EXPECT_EQ(apart(encoded(".png", pattern(type))), 0) << type;
    for (const int type : {CV_8UC1, CV_8UC3}) {
        EXPECT_EQ(apart(encoded(".jpg", pattern(type))), 0) << type;
        EXPECT_EQ(apart(encoded(".jpg", pattern(type), {cv::IMWRITE_JPEG_PROGRESSIVE, 1})), 0) << type;
        EXPECT_EQ(apart(encoded(".bmp", pattern(type))), 0) << type;
    }
    EXPECT_EQ(apart(encoded(".webp", pattern(CV_8UC4), {cv::IMWRITE_WEBP_QUALITY, 101})), 0) << "lossless";
}

TEST(DecodeImage, TellsWhatTheFileHas) {
    const auto facts_of = [](const Bytes& bytes) {
        Image image;
        ImageFacts facts;
        EXPECT_EQ(decode_image(bytes, image, facts), "");
        return std::pair(facts.channels, facts.bits);
    };
    EXPECT_EQ(facts_of(encoded(".png", pattern(CV_16UC1))), std::pair(1, 16));
    EXPECT_EQ(facts_of(encoded(".png", pattern(CV_8UC3))), std::pair(3, 8));
    EXPECT_EQ(facts_of(encoded(".png", pattern(CV_8UC4))), std::pair(4, 8));
    EXPECT_EQ(facts_of(encoded(".jpg", pattern(CV_8UC1))), std::pair(1, 8));
    EXPECT_EQ(facts_of(encoded(".jpg", pattern(CV_8UC3))), std::pair(3, 8));
}

/// Means over squares, those at the edges of what is there.
cv::Mat shrunk(const cv::Mat& rgba, int factor) {
    cv::Mat out((rgba.rows + factor - 1) / factor, (rgba.cols + factor - 1) / factor, CV_8UC4);
    for (int y = 0; y < out.rows; ++y)
        for (int x = 0; x < out.cols; ++x) {
            const cv::Rect square =
                cv::Rect(x * factor, y * factor, factor, factor) & cv::Rect(0, 0, rgba.cols, rgba.rows);
            const cv::Scalar mean = cv::mean(rgba(square));
            for (int c = 0; c < 4; ++c) out.at<cv::Vec4b>(y, x)[c] = cv::saturate_cast<std::uint8_t>(mean[c]);
        }
    return out;
}

/// The largest difference from the whole image, shrunk afterwards.
double apart_shrunk(const Bytes& bytes, int longest, int factor) {
    Image whole, image;
    EXPECT_EQ(decode_image(bytes, whole), "");
    EXPECT_EQ(decode_image(bytes, image, longest), "");
    const cv::Mat wanted = shrunk(cv::Mat(whole.height, whole.width, CV_8UC4, whole.pixels.data()), factor);
    EXPECT_EQ(image.width, wanted.cols);
    EXPECT_EQ(image.height, wanted.rows);
    if (image.width != wanted.cols || image.height != wanted.rows) return 256.0;
    return cv::norm(wanted, cv::Mat(wanted.size(), CV_8UC4, image.pixels.data()), cv::NORM_INF);
}

/// A PNG of `pixels` in seven passes: libpng's own writer, because OpenCV's writes none.
Bytes interlaced_png(const cv::Mat& rgba) {
    Bytes bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &bytes,
        [](png_structp to, png_bytep from, std::size_t count) {
            auto& out = *static_cast<Bytes*>(png_get_io_ptr(to));
            out.insert(out.end(), from, from + count);
        },
        nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(rgba.cols), static_cast<png_uint_32>(rgba.rows), 8,
                 PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_ADAM7, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    std::vector<png_bytep> rows;
    for (int y = 0; y < rgba.rows; ++y) rows.push_back(const_cast<png_bytep>(rgba.ptr(y)));
    png_write_info(png, info);
    png_write_image(png, rows.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

TEST(DecodeImage, ALargeOneIsShrunkWhileItIsRead) {
    cv::Mat large(37, 90, CV_8UC4);
    cv::randu(large, 0, 255);
    const std::pair<int, int> limits[] = {{90, 1}, {89, 2}, {45, 2}, {44, 4}, {12, 8}};
    for (const auto& [longest, factor] : limits) {
        EXPECT_EQ(shrink_factor({90, 37}, longest), factor);
        EXPECT_LE(apart_shrunk(encoded(".png", large), longest, factor), 1.0) << longest;
        EXPECT_LE(apart_shrunk(interlaced_png(large), longest, factor), 1.0) << longest;
    }
    cv::Mat smooth;
    cv::GaussianBlur(large, smooth, {0, 0}, 8.0);
    cv::cvtColor(smooth, smooth, cv::COLOR_BGRA2BGR);
    EXPECT_LE(apart_shrunk(encoded(".jpg", smooth, {cv::IMWRITE_JPEG_QUALITY, 100}), 45, 2), 4.0);
    EXPECT_LE(apart_shrunk(encoded(".webp", smooth, {cv::IMWRITE_WEBP_QUALITY, 101}), 45, 2), 4.0);
    EXPECT_LE(apart_shrunk(encoded(".bmp", smooth), 45, 2), 4.0);
    Bytes cut = encoded(".png", large);
    cut.resize(cut.size() / 2);
    Image image;
    EXPECT_EQ(decode_image(cut, image, 45), "cannot be decoded");
    EXPECT_TRUE(image.pixels.empty());
}

/// libpng and libjpeg write their messages to stderr unless told otherwise.
TEST(DecodeImage, WritesNothingToStderr) {
    const std::vector<Bytes> files{
        encoded(".png", pattern(CV_8UC3)),  encoded(".png", pattern(CV_16UC4)),
        encoded(".jpg", pattern(CV_8UC3)),  encoded(".jpg", pattern(CV_8UC1), {cv::IMWRITE_JPEG_PROGRESSIVE, 1}),
        encoded(".webp", pattern(CV_8UC3)), encoded(".bmp", pattern(CV_8UC3))};
    int refused = 0, tried = 0;
    testing::internal::CaptureStderr();
    for (const Bytes& file : files) {
        std::uint32_t random = 1;
        const auto next = [&] { return random = random * 1664525u + 1013904223u; };
        for (int i = 0; i < 150; ++i, ++tried) {
            Bytes broken = file;
            if (i % 3 == 0) broken.resize(1 + next() % file.size());
            for (int k = 0; k < i % 5; ++k)
                broken[(next() >> 8) % broken.size()] = static_cast<std::uint8_t>(next() >> 24);
            Image image;
            const std::string fault = decode_image(broken, image);
            refused += !fault.empty();
            if (!fault.empty()) {
                EXPECT_TRUE(image.pixels.empty()) << fault;
            }
        }
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_GT(refused, tried / 5);
    EXPECT_LT(refused, tried);
}

TEST(DecodeImage, OfAJpegThatIsCutOffThePartThatIsThereIsShown) {
    const cv::Mat pixels = pattern(CV_8UC3);
    Bytes bytes = encoded(".jpg", pixels);
    bytes.resize(bytes.size() * 3 / 4);
    Image image;
    ASSERT_EQ(decode_image(bytes, image), "");
    cv::Mat whole;
    cv::cvtColor(cv::imdecode(encoded(".jpg", pixels), cv::IMREAD_UNCHANGED), whole, cv::COLOR_BGR2RGBA);
    const cv::Mat shown(whole.size(), CV_8UC4, image.pixels.data());
    EXPECT_EQ(cv::norm(whole.rowRange(0, 12), shown.rowRange(0, 12), cv::NORM_INF), 0.0);
}

TEST(AnimatedPictures, AreToldByTheirBeginning) {
    const auto bytes_of = [](const std::string& text) { return Bytes(text.begin(), text.end()); };
    const Bytes still = encoded(".png", pattern(CV_8UC3));
    EXPECT_FALSE(is_animated_png(still));
    Bytes moving = still;
    const Bytes chunk =
        bytes_of(std::string("\0\0\0\x08"
                             "acTL\0\0\0\x02\0\0\0\0"
                             "\0\0\0\0",
                             20));
    moving.insert(moving.begin() + 33, chunk.begin(), chunk.end());  // behind IHDR
    EXPECT_TRUE(is_animated_png(moving));
    EXPECT_FALSE(is_animated_webp(moving));
    const Bytes webp = bytes_of(std::string("RIFF\x20\0\0\0WEBPVP8X\x0a\0\0\0\x02\0\0\0\x0f\0\0\x0f\0\0ANIM\0\0", 36));
    EXPECT_TRUE(is_animated_webp(webp));
    EXPECT_FALSE(is_animated_webp(encoded(".webp", pattern(CV_8UC4), {cv::IMWRITE_WEBP_QUALITY, 101})));
    Image image;
    EXPECT_EQ(decode_image(webp, image), animated_webp);
    for (std::size_t size = 0; size < moving.size(); ++size) {
        is_animated_png(std::span(moving).first(size));
        is_animated_webp(std::span(webp).first(std::min(size, webp.size())));
    }
}

}  // namespace
}  // namespace lapfx::media
