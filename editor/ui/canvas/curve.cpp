#include "ui/canvas/curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lapfx::ui {

namespace {

constexpr std::size_t figures_of_point = 5;

bool finite(const CurvePoint& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.slope_in) && std::isfinite(p.slope_out);
}

double slope_between(const CurvePoint& a, const CurvePoint& b) {
    return (b.y - a.y) / (b.x - a.x);
}

}  // namespace

Curve::Curve() : Curve({{0, 0, CurveHandle::linear}, {1, 1, CurveHandle::linear}}) {}

Curve::Curve(std::vector<CurvePoint> points, bool monotone) : points_(std::move(points)), monotone_(monotone) {
    assert(valid(points_));
    update();
}

Curve Curve::preset(CurvePreset preset) {
    using enum CurveHandle;
    switch (preset) {
        case CurvePreset::ease:  // flat at the end
            return Curve({{0, 0, free, 2, 2}, {1, 1, free, 0, 0}});
        case CurvePreset::s:  // flat at both ends: 3x^2 - 2x^3
            return Curve({{0, 0, free}, {1, 1, free}});
        case CurvePreset::step:
            return Curve({{0, 0, step}, {0.5, 1, step}, {1, 1, step}});
        case CurvePreset::pulse:
            return Curve({{0, 0, free}, {0.5, 1, free}, {1, 0, free}});
        default:
            return Curve();
    }
}

bool Curve::valid(std::span<const CurvePoint> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!finite(points[i]) || (i > 0 && !(points[i].x > points[i - 1].x))) return false;
    }
    return !points.empty();
}

double Curve::evaluate(double x) const {
    if (!(x > points_.front().x)) return points_.front().y;
    if (x >= points_.back().x) return points_.back().y;
    const auto next = std::upper_bound(points_.begin(), points_.end(), x,
                                       [](double value, const CurvePoint& p) { return value < p.x; });
    const auto i = static_cast<std::size_t>(next - points_.begin()) - 1;
    const CurvePoint &a = points_[i], &b = points_[i + 1];
    if (a.handle == CurveHandle::step) return a.y;
    const double width = b.x - a.x, t = (x - a.x) / width, u = 1 - t;
    const double smooth = t * t * (3 - 2 * t);
    return a.y + (b.y - a.y) * smooth + width * t * u * (slopes_out_[i] * u - slopes_in_[i + 1] * t);
}

void Curve::update() {
    const std::size_t count = points_.size();
    slopes_in_.resize(count), slopes_out_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const CurvePoint& p = points_[i];
        const double before = i > 0 ? slope_between(points_[i - 1], p) : 0;
        const double after = i + 1 < count ? slope_between(p, points_[i + 1]) : 0;
        double in = p.slope_in, out = p.slope_out;
        if (p.handle == CurveHandle::linear || p.handle == CurveHandle::step) in = before, out = after;
        if (p.handle == CurveHandle::automatic) {
            const bool inner = i > 0 && i + 1 < count;
            in = out = inner ? slope_between(points_[i - 1], points_[i + 1]) : i > 0 ? before : after;
        }
        slopes_in_[i] = in, slopes_out_[i] = out;
    }
    if (monotone_) keep_monotone();
}

/// Of each piece both slopes, as parts of the straight way's, are brought into the circle of radius 3. Where a point is
/// smooth it stays so: the flatter of both sides counts, which is still inside of both circles.
void Curve::keep_monotone() {
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
        double &left = slopes_out_[i], &right = slopes_in_[i + 1];
        const double straight = slope_between(points_[i], points_[i + 1]);
        if (straight == 0) {
            left = right = 0;
            continue;
        }
        const double a = std::max(0.0, left / straight), b = std::max(0.0, right / straight);
        const double shrink = std::min(1.0, 3 / std::hypot(a, b));
        left = a * straight, right = b * straight;
        if (shrink < 1) left *= shrink, right *= shrink;
    }
    for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
        if (points_[i].handle != CurveHandle::automatic) continue;
        double &in = slopes_in_[i], &out = slopes_out_[i];
        in = out = in * out <= 0 ? 0 : std::abs(in) < std::abs(out) ? in : out;
    }
}

void Curve::set_monotone(bool monotone) {
    monotone_ = monotone;
    update();
}

std::optional<std::size_t> Curve::insert(double x, double y) {
    if (!std::isfinite(x) || !std::isfinite(y)) return std::nullopt;
    const auto at = std::lower_bound(points_.begin(), points_.end(), x,
                                     [](const CurvePoint& p, double value) { return p.x < value; });
    if (at != points_.end() && at->x == x) return std::nullopt;
    const auto i = static_cast<std::size_t>(at - points_.begin());
    points_.insert(at, {x, y});
    update();
    return i;
}

void Curve::erase(std::size_t i) {
    if (points_.size() < 2 || i >= points_.size()) return;
    points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(i));
    update();
}

void Curve::set_point(std::size_t i, const CurvePoint& point) {
    assert(i < points_.size() && finite(point));
    assert(i == 0 || point.x > points_[i - 1].x);
    assert(i + 1 == points_.size() || point.x < points_[i + 1].x);
    points_[i] = point;
    update();
}

void Curve::set_points(std::span<const CurvePoint> points) {
    assert(valid(points));
    points_.assign(points.begin(), points.end());
    update();
}

void Curve::make_free(std::size_t i) {
    points_[i].slope_in = slopes_in_[i], points_[i].slope_out = slopes_out_[i];
    points_[i].handle = CurveHandle::free;
    update();
}

std::vector<double> Curve::to_array() const {
    std::vector<double> figures;
    for (const CurvePoint& p : points_) {
        for (const double v : {p.x, p.y, static_cast<double>(p.handle), p.slope_in, p.slope_out}) figures.push_back(v);
    }
    return figures;
}

std::optional<Curve> Curve::from_array(std::span<const double> figures, bool monotone) {
    if (figures.empty() || figures.size() % figures_of_point != 0) return std::nullopt;
    std::vector<CurvePoint> points;
    for (std::size_t i = 0; i < figures.size(); i += figures_of_point) {
        const double handle = figures[i + 2];
        if (!(handle >= 0 && handle <= 3) || handle != std::floor(handle)) return std::nullopt;
        points.push_back(
            {figures[i], figures[i + 1], static_cast<CurveHandle>(handle), figures[i + 3], figures[i + 4]});
    }
    if (!valid(points)) return std::nullopt;
    return Curve(std::move(points), monotone);
}

}  // namespace lapfx::ui
