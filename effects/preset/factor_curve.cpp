#include "preset/factor_curve.h"

#include <algorithm>
#include <cmath>

namespace lapfx {

namespace {

constexpr double farthest = 1e7;  // s; as for contacts

bool counts(const CurvePoint& point) {
    return std::abs(point.time) <= farthest && point.value >= 0.0 && std::isfinite(point.value);  // false for NaN
}

/// The first point after `time`.
std::span<const CurvePoint>::iterator after(std::span<const CurvePoint> points, double time) {
    return std::upper_bound(points.begin(), points.end(), time,
                            [](double t, const CurvePoint& point) { return t < point.time; });
}

double between_points(const CurvePoint& a, const CurvePoint& b, double time) {
    return a.value + (b.value - a.value) * ((time - a.time) / (b.time - a.time));
}

}  // namespace

double curve_at(std::span<const CurvePoint> points, double time) noexcept {
    if (points.empty()) return 1.0;
    const CurvePoint* before = nullptr;
    for (const CurvePoint& point : points) {
        if (!counts(point) || (before != nullptr && !(point.time > before->time))) continue;
        if (!(time >= point.time)) return before == nullptr ? point.value : between_points(*before, point, time);
        before = &point;
    }
    return before == nullptr ? 1.0 : before->value;
}

FactorCurve::FactorCurve(std::span<const CurvePoint> points, double highest) {
    for (const CurvePoint& given : points) {
        if (!counts(given) || (!points_.empty() && !(given.time > points_.back().time))) continue;
        const CurvePoint point{given.time, std::min(given.value, highest)};
        sums_.push_back(points_.empty() ? 0.0
                                        : sums_.back() + 0.5 * (point.value + points_.back().value) *
                                                             (point.time - points_.back().time));
        points_.push_back(point);
    }
}

double FactorCurve::at(double time) const noexcept {
    if (even()) return 1.0;
    const auto next = after(points_, time);
    const std::span<const CurvePoint> all(points_);
    if (next == all.begin()) return points_.front().value;
    return next == all.end() ? points_.back().value : between_points(*(next - 1), *next, time);
}

double FactorCurve::slope_after(double time) const noexcept {
    const std::span<const CurvePoint> all(points_);
    const auto next = after(all, time);
    if (next == all.begin() || next == all.end()) return 0.0;
    return (next->value - (next - 1)->value) / (next->time - (next - 1)->time);
}

double FactorCurve::sum(double time) const noexcept {
    const std::span<const CurvePoint> all(points_);
    const auto next = after(all, time);
    if (next == all.begin()) return (time - points_.front().time) * points_.front().value;
    const auto i = static_cast<std::size_t>(next - all.begin()) - 1;
    return sums_[i] + 0.5 * (points_[i].value + at(time)) * (time - points_[i].time);
}

std::span<const CurvePoint> FactorCurve::between(double from, double to) const noexcept {
    const std::span<const CurvePoint> all(points_);
    const auto first = after(all, from);
    const auto last = std::lower_bound(first, all.end(), to, [](const CurvePoint& p, double t) { return p.time < t; });
    return {first, last};
}

}  // namespace lapfx
