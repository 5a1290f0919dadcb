#include "cautery/burnt_area.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "organ/above_zero.h"

namespace lapfx::cautery {

namespace {

double height(float rise) {
    return std::log(std::max<double>(rise, BurntArea::least_rise));
}

/// Share of a triangle where linear - k |x|^2 is above zero. `values`: at its corners; `bends`: k times the squared
/// length of the edge after each corner. A paraboloid is above its chord by a quarter of that in the middle of an edge,
/// and above its plane by a twelfth of their sum on average: good enough for triangles a quarter as long.
double share_above(const std::array<double, 3>& values, const std::array<double, 3>& bends, int halvings) {
    const double more = (bends[0] + bends[1] + bends[2]) / 12.0;
    if (halvings == 0) {
        std::array<double, 3> raised{values[0] + more, values[1] + more, values[2] + more};
        std::sort(raised.begin(), raised.end());
        return organ::above_zero(raised).share;
    }
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    if (*least >= 0.0) return 1.0;
    if (*most + 4.0 * more <= 0.0) return 0.0;
    std::array<double, 3> middles, halves;
    for (std::size_t i = 0; i < 3; ++i) {
        middles[i] = 0.5 * (values[i] + values[(i + 1) % 3]) + 0.25 * bends[i];
        halves[i] = 0.25 * bends[i];
    }
    double share = share_above(middles, {halves[2], halves[0], halves[1]}, halvings - 1);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t before = (i + 2) % 3;
        share += share_above({values[i], middles[i], middles[before]}, {halves[i], halves[(i + 1) % 3], halves[before]},
                             halvings - 1);
    }
    return 0.25 * share;
}

}  // namespace

/// Triangles that have a changed point for a corner, or a neighbour whose curvature they use.
void BurntArea::mark_triangles() {
    for (const std::uint32_t point : changed_.points())
        for (const std::uint32_t t : surface_.triangles_at(point)) {
            sum_.mark(t);
            const auto& c = surface_.triangles[t];
            std::uint32_t other = 0;
            for (std::size_t i = 0; i < 3; ++i)
                if (c[i] != point && c[(i + 1) % 3] != point && surface_.across(t, c[i], c[(i + 1) % 3], other))
                    sum_.mark(other);
        }
    changed_.clear();
}

void BurntArea::measure(std::span<const float> rises, double wanted) {
    mark_triangles();
    sum_.measure(
        [&](std::uint32_t t, std::uint32_t) { return std::array{share(t, rises, wanted) * surface_.area(t)}; });
}

double BurntArea::share(std::uint32_t triangle, std::span<const float> rises, double wanted) const {
    const auto& c = surface_.triangles[triangle];
    const double level = std::log(wanted);
    std::array<double, 3> above;
    double highest = -1.0;
    for (std::size_t i = 0; i < 3; ++i) {
        above[i] = height(rises[c[i]]) - level;
        highest = std::max(highest, above[i]);
    }
    if (!std::isfinite(level) || highest <= -1.0) return 0.0;
    std::array<double, 3> bends;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 edge = surface_.positions[c[(i + 1) % 3]] - surface_.positions[c[i]];
        bends[i] = glm::dot(edge, edge);
    }
    const double squares = bends[0] + bends[1] + bends[2];
    const double bend = std::min(curvature(triangle, rises), 12.0 / squares);
    for (double& b : bends) b *= bend;
    return share_above(above, bends, 2);
}

/// k, per mm2, of the -k |x|^2 + linear that fits a triangle and the third corners of those beside it best, at least 0.
/// At such a corner it differs from the plane of the triangle by k times the corner's power to the circumcircle.
double BurntArea::curvature(std::uint32_t triangle, std::span<const float> rises) const {
    const auto& c = surface_.triangles[triangle];
    double differences = 0.0, powers = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = c[i], b = c[(i + 1) % 3], inner = c[(i + 2) % 3];
        std::uint32_t other = 0;
        if (!surface_.across(triangle, a, b, other)) continue;
        const auto& o = surface_.triangles[other];
        const std::uint32_t outer = *std::find_if(o.begin(), o.end(), [&](auto p) { return p != a && p != b; });
        if (!(rises[outer] > least_rise)) continue;
        // Both triangles unfolded into a plane: s along the edge, h across it.
        const glm::dvec3 origin = surface_.positions[a], edge = surface_.positions[b] - origin;
        const double length = glm::length(edge);
        const auto along = [&](std::uint32_t p) { return glm::dot(surface_.positions[p] - origin, edge) / length; };
        const auto across = [&](std::uint32_t p) {
            return glm::length(glm::cross(edge, surface_.positions[p] - origin)) / length;
        };
        const double s = along(inner), h = across(inner), outer_s = along(outer), outer_h = across(outer);
        if (!(length > 0.0) || !(h > 1e-3 * length)) continue;
        const double slope = (height(rises[b]) - height(rises[a])) / length;
        const double rising = (height(rises[inner]) - height(rises[a]) - slope * s) / h;
        const double middle = (s * s + h * h - length * s) / h;  // twice the height of the circumcircle's middle
        differences += height(rises[a]) + slope * outer_s - rising * outer_h - height(rises[outer]);
        powers += outer_s * outer_s + outer_h * outer_h - length * outer_s + middle * outer_h;
    }
    return powers > 0.0 ? std::max(0.0, differences / powers) : 0.0;
}

}  // namespace lapfx::cautery
