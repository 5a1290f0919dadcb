#include "match/picture/colors.h"

#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "lapfx/authoring/srgb.h"

namespace lapfx::match {

namespace {

constexpr int texture_reach = 4;           // px
constexpr double texture_noise = 1.5;      // code values: weaker contrast counts as none
constexpr double texture_strength = 40.0;  // code values for one standard deviation

}  // namespace

float linear_of(float code) {
    return linear_of_srgb(code / 255.0F);
}

float code_of(float linear) {
    return 255.0F * srgb_of_linear(linear);
}

QuickCode::QuickCode() {
    static const auto table = [] {
        std::array<float, steps + 1> all{};
        for (int i = 0; i <= steps; ++i) {
            const double root = static_cast<double>(i) / steps;
            all[static_cast<std::size_t>(i)] = code_of(static_cast<float>(root * root));
        }
        return all;
    }();
    table_ = table.data();
}

cv::Size working_size_of(const Image& image) {
    constexpr int side = 256, least = 16;  // px
    const double scale = std::min(1.0, static_cast<double>(side) / std::max(image.width, image.height));
    return {std::max(least, static_cast<int>(std::lround(image.width * scale))),
            std::max(least, static_cast<int>(std::lround(image.height * scale)))};
}

void shrink(const Image& image, cv::Size size, cv::Mat& into) {
    const cv::Mat whole(image.height, image.width, CV_8UC4, const_cast<std::uint8_t*>(image.pixels.data()));
    cv::Mat small;
    cv::resize(whole, small, size, 0, 0, cv::INTER_AREA);
    cv::cvtColor(small, into, cv::COLOR_RGBA2BGR);
}

void to_linear(const cv::Mat& code, cv::Mat& linear) {
    static const cv::Mat table = [] {
        cv::Mat all(1, 256, CV_32F);
        for (int i = 0; i < 256; ++i) all.at<float>(i) = linear_of(static_cast<float>(i));
        return all;
    }();
    cv::LUT(code, table, linear);
}

void redness_of(const cv::Mat& linear, cv::Mat& redness) {
    const QuickCode quick_code;
    redness.create(linear.size(), CV_32F);
    for (int y = 0; y < linear.rows; ++y) {
        const auto* from = linear.ptr<cv::Vec3f>(y);
        auto* to = redness.ptr<float>(y);
        for (int x = 0; x < linear.cols; ++x) {
            const float blue = quick_code(from[x][0]), green = quick_code(from[x][1]), red = quick_code(from[x][2]);
            to[x] = redness_of_code(red, green, blue);
        }
    }
}

void texture_of(const cv::Mat& code, cv::Mat& texture) {
    cv::Mat luma, mean, square, variance;
    cv::cvtColor(code, luma, cv::COLOR_BGR2GRAY);
    luma.convertTo(luma, CV_32F);
    cv::GaussianBlur(luma, luma, {3, 3}, 0);
    const cv::Size window(2 * texture_reach + 1, 2 * texture_reach + 1);
    cv::blur(luma, mean, window);
    luma -= mean;
    cv::multiply(luma, luma, square);
    cv::blur(square, variance, window);
    variance += texture_noise * texture_noise;
    cv::sqrt(variance, variance);
    cv::divide(luma, variance, luma, texture_strength);
    luma.convertTo(texture, CV_8U, 1.0, plain_texture);
}

}  // namespace lapfx::match
