#include "match/picture/instruments.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "match/picture/view.h"

namespace lapfx::match {

namespace {

constexpr double grey = 0.28;         // saturation below which tissue does not lie
constexpr double pink = 0.10;         // share by which red leads in tissue, however pale
constexpr double blue = 0.10;         // share by which blue leads over red in plastic, and in no tissue
constexpr double dark_metal = 45.0;   // code value below which colour says nothing
constexpr double much_greyer = 0.5;   // factor on the usual saturation: metal that shines red has less
constexpr int least_instrument = 3;   // px: half of its width; highlights are smaller
constexpr int beside_instrument = 2;  // px
// The sides of a shaft mirror the tissue. They were chosen by eye on real frames; where all is as grey as that, nothing
// grows.
constexpr double mirrored = 0.5, mirrored_of_usual = 0.65;  // saturation; the same as a share of the usual
constexpr double mirrored_pink = 0.4;                       // share by which red leads
constexpr int darkest_mirrored = 18;                        // code value
constexpr int at_edge = 6;                                  // px: a shaft comes in from the edge of the view
constexpr double least_shaft = 0.003;                       // of the view; less is a highlight
constexpr double most_of_width = 1.5;                       // of half of what is found of the width
constexpr int least_side = 6;                               // px, to which it may grow however narrow it is
constexpr double most_grown = 2.5;                          // of its area: if it is more, it grew over tissue

struct Color {
    int most;                      // code value of the brightest channel
    double saturation, red, blue;  // shares of it: to the darkest, by which red leads, and by which blue is over red
};

Color color_of(const cv::Vec3b& bgr) {
    const int most = std::max({bgr[0], bgr[1], bgr[2]}), least = std::min({bgr[0], bgr[1], bgr[2]});
    const double by = 1.0 / std::max(most, 1);
    return {most, (most - least) * by, (bgr[2] - std::max(bgr[0], bgr[1])) * by, (bgr[0] - bgr[2]) * by};
}

/// The pixels of `view` whose colour is as `is` says.
template <class Is>
cv::Mat colored(const cv::Mat& code, const cv::Mat& view, const Is& is) {
    cv::Mat found(code.size(), CV_8U);
    for (int y = 0; y < code.rows; ++y) {
        const auto* from = code.ptr<cv::Vec3b>(y);
        auto* to = found.ptr<std::uint8_t>(y);
        for (int x = 0; x < code.cols; ++x) to[x] = is(color_of(from[x])) ? 255 : 0;
    }
    return found & view;
}

/// The median saturation of what is bright enough to have one.
double usual_saturation(const cv::Mat& code, const cv::Mat& view) {
    std::vector<double> all;
    for (int y = 0; y < code.rows; ++y)
        for (int x = 0; x < code.cols; ++x) {
            const Color color = color_of(code.at<cv::Vec3b>(y, x));
            if (view.at<std::uint8_t>(y, x) != 0 && color.most > dark_metal) all.push_back(color.saturation);
        }
    if (all.empty()) return 0.0;
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return *middle;
}

/// One shaft, CV_8U 255, with its sides.
cv::Mat with_sides(const cv::Mat& shaft, const cv::Mat& greyish) {
    cv::Mat depth, wide = shaft.clone();
    cv::distanceTransform(shaft, depth, cv::DIST_L2, cv::DIST_MASK_3);
    double half = 0.0;
    cv::minMaxLoc(depth, nullptr, &half);
    const int sides = std::max(least_side, static_cast<int>(std::lround(most_of_width * half)));
    const cv::Mat within = greyish | shaft;
    for (int step = 0; step < sides; ++step) {
        cv::dilate(wide, wide, cv::Mat());
        wide &= within;
    }
    return cv::countNonZero(wide) <= most_grown * cv::countNonZero(shaft) ? wide : shaft;
}

/// The sides of all shafts that come in from the edge of the view.
void add_sides(cv::Mat& found, const cv::Mat& view, const cv::Mat& greyish) {
    cv::Mat inside, labels;
    cv::erode(view, inside, disc(at_edge), {-1, -1}, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    const int count = cv::connectedComponents(found, labels, 8, CV_32S);
    const double least = least_shaft * cv::countNonZero(view);
    for (int label = 1; label < count; ++label) {
        const cv::Mat shaft = labels == label;
        if (cv::countNonZero(shaft) >= least && cv::countNonZero(shaft & ~inside) > 0)
            found |= with_sides(shaft, greyish);
    }
}

}  // namespace

cv::Mat instruments_of(const cv::Mat& code, const cv::Mat& view) {
    const double usual = usual_saturation(code, view);
    cv::Mat found = colored(code, view, [usual](const Color& c) {
        const bool greyer = c.saturation < grey && (c.saturation < much_greyer * usual || c.red < pink);
        return c.most > dark_metal && (greyer || c.blue > blue);
    });
    cv::morphologyEx(found, found, cv::MORPH_OPEN, disc(least_instrument));
    const double most = std::min(mirrored, mirrored_of_usual * usual);
    add_sides(found, view, colored(code, view, [most](const Color& c) {
                  return c.most > darkest_mirrored && c.saturation < most && c.red < mirrored_pink;
              }));
    cv::dilate(found, found, disc(beside_instrument));
    return found;
}

}  // namespace lapfx::match
