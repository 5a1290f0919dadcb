#include "media/valid_view.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "media/opencv.h"

namespace lapfx::media {

namespace {

// Code values up to which a pixel at the border of a picture may be surround. The darkest comes first: tissue in the
// shade is nearly as dark as the surround of some endoscopes.
constexpr double blacks[] = {5.0, 9.0, 14.0, 24.0};
constexpr int tries = 400;               // circles through three points
constexpr double tolerance = 0.008;      // share of the picture's height by which a point may miss the circle
constexpr double least_share = 0.6;      // of all points on the rim, those that have to lie on it
constexpr double least_surround = 0.01;  // share of the picture; with less of it there is no round view
constexpr double least_agreement = 0.9;  // share of the picture that lies on the same side of rim and surround
constexpr double most_squeezed = 2.2;    // width over height of a disc, and the other way round
constexpr std::size_t few_points = 40;   // fewer are no rim

/// 1 where a pixel is black and joined to the border by black ones.
cv::Mat1b surround_of(const Image& picture, double black) {
    cv::Mat1b grey;
    cv::GaussianBlur(grey_of(picture), grey, {5, 5}, 0);
    cv::Mat1b dark(grey <= black);
    cv::copyMakeBorder(dark, dark, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(255));
    cv::floodFill(dark, {0, 0}, cv::Scalar(1));
    return cv::Mat1b(dark == 1)(cv::Rect(1, 1, picture.width, picture.height)).clone();
}

/// Where rows and columns first leave the surround, from both sides.
std::vector<glm::dvec2> rim_of(const cv::Mat1b& surround) {
    std::vector<glm::dvec2> rim;
    const auto walk = [&](int length, const auto& at) {
        int first = 0, last = length - 1;
        while (first < length && surround(at(first)) != 0) ++first;
        while (last > first && surround(at(last)) != 0) --last;
        if (first == length) return;
        for (const int end : {first, last}) {
            const cv::Point place = at(end);
            if (end > 2 && end < length - 3) rim.emplace_back(place.x + 0.5, place.y + 0.5);
        }
    };
    for (int y = 0; y < surround.rows; ++y) walk(surround.cols, [&](int x) { return cv::Point(x, y); });
    for (int x = 0; x < surround.cols; ++x) walk(surround.rows, [&](int y) { return cv::Point(x, y); });
    return rim;
}

/// How the rim may be shaped.
enum class Shape { circle, ellipse };

/// The circle or upright ellipse that is nearest to all points, of x2 + b y2 + c x + d y + e = 0, where b = 1 for a
/// circle (Kasa 1976).
std::optional<ViewDisc> disc_near(std::span<const glm::dvec2> points, Shape shape) {
    const glm::dvec2 origin = points.front();  // numbers near 0 keep their digits
    const int unknown = shape == Shape::circle ? 3 : 4;
    cv::Mat1d rows(static_cast<int>(points.size()), unknown), right(static_cast<int>(points.size()), 1), found;
    for (int i = 0; i < rows.rows; ++i) {
        const glm::dvec2 p = points[static_cast<std::size_t>(i)] - origin;
        rows(i, 0) = p.x, rows(i, 1) = p.y, rows(i, 2) = 1.0;
        if (shape == Shape::ellipse) rows(i, 3) = p.y * p.y;
        right(i) = shape == Shape::circle ? -glm::dot(p, p) : -p.x * p.x;
    }
    if (!cv::solve(rows, right, found, cv::DECOMP_QR)) return std::nullopt;
    const double b = shape == Shape::circle ? 1.0 : found(3);
    if (!(b > 1.0 / (most_squeezed * most_squeezed) && b < most_squeezed * most_squeezed)) return std::nullopt;
    const glm::dvec2 center(-found(0) / 2.0, -found(1) / (2.0 * b));
    const double square = center.x * center.x + b * center.y * center.y - found(2);
    if (!(square > 0.0)) return std::nullopt;
    return ViewDisc{.center = origin + center, .radius = {std::sqrt(square), std::sqrt(square / b)}};
}

/// The disc that most points of a rim lie on: others are instruments, dark tissue and text that reach into it.
std::optional<ViewDisc> disc_of(const std::vector<glm::dvec2>& rim, glm::ivec2 size, Shape shape) {
    if (rim.size() < few_points) return std::nullopt;
    const double near = tolerance * size.y;
    const auto on = [&](const ViewDisc& disc) {
        std::vector<glm::dvec2> found;
        for (const glm::dvec2& point : rim)
            if (std::abs(disc.radii(point) - 1.0) * std::min(disc.radius.x, disc.radius.y) <= near)
                found.push_back(point);
        return found;
    };
    std::mt19937 random(1);
    std::vector<glm::dvec2> best, some(shape == Shape::circle ? 3 : 4);
    for (int i = 0; i < tries; ++i) {
        for (glm::dvec2& point : some) point = rim[random() % rim.size()];
        const std::optional<ViewDisc> disc = disc_near(some, shape);
        if (!disc || disc->radius.y < 0.2 * size.y || disc->radius.x > 2.0 * size.x) continue;
        if (std::vector<glm::dvec2> found = on(*disc); found.size() > best.size()) best = std::move(found);
    }
    if (static_cast<double>(best.size()) < least_share * static_cast<double>(rim.size())) return std::nullopt;
    return disc_near(best, shape);
}

/// Share of the picture in which it and the surround agree.
double agreement(const ViewDisc& disc, const cv::Mat1b& surround) {
    int same = 0;
    for (int y = 0; y < surround.rows; ++y)
        for (int x = 0; x < surround.cols; ++x)
            same += (disc.radii({x + 0.5, y + 0.5}) > 1.0) == (surround(y, x) != 0) ? 1 : 0;
    return static_cast<double>(same) / static_cast<double>(surround.total());
}

std::optional<ViewDisc> disc_within(const cv::Mat1b& surround) {
    if (cv::countNonZero(surround) < least_surround * static_cast<double>(surround.total())) return std::nullopt;
    const std::vector<glm::dvec2> rim = rim_of(surround);
    for (const Shape shape : {Shape::circle, Shape::ellipse}) {
        const std::optional<ViewDisc> disc = disc_of(rim, {surround.cols, surround.rows}, shape);
        if (disc && agreement(*disc, surround) >= least_agreement) return disc;
    }
    return std::nullopt;
}

}  // namespace

double ValidView::share(glm::ivec2 pixel) const {
    if (pixel.x < from.x || pixel.y < from.y || pixel.x >= to.x || pixel.y >= to.y) return 0.0;
    if (!disc) return 1.0;
    const double inside = (1.0 - disc->radii(glm::dvec2(pixel) + 0.5)) * std::min(disc->radius.x, disc->radius.y);
    return std::clamp(inside / 2.0, 0.0, 1.0);
}

namespace {

ValidView view_within(const cv::Mat1b& surround) {
    const cv::Rect box = cv::boundingRect(surround == 0);
    if (box.area() == 0) return {.from = glm::ivec2(0), .to = {surround.cols, surround.rows}, .disc = std::nullopt};
    ValidView view{
        .from = {box.x, box.y}, .to = {box.x + box.width, box.y + box.height}, .disc = disc_within(surround(box))};
    if (view.disc) view.disc->center += glm::dvec2(view.from);
    return view;
}

}  // namespace

ValidView valid_view(const Image& picture) {
    ValidView view;
    for (const double black : blacks) {
        view = view_within(surround_of(picture, black));
        if (view.disc) break;
    }
    return view;
}

}  // namespace lapfx::media
