#include "match/picture/round_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "match/picture/view.h"

namespace lapfx::match {

namespace {

constexpr int worked_height = 360;    // px: where the disc is looked for first
constexpr int rays = 720;             // from its middle across its edge
constexpr double reach = 0.06;        // of the radius: how far to both sides of the edge they go
constexpr double step = 0.5;          // px
constexpr double least_rise = 14;     // code values from the surround to the view
constexpr double most_surround = 40;  // code value: what is brighter is none
constexpr int frame_border = 3;       // px: encoders blur it
constexpr std::size_t least_rays = 90;
constexpr int fits = 6;
constexpr double most_moved = 0.03;  // of the radius, by the edge: else it was found somewhere else

// The disc of a view's mask.
constexpr double whole_view = 0.985;    // share of the frame from which there is no surround
constexpr double edge_off = 0.03;       // of the radius: how far the view's edge may lie from the circle
constexpr std::size_t least_edge = 60;  // px of the edge that must be in the frame
constexpr int mask_border = 4;          // px: the frame's own border

/// Bilinear.
double value_at(const cv::Mat1f& picture, glm::dvec2 at) {
    const int x = static_cast<int>(at.x), y = static_cast<int>(at.y);
    const double u = at.x - x, v = at.y - y;
    const double above = (1 - u) * picture(y, x) + u * picture(y, x + 1);
    const double below = (1 - u) * picture(y + 1, x) + u * picture(y + 1, x + 1);
    return (1 - v) * above + v * below;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Where a ray leaves the view, as a distance from the middle: half of the way from the surround's brightness to the
/// view's, looked for from outside, since tissue in the shade is also dark.
std::optional<double> edge_on(const cv::Mat1f& brightness, const Disc& disc, glm::dvec2 way) {
    const double width = std::max(6.0, reach * disc.radius);
    const glm::dvec2 end = disc.center + (disc.radius + width) * way;
    if (end.x < frame_border || end.y < frame_border || end.x >= brightness.cols - 1 - frame_border ||
        end.y >= brightness.rows - 1 - frame_border)
        return std::nullopt;
    std::vector<double> values;
    for (double r = disc.radius - width; r <= disc.radius + width; r += step)
        values.push_back(value_at(brightness, disc.center + r * way));
    const auto third = static_cast<std::ptrdiff_t>(values.size() / 3);
    const double inside = median({values.begin(), values.begin() + third});
    const double outside = median({values.end() - third, values.end()});
    if (inside - outside < least_rise || outside > most_surround) return std::nullopt;
    const double half = (inside + outside) / 2;
    for (std::size_t i = values.size() - 1; i > 0; --i)
        if (values[i] < half && values[i - 1] >= half) {
            const double part = (half - values[i]) / (values[i - 1] - values[i]);
            return disc.radius - width + step * (static_cast<double>(i) - part);
        }
    return std::nullopt;
}

std::vector<glm::dvec2> edge_of(const cv::Mat1f& brightness, const Disc& disc) {
    std::vector<glm::dvec2> edge;
    for (int i = 0; i < rays; ++i) {
        const double angle = 2 * std::numbers::pi * i / rays;
        const glm::dvec2 way(std::cos(angle), std::sin(angle));
        if (const auto r = edge_on(brightness, disc, way)) edge.push_back(disc.center + *r * way);
    }
    return edge;
}

/// The circle nearest to the edge; what lies far off it, as an instrument's or tissue in the shade, is left out.
std::optional<Disc> circle_of(const std::vector<glm::dvec2>& edge, Disc disc) {
    for (int fit = 0; fit < fits; ++fit) {
        std::vector<double> off;
        for (const glm::dvec2& p : edge) off.push_back(std::abs(glm::distance(p, disc.center) - disc.radius));
        const double most = std::max(0.5, 3 * median(off));
        std::vector<glm::dvec2> kept;
        for (std::size_t i = 0; i < edge.size(); ++i)
            if (fit == 0 || off[i] <= most) kept.push_back(edge[i]);
        if (kept.size() < least_rays) return std::nullopt;
        // By the distances themselves (Gauss-Newton): a circle through squares of them is drawn in where only a part of
        // the rim is in the frame.
        cv::Mat1d rows(static_cast<int>(kept.size()), 3), right(static_cast<int>(kept.size()), 1), found;
        for (int i = 0; i < rows.rows; ++i) {
            const glm::dvec2 arm = kept[static_cast<std::size_t>(i)] - disc.center;
            const double length = glm::length(arm);
            rows(i, 0) = arm.x / length, rows(i, 1) = arm.y / length, rows(i, 2) = 1;
            right(i) = length - disc.radius;
        }
        if (!cv::solve(rows, right, found, cv::DECOMP_SVD)) return std::nullopt;
        disc.center += glm::dvec2(found(0), found(1));
        disc.radius += found(2);
    }
    return disc;
}

}  // namespace

std::optional<Disc> disc_of(const cv::Mat& view) {
    if (view.empty() || cv::countNonZero(view) >= whole_view * static_cast<double>(view.total())) return std::nullopt;
    std::vector<std::vector<cv::Point>> shapes;
    cv::findContours(view.clone(), shapes, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    std::vector<cv::Point> edge;
    for (const auto& shape : shapes)
        for (const cv::Point& p : shape)
            if (p.x >= mask_border && p.y >= mask_border && p.x < view.cols - mask_border &&
                p.y < view.rows - mask_border)
                edge.push_back(p);
    if (edge.size() < least_edge) return std::nullopt;
    // The circle x^2 + y^2 = 2 a x + 2 b y + c that is nearest to all of the edge.
    cv::Mat left(static_cast<int>(edge.size()), 3, CV_64F), right(static_cast<int>(edge.size()), 1, CV_64F), found;
    for (int i = 0; i < left.rows; ++i) {
        const cv::Point& p = edge[static_cast<std::size_t>(i)];
        left.at<double>(i, 0) = 2.0 * p.x, left.at<double>(i, 1) = 2.0 * p.y, left.at<double>(i, 2) = 1;
        right.at<double>(i) = static_cast<double>(p.x) * p.x + static_cast<double>(p.y) * p.y;
    }
    if (!cv::solve(left, right, found, cv::DECOMP_SVD)) return std::nullopt;
    const glm::dvec2 center(found.at<double>(0), found.at<double>(1));
    const double square = found.at<double>(2) + glm::dot(center, center);
    if (!(square > 0)) return std::nullopt;
    const double radius = std::sqrt(square);
    double off = 0;
    for (const cv::Point& p : edge) off += std::abs(glm::distance(center, glm::dvec2(p.x, p.y)) - radius);
    const double most = std::max(view.cols, view.rows);
    if (off / static_cast<double>(edge.size()) > edge_off * radius || radius > most) return std::nullopt;
    return Disc{center, radius};
}

std::optional<Disc> round_view(const cv::Mat& code) {
    cv::Mat small = code;
    const double scale = std::max(1.0, static_cast<double>(code.rows) / worked_height);
    if (scale > 1) cv::resize(code, small, {}, 1 / scale, 1 / scale, cv::INTER_AREA);
    const std::optional<Disc> rough = disc_of(view_of(small));
    if (!rough) return std::nullopt;
    const double back = static_cast<double>(code.rows) / small.rows;
    Disc disc{.center = (rough->center + 0.5) * back - 0.5, .radius = rough->radius * back};

    cv::Mat channels[3];
    cv::split(code, channels);
    cv::max(channels[0], channels[1], channels[0]);
    cv::max(channels[0], channels[2], channels[0]);
    cv::Mat1f brightness;
    channels[0].convertTo(brightness, CV_32F);
    cv::GaussianBlur(brightness, brightness, {3, 3}, 0);
    const Disc first = disc;
    for (int pass = 0; pass < 2; ++pass) {
        const auto better = circle_of(edge_of(brightness, disc), disc);
        if (!better || glm::distance(better->center, first.center) > most_moved * first.radius ||
            std::abs(better->radius - first.radius) > most_moved * first.radius)
            return disc;
        disc = *better;
    }
    return disc;
}

}  // namespace lapfx::match
