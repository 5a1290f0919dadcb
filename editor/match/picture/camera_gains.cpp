#include "match/picture/camera_gains.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lapfx::match {

namespace {

constexpr float least_light = 0.01F;  // linear: below, noise decides
constexpr float most_change = 0.8F;   // natural logarithm
constexpr int every = 2;              // px
constexpr std::size_t least_pixels = 100, fewest = 50;

/// The mode of sorted numbers: the middle of the narrowest half of the narrowest half, and so on (Bickel and Fruehwirth
/// 2006).
float mode_of(const std::vector<float>& sorted) {
    std::size_t from = 0, count = sorted.size();
    while (count > fewest) {
        const std::size_t half = count / 2;
        std::size_t best = from;
        for (std::size_t i = from; i + half < from + count; ++i)
            if (sorted[i + half] - sorted[i] < sorted[best + half] - sorted[best]) best = i;
        from = best;
        count = half;
    }
    return sorted[from + count / 2];
}

}  // namespace

cv::Vec3f camera_gains(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& part) {
    cv::Vec3f gains(1.0F, 1.0F, 1.0F);
    std::vector<float> changes;
    changes.reserve(static_cast<std::size_t>((frame.cols / every + 1) * (frame.rows / every + 1)));
    for (int k = 0; k < 3; ++k) {
        changes.clear();
        for (int y = 0; y < frame.rows; y += every)
            for (int x = 0; x < frame.cols; x += every) {
                const float b = baseline.at<cv::Vec3f>(y, x)[k], f = frame.at<cv::Vec3f>(y, x)[k];
                if (part.at<std::uint8_t>(y, x) != 0 && b > least_light && f > 0.0F) changes.push_back(std::log(f / b));
            }
        if (changes.size() < least_pixels) continue;
        std::sort(changes.begin(), changes.end());
        gains[k] = std::exp(std::clamp(mode_of(changes), -most_change, most_change));
    }
    return gains;
}

}  // namespace lapfx::match
