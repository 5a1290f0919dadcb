#include "match/view.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace lapfx::match {

namespace {

constexpr double black = 18.0;         // code value below which the surround stays
constexpr double least_view = 0.02;    // share of the picture
constexpr double hollow_share = 0.25;  // of the hull: the view may be so much darker than black inside
constexpr int rim = 3;                 // px: the edge of the view is blurred
constexpr double grey = 0.28;          // saturation below which tissue does not lie
constexpr double pink = 0.10;          // share by which red leads in tissue, however pale
constexpr double dark_metal = 45.0;    // code value below which saturation says nothing
constexpr double much_greyer = 0.5;    // factor on the usual saturation: metal that shines red has less
constexpr int least_instrument = 3;    // px: half of its width; highlights are smaller
constexpr int beside_instrument = 2;   // px

cv::Mat disc(int radius) {
    return cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * radius + 1, 2 * radius + 1});
}

std::vector<cv::Point> largest_of(const cv::Mat& mask) {
    std::vector<std::vector<cv::Point>> shapes;
    cv::findContours(mask.clone(), shapes, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    std::vector<cv::Point> largest;
    for (auto& shape : shapes)
        if (largest.empty() || cv::contourArea(shape) > cv::contourArea(largest)) largest = std::move(shape);
    return largest;
}

/// The median of what is bright enough to have one.
double usual_saturation(const cv::Mat& code, const cv::Mat& view) {
    std::vector<double> all;
    for (int y = 0; y < code.rows; ++y)
        for (int x = 0; x < code.cols; ++x) {
            const cv::Vec3b& p = code.at<cv::Vec3b>(y, x);
            const int most = std::max({p[0], p[1], p[2]}), least = std::min({p[0], p[1], p[2]});
            if (view.at<std::uint8_t>(y, x) != 0 && most > dark_metal)
                all.push_back((most - least) / static_cast<double>(most));
        }
    if (all.empty()) return 0.0;
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return *middle;
}

}  // namespace

cv::Mat view_of(const cv::Mat& code) {
    cv::Mat channels[3], brightest;
    cv::split(code, channels);
    cv::max(channels[0], channels[1], brightest);
    cv::max(brightest, channels[2], brightest);
    cv::GaussianBlur(brightest, brightest, {5, 5}, 0);
    cv::Mat bright = brightest > black;
    cv::morphologyEx(bright, bright, cv::MORPH_OPEN, disc(3));  // text in the surround
    cv::copyMakeBorder(bright, bright, 12, 12, 12, 12, cv::BORDER_REPLICATE);
    cv::morphologyEx(bright, bright, cv::MORPH_CLOSE, disc(12));
    bright = bright(cv::Rect({12, 12}, code.size())).clone();
    cv::Mat view = cv::Mat::zeros(code.size(), CV_8U);
    const std::vector<cv::Point> shape = largest_of(bright);
    if (shape.empty() || cv::contourArea(shape) < least_view * static_cast<double>(code.total())) return view;
    // The view is convex: a disc, a rectangle, or one cut by the other. Where much is missing it was not the view.
    std::vector<cv::Point> hull;
    cv::convexHull(shape, hull);
    const bool convex = cv::contourArea(shape) > (1.0 - hollow_share) * cv::contourArea(hull);
    cv::drawContours(view, std::vector<std::vector<cv::Point>>{convex ? hull : shape}, 0, 255, cv::FILLED);
    cv::erode(view, view, disc(rim), {-1, -1}, 1, cv::BORDER_CONSTANT, cv::Scalar(255));
    return view;
}

cv::Mat instruments_of(const cv::Mat& code, const cv::Mat& view) {
    cv::Mat found(code.size(), CV_8U);
    const double usual = usual_saturation(code, view);
    for (int y = 0; y < code.rows; ++y) {
        const auto* from = code.ptr<cv::Vec3b>(y);
        auto* to = found.ptr<std::uint8_t>(y);
        for (int x = 0; x < code.cols; ++x) {
            const int most = std::max({from[x][0], from[x][1], from[x][2]});
            const int least = std::min({from[x][0], from[x][1], from[x][2]});
            to[x] = most > dark_metal && most - least < grey * most &&
                            (most - least < much_greyer * usual * most ||
                             from[x][2] - std::max(from[x][0], from[x][1]) < pink * most)
                        ? 255
                        : 0;
        }
    }
    found &= view;
    cv::morphologyEx(found, found, cv::MORPH_OPEN, disc(least_instrument));
    cv::dilate(found, found, disc(beside_instrument));
    return found;
}

cv::Mat wanted_part(cv::Size size, const glm::dvec4& region, std::span<const Part> masks) {
    cv::Mat wanted = cv::Mat::zeros(size, CV_8U);
    const auto px = [](double share, int length) {
        return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * length));
    };
    const cv::Point from(px(region.x, size.width), px(region.y, size.height));
    const cv::Point to(px(region.x + region.z, size.width), px(region.y + region.w, size.height));
    if (to.x > from.x && to.y > from.y) wanted(cv::Rect(from, to)) = 255;
    for (const Part& mask : masks) {
        std::vector<cv::Point> corners;
        for (const glm::dvec2 corner : mask) corners.emplace_back(px(corner.x, size.width), px(corner.y, size.height));
        if (corners.size() >= 3) cv::fillPoly(wanted, std::vector<std::vector<cv::Point>>{corners}, 0);
    }
    return wanted;
}

}  // namespace lapfx::match
