#include "match/picture/seen_frame.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "match/picture/colors.h"
#include "match/picture/placement.h"
#include "match/picture/traps.h"
#include "match/picture/view.h"

namespace lapfx::match {

namespace {

constexpr int side = 160;             // px of the longer side
constexpr int dark_window = 7;        // px
constexpr double least_light = 10.0;  // code value, mean of the brightest channel: darker pictures show nothing
constexpr double most_between = 0.2;  // s
constexpr double alike = 0.3;         // correlation of textures
constexpr double there = 0.25;        // the same, once the camera's motion is taken out

/// Mean over the view of the darkest value around each pixel, 0..1 (dark channel: He, Sun and Tang 2009).
double dark_channel(const cv::Mat& code, const cv::Mat& view) {
    cv::Mat channels[3], darkest;
    cv::split(code, channels);
    cv::min(channels[0], channels[1], darkest);
    cv::min(darkest, channels[2], darkest);
    cv::erode(darkest, darkest, cv::getStructuringElement(cv::MORPH_RECT, {dark_window, dark_window}));
    return cv::mean(darkest, view)[0] / 255.0;
}

InView shown_in(const cv::Mat& code, const cv::Mat& view) {
    const cv::Scalar mean = cv::mean(code, view);
    if (cv::countNonZero(view) == 0 || std::max({mean[0], mean[1], mean[2]}) < least_light) return InView::dark;
    return trap_of(code, view);
}

}  // namespace

SeenFrame look_at(const Image& image) {
    const double scale = std::min(1.0, static_cast<double>(side) / std::max(image.width, image.height));
    const auto scaled = [scale](int length) { return std::max(8, static_cast<int>(length * scale)); };
    SeenFrame seen;
    shrink(image, {scaled(image.width), scaled(image.height)}, seen.code);
    seen.view = view_of(seen.code);
    seen.in_view = shown_in(seen.code, seen.view);
    texture_of(seen.code, seen.texture);
    seen.haze = dark_channel(seen.code, seen.view);
    seen.reddest = reddest_tenth(seen.code, seen.view);
    return seen;
}

double likeness(const SeenFrame& a, const SeenFrame& b) {
    double ab = 0.0, aa = 1.0, bb = 1.0;
    for (int y = 0; y < a.texture.rows; ++y)
        for (int x = 0; x < a.texture.cols; ++x) {
            if (a.view.at<std::uint8_t>(y, x) == 0) continue;
            const double p = a.texture.at<std::uint8_t>(y, x) - 128.0, q = b.texture.at<std::uint8_t>(y, x) - 128.0;
            ab += p * q;
            aa += p * p;
            bb += q * q;
        }
    return ab / std::sqrt(aa * bb);
}

bool is_cut(const SeenFrame& last, const SeenFrame& now, double seconds) {
    return seconds <= most_between && likeness(last, now) <= alike &&
           another_view(last.texture, now.texture, last.view);
}

bool shows_tissue_of(const SeenFrame& a, const SeenFrame& b) {
    if (likeness(a, b) > alike) return true;
    Placement placement(a.texture, a.view);
    placement.follow(b.texture);
    return placement.likeness() > there;
}

void tell_smoke_from_bag(const SeenFrame& earlier, SeenFrame& seen) {
    if (seen.in_view == InView::bag && earlier.in_view == InView::tissue && shows_tissue_of(earlier, seen))
        seen.in_view = InView::tissue;
}

}  // namespace lapfx::match
