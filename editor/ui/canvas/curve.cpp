#include "ui/canvas/curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lapfx::ui {

Curve::Curve() : Curve({{0, 0}, {1, 1}}) {}

Curve::Curve(std::vector<CurvePoint> points) : points_(std::move(points)) {
    assert(valid(points_));
}

bool Curve::valid(std::span<const CurvePoint> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y)) return false;
        if (i > 0 && !(points[i].x > points[i - 1].x)) return false;
    }
    return !points.empty();
}

double Curve::evaluate(double x) const {
    if (!(x > points_.front().x)) return points_.front().y;
    if (x >= points_.back().x) return points_.back().y;
    const auto b = std::upper_bound(points_.begin(), points_.end(), x,
                                    [](double value, const CurvePoint& p) { return value < p.x; });
    const auto a = b - 1;
    return std::lerp(a->y, b->y, (x - a->x) / (b->x - a->x));
}

std::optional<std::size_t> Curve::insert(double x, double y) {
    if (!std::isfinite(x) || !std::isfinite(y)) return std::nullopt;
    const auto at = std::lower_bound(points_.begin(), points_.end(), x,
                                     [](const CurvePoint& p, double value) { return p.x < value; });
    if (at != points_.end() && at->x == x) return std::nullopt;
    const auto i = static_cast<std::size_t>(at - points_.begin());
    points_.insert(at, {x, y});
    return i;
}

void Curve::erase(std::size_t i) {
    if (points_.size() < 2 || i >= points_.size()) return;
    points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(i));
}

void Curve::set_points(std::span<const CurvePoint> points) {
    assert(valid(points));
    points_.assign(points.begin(), points.end());
}

}  // namespace lapfx::ui
