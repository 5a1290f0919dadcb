#include "bench/measure/camera.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "output/files.h"

namespace lapfx::bench {

namespace {

constexpr double of_pixels = 256.0;  // wide is the picture that shifts are given for
constexpr double least_shift = 5.0, most_shift = 20.0, most_degrees = 2.0, most_scaling = 0.03;
constexpr double gain_share = 0.7, gain_deviation = 0.05, balance_share = 0.6, balance_deviation = 0.03;
constexpr double least_noise = 0.5, most_noise = 4.0;  // code values
constexpr int least_quality = 45, most_quality = 90;

/// From the pixels of the moved picture to those of the other, whose middles lie on each other.
cv::Matx23d back(const Move& move, cv::Size to, cv::Size from) {
    const cv::Point2f middle(static_cast<float>(to.width - 1) / 2.0F, static_cast<float>(to.height - 1) / 2.0F);
    cv::Matx23d turn = cv::getRotationMatrix2D(middle, move.degrees, move.scale);
    turn(0, 2) += (from.width - to.width) / 2.0 - move.right * to.width;
    turn(1, 2) += (from.height - to.height) / 2.0 - move.down * to.width;
    return turn;
}

}  // namespace

Move draw_move(Random& random, double share) {
    Move move;
    if (!random.chance(share)) return move;
    const double length = random.in(least_shift, most_shift) / of_pixels, angle = random.in(0.0, 2.0 * CV_PI);
    move.right = length * std::cos(angle);
    move.down = length * std::sin(angle);
    move.degrees = random.in(-most_degrees, most_degrees);
    move.scale = random.in(1.0 - most_scaling, 1.0 + most_scaling);
    return move;
}

Shown moved(const Shown& shown, const Move& move, cv::Size size) {
    Shown to;
    const cv::Matx23d matrix = back(move, size, shown.code.size());
    const auto warp = [&](const cv::Mat& from, cv::Mat& into, int how) {
        if (!from.empty()) cv::warpAffine(from, into, matrix, size, how | cv::WARP_INVERSE_MAP, cv::BORDER_REFLECT_101);
    };
    const int colors = move.any() ? cv::INTER_LINEAR : cv::INTER_NEAREST;
    warp(shown.code, to.code, colors);
    warp(shown.veil, to.veil, colors);
    warp(shown.view, to.view, cv::INTER_NEAREST);
    warp(shown.blood, to.blood, cv::INTER_NEAREST);
    return to;
}

cv::Scalar draw_gains(Random& random) {
    cv::Scalar gains = cv::Scalar::all(1.0);
    if (random.chance(gain_share)) gains *= 1.0 + gain_deviation * random.normal();
    if (random.chance(balance_share))
        for (int k = 0; k < 3; ++k) gains[k] *= 1.0 + balance_deviation * random.normal();
    return gains;
}

cv::Scalar drifted(const cv::Scalar& gains, double share) {
    cv::Scalar now = cv::Scalar::all(1.0);
    for (int k = 0; k < 3; ++k) now[k] = std::pow(gains[k], share);
    return now;
}

double draw_noise(Random& random) {
    return random.in(least_noise, most_noise);
}

Image filmed(Random& random, const cv::Mat& code, const cv::Scalar& gains, double noise) {
    Image image{
        .width = code.cols, .height = code.rows, .pixels = std::vector<std::uint8_t>(4 * code.total()), .name = ""};
    std::size_t i = 0;
    for (int y = 0; y < code.rows; ++y)
        for (int x = 0; x < code.cols; ++x, i += 4) {
            const auto& from = code.at<cv::Vec3b>(y, x);
            for (int k = 0; k < 3; ++k)
                image.pixels[i + 2 - static_cast<std::size_t>(k)] =
                    cv::saturate_cast<std::uint8_t>(gains[k] * from[k] + noise * random.normal());
            image.pixels[i + 3] = 255;
        }
    return image;
}

void compress(Random& random, Image& image) {
    const int quality = least_quality + random.below(most_quality - least_quality + 1);
    cv::Mat bgr;
    output::to_bgr(image, bgr);
    std::vector<std::uint8_t> bytes;
    cv::imencode(".jpg", bgr, bytes, {cv::IMWRITE_JPEG_QUALITY, quality});
    cv::Mat rgba(image.height, image.width, CV_8UC4, image.pixels.data());
    cv::cvtColor(cv::imdecode(bytes, cv::IMREAD_COLOR), rgba, cv::COLOR_BGR2RGBA);
}

KnownPicture known(const Shown& shown) {
    KnownPicture picture;
    picture.view = shown.view;
    picture.blood_area = shown.blood & shown.view;
    const double all = std::max(cv::countNonZero(shown.view), 1);
    picture.blood = cv::countNonZero(picture.blood_area) / all;
    picture.veil = cv::mean(shown.veil, shown.view)[0];
    return picture;
}

}  // namespace lapfx::bench
