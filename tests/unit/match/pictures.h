// Pictures whose blood and smoke are known, painted by the formulas that the estimator assumes.
#pragma once

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "match/frame/haze_light.h"
#include "match/picture/colors.h"

namespace lapfx::match::test {

inline constexpr int width = 320, height = 256;

/// Tissue with texture, linear light, CV_32FC3 (blue, green, red): folds of a few pixels and of some forty.
inline cv::Mat tissue(int seed = 1) {
    cv::RNG random(static_cast<std::uint64_t>(seed));
    cv::Mat fine(height / 4, width / 4, CV_32F), coarse(height / 32, width / 32, CV_32F), light;
    random.fill(fine, cv::RNG::UNIFORM, 0.15, 1.0);
    random.fill(coarse, cv::RNG::UNIFORM, 0.25, 1.0);
    cv::resize(fine, fine, {width, height}, 0, 0, cv::INTER_CUBIC);
    cv::resize(coarse, coarse, {width, height}, 0, 0, cv::INTER_CUBIC);
    light = fine.mul(coarse);
    cv::Mat channels[3] = {0.13 * light, 0.14 * light, 0.63 * light}, picture;
    cv::merge(channels, 3, picture);
    return cv::max(picture, 0.002);
}

/// Of its pixels, those that are not 0.
inline double share(const cv::Mat& mask) {
    return static_cast<double>(cv::countNonZero(mask)) / static_cast<double>(mask.total());
}

inline cv::Rect box() {
    return {0, 0, width, height};
}

inline cv::Mat light_of(const HazeLight& light) {
    return light.over({width, height}, box());
}

/// veil: CV_32F, 0..1.
inline cv::Mat veiled(const cv::Mat& picture, const cv::Mat& veil, const cv::Mat& light) {
    cv::Mat made = picture.clone();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            made.at<cv::Vec3f>(y, x) = picture.at<cv::Vec3f>(y, x) * (1.0F - veil.at<float>(y, x)) +
                                       light.at<cv::Vec3f>(y, x) * veil.at<float>(y, x);
    return made;
}

/// A veil that rises from left to right.
inline cv::Mat ramp(double from, double to) {
    cv::Mat veil(height, width, CV_32F);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) veil.at<float>(y, x) = static_cast<float>(from + (to - from) * x / (width - 1));
    return veil;
}

/// A disc of blood as in real frames (145, 7, 10 where bright), which darkens with what is below.
inline void bleed(cv::Mat& picture, cv::Point middle, int radius) {
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (std::hypot(x - middle.x, y - middle.y) > radius) continue;
            cv::Vec3f& p = picture.at<cv::Vec3f>(y, x);
            const float below = p[2] / 0.63F;
            p = {0.004F + 0.006F * below, 0.003F + 0.005F * below, 0.06F + 0.16F * below};
        }
}

inline Image image_of(const cv::Mat& linear) {
    Image image{.width = linear.cols, .height = linear.rows, .pixels = {}, .name = ""};
    for (int y = 0; y < linear.rows; ++y)
        for (int x = 0; x < linear.cols; ++x) {
            const cv::Vec3f& p = linear.at<cv::Vec3f>(y, x);
            for (const int k : {2, 1, 0})
                image.pixels.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(code_of(p[k]), 0.0F, 255.0F))));
            image.pixels.push_back(255);
        }
    return image;
}

inline cv::Mat code_picture(const cv::Mat& linear) {
    cv::Mat code;
    shrink(image_of(linear), linear.size(), code);
    return code;
}

}  // namespace lapfx::match::test
