#include "match/picture/view.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace lapfx::match {

namespace {

constexpr double black = 18.0;         // code value below which the surround stays
constexpr double least_view = 0.02;    // share of the picture
constexpr double hollow_share = 0.25;  // of the hull: the view may be so much darker than black inside
constexpr int rim = 3;                 // px: the edge of the view is blurred

std::vector<cv::Point> largest_of(const cv::Mat& mask) {
    std::vector<std::vector<cv::Point>> shapes;
    cv::findContours(mask.clone(), shapes, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    std::vector<cv::Point> largest;
    for (auto& shape : shapes)
        if (largest.empty() || cv::contourArea(shape) > cv::contourArea(largest)) largest = std::move(shape);
    return largest;
}

}  // namespace

cv::Mat disc(int radius) {
    return cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * radius + 1, 2 * radius + 1});
}

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

cv::Mat wanted_part(cv::Size size, const glm::dvec4& region, std::span<const MaskPolygon> masks) {
    cv::Mat wanted = cv::Mat::zeros(size, CV_8U);
    const auto px = [](double share, int length) {
        return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * length));
    };
    const cv::Point from(px(region.x, size.width), px(region.y, size.height));
    const cv::Point to(px(region.x + region.z, size.width), px(region.y + region.w, size.height));
    if (to.x > from.x && to.y > from.y) wanted(cv::Rect(from, to)) = 255;
    for (const MaskPolygon& mask : masks) {
        std::vector<cv::Point> corners;
        for (const glm::dvec2 corner : mask) corners.emplace_back(px(corner.x, size.width), px(corner.y, size.height));
        if (corners.size() >= 3) cv::fillPoly(wanted, std::vector<std::vector<cv::Point>>{corners}, 0);
    }
    return wanted;
}

cv::Mat disc_of(const glm::dvec3& round, cv::Size size, double aspect) {
    cv::Mat inside = cv::Mat::zeros(size, CV_8U);
    constexpr int parts = 4;  // of a pixel, as bits
    const auto fixed = [](double px) { return static_cast<int>(std::lround(px * (1 << parts))); };
    const cv::Point middle(fixed(round.x * size.width - 0.5), fixed(round.y * size.height - 0.5));
    const double radius = round.z * size.height - 0.5;
    if (aspect == 0.0) {
        cv::circle(inside, middle, fixed(radius), 255, cv::FILLED, cv::LINE_8, parts);
    } else {
        const double across = round.z * size.width / aspect - 0.5;
        cv::ellipse(inside, middle, {fixed(across), fixed(radius)}, 0.0, 0.0, 360.0, 255, cv::FILLED, cv::LINE_8,
                    parts);
    }
    return inside;
}

cv::Mat view_in(const cv::Mat& code, const LookedAt& part) {
    return (part.round_view ? disc_of(*part.round_view, code.size()) : view_of(code)) &
           wanted_part(code.size(), part.region, part.masks);
}

}  // namespace lapfx::match
