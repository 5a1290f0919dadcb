#include "organ/surface.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace lapfx::organ {

namespace {

constexpr std::uint32_t leaf_size = 4;

struct ExactHash {
    std::size_t operator()(const glm::vec3& p) const {
        std::uint64_t h = 1469598103934665603ull;  // FNV-1a over the bits; -0 and +0 were made one before
        for (int i = 0; i < 3; ++i) h = (h ^ std::bit_cast<std::uint32_t>(p[i])) * 1099511628211ull;
        return h ^ (h >> 29);
    }
};

/// Closest point of a triangle, by the region of its plane the point projects to (C. Ericson, "Real-Time Collision
/// Detection", 2005, section 5.1.5).
glm::dvec3 closest_barycentric(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
        const double t = d1 - d3 > 0.0 ? d1 / (d1 - d3) : 0.0;
        return {1.0 - t, t, 0.0};
    }
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
        const double t = d2 - d6 > 0.0 ? d2 / (d2 - d6) : 0.0;
        return {1.0 - t, 0.0, t};
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
        const double whole = (d4 - d3) + (d5 - d6);
        const double t = whole > 0.0 ? (d4 - d3) / whole : 0.0;
        return {0.0, 1.0 - t, t};
    }
    const double sum = va + vb + vc;
    if (sum <= 0.0) return {1.0, 0.0, 0.0};
    return {va / sum, vb / sum, vc / sum};
}

double squared_distance_to_box(const glm::dvec3& p, const glm::dvec3& minimum, const glm::dvec3& maximum) {
    const glm::dvec3 outside = glm::max(glm::max(minimum - p, p - maximum), glm::dvec3(0.0));
    return glm::dot(outside, outside);
}

/// Distance along the ray at which it enters the box, or infinity.
double enters_box(const glm::dvec3& origin, const glm::dvec3& inverse, const glm::dvec3& minimum,
                  const glm::dvec3& maximum) {
    double near = 0.0, far = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const double t0 = (minimum[i] - origin[i]) * inverse[i], t1 = (maximum[i] - origin[i]) * inverse[i];
        near = std::max(near, std::fmin(t0, t1));  // fmin drops the NaN of 0 * infinity: the ray lies in that slab
        far = std::min(far, std::fmax(t0, t1));
    }
    return near <= far ? near : std::numeric_limits<double>::infinity();
}

}  // namespace

Surface::Surface(const Organ& organ) {
    std::unordered_map<glm::vec3, std::uint32_t, ExactHash> known;
    known.reserve(organ.positions.size());
    for (const glm::vec3& p : organ.positions) {
        const glm::vec3 key = p + glm::vec3(0.0f);  // -0 becomes +0
        const auto [entry, added] = known.try_emplace(key, static_cast<std::uint32_t>(positions.size()));
        if (added) positions.emplace_back(p);
        weld.push_back(entry->second);
    }
    for (std::size_t i = 0; i + 2 < organ.indices.size(); i += 3) {
        const glm::uvec3 t(weld[organ.indices[i]], weld[organ.indices[i + 1]], weld[organ.indices[i + 2]]);
        if (t.x != t.y && t.y != t.z && t.z != t.x) triangles.push_back(t);
    }
    build_adjacency();
    build_nodes();
}

void Surface::build_adjacency() {
    first_around_.assign(positions.size() + 1, 0);
    for (const glm::uvec3& t : triangles)
        for (int i = 0; i < 3; ++i) ++first_around_[t[i] + 1];
    std::partial_sum(first_around_.begin(), first_around_.end(), first_around_.begin());
    around_.resize(triangles.size() * 3);
    std::vector<std::uint32_t> next(first_around_.begin(), first_around_.end() - 1);
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (int i = 0; i < 3; ++i) around_[next[triangles[t][i]]++] = t;
}

void Surface::fit(Node& node) const {
    node.minimum = glm::dvec3(std::numeric_limits<double>::infinity());
    node.maximum = -node.minimum;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        for (int k = 0; k < 3; ++k) {
            node.minimum = glm::min(node.minimum, positions[triangles[order_[i]][k]]);
            node.maximum = glm::max(node.maximum, positions[triangles[order_[i]][k]]);
        }
}

/// Halves the triangles at the median of their centres along the longest side, until few are left.
void Surface::build_nodes() {
    if (triangles.empty()) return;
    std::vector<glm::dvec3> centers(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        centers[t] = (positions[triangles[t].x] + positions[triangles[t].y] + positions[triangles[t].z]) / 3.0;
    order_.resize(triangles.size());
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.push_back({.minimum = {}, .maximum = {}, .first = 0, .count = static_cast<std::uint32_t>(order_.size())});
    fit(nodes_[0]);
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        if (nodes_[n].count <= leaf_size) continue;
        const std::uint32_t first = nodes_[n].first, count = nodes_[n].count, half = count / 2;
        const glm::dvec3 size = nodes_[n].maximum - nodes_[n].minimum;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        std::nth_element(order_.begin() + first, order_.begin() + first + half, order_.begin() + first + count,
                         [&](std::uint32_t a, std::uint32_t b) {
                             return centers[a][axis] != centers[b][axis] ? centers[a][axis] < centers[b][axis] : a < b;
                         });
        const auto children = static_cast<std::uint32_t>(nodes_.size());
        Node left{.minimum = {}, .maximum = {}, .first = first, .count = half};
        Node right{.minimum = {}, .maximum = {}, .first = first + half, .count = count - half};
        fit(left);
        fit(right);
        nodes_[n].first = children;
        nodes_[n].count = 0;
        nodes_.push_back(left);
        nodes_.push_back(right);
    }
}

ClosestPoint Surface::closest_point(glm::dvec3 point) const {
    assert(!triangles.empty());
    ClosestPoint best;
    double best_squared = std::numeric_limits<double>::infinity();
    std::uint32_t stack[128];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const Node& node = nodes_[stack[--depth]];
        if (squared_distance_to_box(point, node.minimum, node.maximum) > best_squared) continue;
        if (node.count == 0) {
            const auto distance_to = [&](std::uint32_t child) {
                return squared_distance_to_box(point, nodes_[child].minimum, nodes_[child].maximum);
            };
            const bool left_first = distance_to(node.first) <= distance_to(node.first + 1);
            stack[depth++] = left_first ? node.first + 1 : node.first;  // the nearer child is looked at next
            stack[depth++] = left_first ? node.first : node.first + 1;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const glm::uvec3 t = triangles[order_[i]];
            const glm::dvec3 weights = closest_barycentric(point, positions[t.x], positions[t.y], positions[t.z]);
            const glm::dvec3 at = weights.x * positions[t.x] + weights.y * positions[t.y] + weights.z * positions[t.z];
            const double squared = glm::dot(at - point, at - point);
            if (squared > best_squared || (squared == best_squared && order_[i] >= best.triangle)) continue;
            best_squared = squared;
            best = {.triangle = order_[i], .barycentric = weights, .position = at, .distance = 0.0};
        }
    }
    best.distance = std::sqrt(best_squared);
    return best;
}

std::optional<ClosestPoint> Surface::intersect_ray(glm::dvec3 origin, glm::dvec3 direction) const {
    if (triangles.empty() || glm::dot(direction, direction) <= 0.0) return std::nullopt;
    const glm::dvec3 unit = glm::normalize(direction), inverse = 1.0 / unit;
    std::optional<ClosestPoint> best;
    double nearest = std::numeric_limits<double>::infinity();
    std::uint32_t stack[128];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const Node& node = nodes_[stack[--depth]];
        if (!(enters_box(origin, inverse, node.minimum, node.maximum) <= nearest)) continue;
        if (node.count == 0) {
            stack[depth++] = node.first;
            stack[depth++] = node.first + 1;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            // Moller and Trumbore, "Fast, minimum storage ray/triangle intersection", 1997.
            const glm::uvec3 t = triangles[order_[i]];
            const glm::dvec3 e1 = positions[t.y] - positions[t.x], e2 = positions[t.z] - positions[t.x];
            const glm::dvec3 p = glm::cross(unit, e2), s = origin - positions[t.x];
            const double det = glm::dot(e1, p);
            if (det == 0.0) continue;
            const double u = glm::dot(s, p) / det;
            const glm::dvec3 q = glm::cross(s, e1);
            const double v = glm::dot(unit, q) / det, along = glm::dot(e2, q) / det;
            if (u < 0.0 || v < 0.0 || u + v > 1.0 || along < 0.0 || along >= nearest) continue;
            nearest = along;
            best = ClosestPoint{.triangle = order_[i], .barycentric = {1.0 - u - v, u, v},
                                .position = origin + along * unit, .distance = along};
        }
    }
    return best;
}

}  // namespace lapfx::organ
