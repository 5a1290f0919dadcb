// A smooth line through given points (Catmull-Rom), for spines, edges and outlines; and the signed distance
// to one.
#pragma once

#include <vector>

#include "noise.h"

namespace organs {

/// Through all points, t from 0 to 1, points at equal steps of t.
template <typename Point>
Point along(const std::vector<Point>& points, double t) {
    const int last = static_cast<int>(points.size()) - 1;
    const double x = clamp01(t) * last;
    const int i = x >= last ? last - 1 : static_cast<int>(x);
    const double f = x - i;
    const auto point = [&](int k) {
        if (k < 0) return 2.0 * points[0] - points[1];
        if (k > last) return 2.0 * points[static_cast<std::size_t>(last)] - points[static_cast<std::size_t>(last - 1)];
        return points[static_cast<std::size_t>(k)];
    };
    const Point a = point(i - 1);
    const Point b = point(i);
    const Point c = point(i + 1);
    const Point d = point(i + 2);
    return 0.5 * (2.0 * b + (c - a) * f + (2.0 * a - 5.0 * b + 4.0 * c - d) * (f * f) +
                  (3.0 * b - a - 3.0 * c + d) * (f * f * f));
}

/// Distance from a line in the plane, positive to its right. `where` gets the position along it, 0..1.
inline double beside_line(const std::vector<dvec2>& line, const dvec2& p, double* where = nullptr) {
    double best = 1e18;
    double sign = 1.0;
    constexpr int pieces = 96;
    dvec2 a = along(line, 0.0);
    for (int i = 1; i <= pieces; ++i) {
        const dvec2 b = along(line, static_cast<double>(i) / pieces);
        const dvec2 step = b - a;
        const double t = clamp01(glm::dot(p - a, step) / glm::dot(step, step));
        const dvec2 off = p - (a + t * step);
        const double squared = glm::dot(off, off);
        if (squared < best) {
            best = squared;
            sign = step.y * off.x - step.x * off.y >= 0.0 ? 1.0 : -1.0;
            if (where != nullptr) *where = (i - 1 + t) / pieces;
        }
        a = b;
    }
    return sign * glm::sqrt(best);
}

}  // namespace organs
