#include "match/frame/blood_features.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "match/picture/colors.h"

namespace lapfx::match {

namespace {

constexpr double side = 256.0;
constexpr double close = 2.0, near = 5.0, wide = 12.0;  // px
constexpr int haze_reach = 15;                          // px: a window of 31
constexpr float black = 0.003F;                         // linear light, code value 10: what is darker has no colour
constexpr float least_deviation = 0.01F;                // of a logarithm: noise
constexpr float least_weight = 1e-4F;

/// Takes the median of what is in view away.
void center(cv::Mat& figures, const cv::Mat& view) {
    std::vector<float> inside;
    inside.reserve(figures.total());
    for (int y = 0; y < figures.rows; ++y)
        for (int x = 0; x < figures.cols; ++x)
            if (view.at<std::uint8_t>(y, x) != 0) inside.push_back(figures.at<float>(y, x));
    if (inside.empty()) return;
    const auto middle = inside.begin() + static_cast<std::ptrdiff_t>(inside.size() / 2);
    std::nth_element(inside.begin(), middle, inside.end());
    figures -= *middle;
}

/// ln G/R, ln B/R, ln R, less their medians.
std::array<cv::Mat, 3> log_colors(const cv::Mat& code, const cv::Mat& view, const cv::Mat& clear_haze) {
    cv::Mat linear;
    to_linear(code, linear);
    if (!clear_haze.empty()) {
        cv::Mat added = cv::max(haze_of(code, view) - clear_haze, 0.0F), all;
        cv::merge(std::vector<cv::Mat>{added, added, added}, all);
        linear = cv::max(linear - all, 0.0F);
    }
    cv::Mat channels[3], blue, green, red;
    cv::split(linear, channels);
    cv::log(channels[0] + black, blue);
    cv::log(channels[1] + black, green);
    cv::log(channels[2] + black, red);
    std::array<cv::Mat, 3> made{green - red, blue - red, red};
    for (cv::Mat& figures : made) center(figures, view);
    return made;
}

}  // namespace

double unit_of(cv::Size size) {
    return std::max(size.width, size.height) / side;
}

Neighbourhood::Neighbourhood(const cv::Mat& view, double px) : view_(view), outside_(view == 0), px_(px) {
    view.convertTo(weight_, CV_32F, 1.0 / 255.0);
    cv::GaussianBlur(weight_, weight_, {}, px, px, cv::BORDER_CONSTANT);
    weight_ = cv::max(weight_, least_weight);
}

cv::Mat Neighbourhood::mean(const cv::Mat& of) const {
    cv::Mat sum, inside = cv::Mat::zeros(of.size(), CV_32F);
    of.copyTo(inside, view_);
    cv::GaussianBlur(inside, sum, {}, px_, px_, cv::BORDER_CONSTANT);
    cv::Mat mean = sum / weight_;
    mean.setTo(0.0F, outside_);
    return mean;
}

cv::Mat haze_of(const cv::Mat& code, const cv::Mat& view) {
    cv::Mat linear, channels[3], darkest;
    to_linear(code, linear);
    cv::split(linear, channels);
    cv::min(channels[0], channels[1], darkest);
    darkest.setTo(1.0F, view == 0);
    const double unit = unit_of(code.size());
    const int window = 2 * std::max(1, static_cast<int>(std::lround(unit * haze_reach))) + 1;
    cv::erode(darkest, darkest, cv::getStructuringElement(cv::MORPH_RECT, {window, window}));
    return Neighbourhood(view, window / 4.0).mean(darkest);
}

BloodFeatures blood_features(const cv::Mat& code, const cv::Mat& view, const cv::Mat& clear_haze) {
    const double unit = unit_of(code.size());
    const std::array<cv::Mat, 3> colors = log_colors(code, view, clear_haze);
    const std::array<Neighbourhood, 2> inner{{{view, close * unit}, {view, near * unit}}};
    const Neighbourhood outer(view, wide * unit);
    std::array<std::array<cv::Mat, inner.size()>, colors.size()> means;
    BloodFeatures made;
    std::size_t count = 0;
    for (std::size_t of = 0; of < colors.size(); ++of) {
        for (std::size_t i = 0; i < inner.size(); ++i) means[of][i] = inner[i].mean(colors[of]);
        cv::Mat own = colors[of].clone();
        own.setTo(0.0F, view == 0);
        made[count++] = own;
        for (const cv::Mat& mean : means[of]) made[count++] = mean;
        made[count++] = means[of][0] - outer.mean(colors[of]);
    }
    for (const std::size_t of : {std::size_t{0}, colors.size() - 1})
        for (std::size_t i = 0; i < inner.size(); ++i) {
            const cv::Mat& mean = means[of][i];
            cv::Mat deviation = inner[i].mean(colors[of].mul(colors[of])) - mean.mul(mean);
            cv::sqrt(cv::max(deviation, 0.0F), deviation);
            cv::log(deviation + least_deviation, deviation);
            deviation.setTo(0.0F, view == 0);
            made[count++] = deviation;
        }
    return made;
}

}  // namespace lapfx::match
