#include "match/frame/veil_statistics.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "match/picture/colors.h"

namespace lapfx::match {

namespace {

constexpr int dark_window = 15;  // px
constexpr double first_quantile = 0.02, last_quantile = 0.97, low_quantile = 0.1;
constexpr double detail_blur = 1.2;  // px, standard deviation: wider than the noise of a camera
constexpr double least_slope = 0.02, most_slope = 2.0;
constexpr double least_light = 0.02, least_room = 0.05;  // linear
constexpr double lowest = -0.6, highest = 1.1;           // of a statistic
constexpr float luma_weights[3] = {0.114F, 0.587F, 0.299F};

using Counts = std::array<int, 256>;  // pixels by code value

const std::array<float, 256>& linear_table() {
    static const auto table = [] {
        std::array<float, 256> all{};
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = linear_of(static_cast<float>(i));
        return all;
    }();
    return table;
}

/// Linear light below which a share of the pixels is.
double quantile_of(const Counts& counts, int all, double share) {
    const auto wanted = static_cast<int>(share * (all - 1));
    int so_far = 0;
    for (std::size_t code = 0; code < counts.size(); ++code)
        if ((so_far += counts[code]) > wanted) return static_cast<double>(linear_table()[code]);
    return 1.0;
}

double held(double statistic) {
    return std::clamp(statistic, lowest, highest);
}

double loss(double before, double now) {
    return held(1.0 - now / std::max(before, 1e-5));
}

/// The share of the way from what was there to dense smoke.
double rise(double before, double now, double light) {
    return held((now - before) / std::max(light - before, least_room));
}

struct Line {
    double offset = 0.0, slope = 1.0;
};

/// The line frame = offset + slope * baseline through matched quantiles, by least squares.
Line line_of(const Appearance::Quantiles& baseline, const Appearance::Quantiles& frame) {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    constexpr double n = Appearance::steps;
    for (std::size_t i = 0; i < baseline.size(); ++i) {
        x += baseline[i], y += frame[i];
        xx += baseline[i] * baseline[i], xy += baseline[i] * frame[i];
    }
    const double below = xx - x * x / n;
    Line line;
    if (below > 1e-9) line.slope = (xy - x * y / n) / below;
    line.offset = (y - line.slope * x) / n;
    line.slope = std::clamp(line.slope, least_slope, most_slope);
    return line;
}

double middle_of(double a, double b, double c) {
    return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

}  // namespace

Appearance AppearanceFinder::find(const cv::Mat& code, const cv::Mat& part) {
    Appearance found;
    const auto& linear = linear_table();
    std::array<Counts, 3> counts{};
    Counts lows{};
    int all = 0;
    double saturation = 0.0, chroma = 0.0;
    least_.create(code.size(), CV_8U);
    luma_.create(code.size(), CV_32F);
    for (int y = 0; y < code.rows; ++y) {
        const auto* p = code.ptr<cv::Vec3b>(y);
        const auto* in = part.ptr<std::uint8_t>(y);
        auto* least = least_.ptr<std::uint8_t>(y);
        auto* luma = luma_.ptr<float>(y);
        for (int x = 0; x < code.cols; ++x) {
            const float b = linear[p[x][0]], g = linear[p[x][1]], r = linear[p[x][2]];
            luma[x] = luma_weights[0] * b + luma_weights[1] * g + luma_weights[2] * r;
            least[x] = 255;  // beyond the part nothing is dark
            if (in[x] == 0) continue;
            least[x] = std::min({p[x][0], p[x][1], p[x][2]});
            const float most = std::max({b, g, r}), range = most - linear[least[x]];
            for (std::size_t k = 0; k < 3; ++k) ++counts[k][p[x][static_cast<int>(k)]];
            ++lows[least[x]];
            saturation += static_cast<double>(range / std::max(most, 1e-3F));
            chroma += static_cast<double>(range);
            ++all;
        }
    }
    if (all == 0) return found;
    for (std::size_t k = 0; k < 3; ++k)
        for (int i = 0; i < Appearance::steps; ++i)
            found.quantiles[k][static_cast<std::size_t>(i)] = quantile_of(
                counts[k], all, first_quantile + (last_quantile - first_quantile) * i / (Appearance::steps - 1));
    found.low = quantile_of(lows, all, low_quantile);
    found.saturation = saturation / all;
    found.chroma = chroma / all;
    cv::Scalar mean, deviation;
    cv::meanStdDev(luma_, mean, deviation, part);
    found.spread = deviation[0];

    cv::erode(least_, least_, cv::getStructuringElement(cv::MORPH_RECT, {dark_window, dark_window}));
    Counts darks{};
    for (int y = 0; y < code.rows; ++y)
        for (int x = 0; x < code.cols; ++x)
            if (part.at<std::uint8_t>(y, x) != 0) ++darks[least_.at<std::uint8_t>(y, x)];
    for (std::size_t i = 0; i < darks.size(); ++i) found.dark += darks[i] * static_cast<double>(linear[i]) / all;

    cv::GaussianBlur(luma_, luma_, {}, detail_blur);
    cv::Sobel(luma_, dx_, CV_32F, 1, 0, 3, 0.125);
    cv::Sobel(luma_, dy_, CV_32F, 0, 1, 3, 0.125);
    cv::magnitude(dx_, dy_, dx_);
    cv::erode(part, inner_, cv::getStructuringElement(cv::MORPH_RECT, {5, 5}));  // the edge of the part is no detail
    found.detail = cv::mean(dx_, inner_)[0];
    return found;
}

VeilStatistics statistics_of(const Appearance& baseline, const Appearance& frame, const cv::Vec3d& light) {
    std::array<double, 3> by_offset{}, by_slope{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Line line = line_of(baseline.quantiles[k], frame.quantiles[k]);
        const double a = light[static_cast<int>(k)];
        by_offset[k] = held(1.0 - a / std::max(a + line.offset / line.slope, least_light));
        by_slope[k] = held(1.0 - line.slope);
    }
    const double least = std::min({light[0], light[1], light[2]});
    return {middle_of(by_offset[0], by_offset[1], by_offset[2]),
            middle_of(by_slope[0], by_slope[1], by_slope[2]),
            rise(baseline.dark, frame.dark, least),
            rise(baseline.low, frame.low, least),
            loss(baseline.saturation, frame.saturation),
            loss(baseline.chroma, frame.chroma),
            loss(baseline.detail, frame.detail),
            loss(baseline.spread, frame.spread)};
}

}  // namespace lapfx::match
