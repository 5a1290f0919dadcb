#include "match/picture/traps.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace lapfx::match {

namespace {

// Found on frames of the Cholec80 clips and of DeSmoke-LAP; tests/unit/match/video/real_frames_test.cpp holds them.
constexpr int lit = 20;                 // code value of the brightest channel: darker colours say nothing
constexpr double least_lit = 0.02;      // of the view
constexpr float red = -0.35F;           // ln(green / red) of tissue
constexpr double least_red = 0.08;      // share of the view
constexpr double trace_of_red = -0.07;  // reddest_tenth: even behind a veil of 0.8 some red is left
constexpr double rim_depth = 0.2;       // of the way from the edge of the view to its middle
constexpr double middle_depth = 0.6;
constexpr double bright_rim = 0.5, white_rim = 0.22;  // brightest channel, 0..1, and saturation: medians of the rim
constexpr double darker_middle = 0.7;                 // of the rim's brightness
constexpr double whole_rim = 0.7;                     // share of the rim's pixels that are brighter than the middle

/// ln(green / red) of code values; one is added to both, so that black is no colour.
float green_to_red(const cv::Vec3b& pixel) {
    return std::log((static_cast<float>(pixel[1]) + 1.0F) / (static_cast<float>(pixel[2]) + 1.0F));
}

int brightest(const cv::Vec3b& pixel) {
    return std::max({pixel[0], pixel[1], pixel[2]});
}

/// ln(green / red) of the lit pixels of a view.
std::vector<float> tints_of(const cv::Mat& code, const cv::Mat& view) {
    std::vector<float> found;
    for (int y = 0; y < code.rows; ++y)
        for (int x = 0; x < code.cols; ++x)
            if (view.at<std::uint8_t>(y, x) != 0 && brightest(code.at<cv::Vec3b>(y, x)) > lit)
                found.push_back(green_to_red(code.at<cv::Vec3b>(y, x)));
    return found;
}

float quantile(std::vector<float>& values, double share) {
    if (values.empty()) return 0.0F;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// A white ring close around a darker middle, all the way round or nearly so.
bool in_a_ring(const cv::Mat& code, const cv::Mat& view) {
    cv::Mat bordered, depth;
    cv::copyMakeBorder(view, bordered, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    cv::distanceTransform(bordered, depth, cv::DIST_L2, 3);
    double deepest = 0.0;
    cv::minMaxLoc(depth, nullptr, &deepest);
    std::vector<float> rim, paleness, middle;
    for (int y = 0; y < code.rows; ++y)
        for (int x = 0; x < code.cols; ++x) {
            if (view.at<std::uint8_t>(y, x) == 0) continue;
            const double at = depth.at<float>(y + 1, x + 1) / deepest;
            if (at > rim_depth && at < middle_depth) continue;
            const cv::Vec3b& p = code.at<cv::Vec3b>(y, x);
            const float most = static_cast<float>(brightest(p)), least = std::min({p[0], p[1], p[2]});
            (at <= rim_depth ? rim : middle).push_back(most / 255.0F);
            if (at <= rim_depth) paleness.push_back((most - least) / std::max(most, 1.0F));
        }
    const float rim_light = quantile(rim, 0.5), middle_light = quantile(middle, 0.5);
    if (rim_light < bright_rim || quantile(paleness, 0.5) > white_rim || middle_light > darker_middle * rim_light)
        return false;
    return quantile(rim, 1.0 - whole_rim) > middle_light;
}

}  // namespace

double reddest_tenth(const cv::Mat& code, const cv::Mat& view) {
    std::vector<float> tints = tints_of(code, view);
    return quantile(tints, 0.1);
}

InView trap_of(const cv::Mat& code, const cv::Mat& view) {
    const int all = cv::countNonZero(view);
    std::vector<float> tints = tints_of(code, view);
    if (static_cast<double>(tints.size()) < least_lit * std::max(all, 1)) return InView::tissue;
    const auto reds = std::count_if(tints.begin(), tints.end(), [](float tint) { return tint < red; });
    if (in_a_ring(code, view)) return InView::trocar;
    return static_cast<double>(reds) < least_red * all && quantile(tints, 0.1) > trace_of_red ? InView::bag
                                                                                              : InView::tissue;
}

}  // namespace lapfx::match
