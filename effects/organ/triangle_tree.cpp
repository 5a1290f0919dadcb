#include "organ/triangle_tree.h"

#include <algorithm>
#include <cmath>

namespace lapfx {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-12;  // a ray through an edge must not slip between its two triangles
constexpr std::uint32_t leaf_size = 4;

double square(const glm::dvec3& v) {
    return glm::dot(v, v);
}

/// Barycentric weights of the point of a triangle nearest to p (Ericson, Real-Time Collision
/// Detection, 5.1.5).
glm::dvec3 nearest_weights(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 ab = b - a, ac = c - a;
    const double d1 = glm::dot(ab, p - a), d2 = glm::dot(ac, p - a);
    if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
    const double d3 = glm::dot(ab, p - b), d4 = glm::dot(ac, p - b);
    if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
    const double d5 = glm::dot(ab, p - c), d6 = glm::dot(ac, p - c);
    if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0, 1 - w, w};
    }
    const double sum = va + vb + vc;
    return {va / sum, vb / sum, vc / sum};
}

double distance_to_box(const glm::dvec3& p, const glm::dvec3& low, const glm::dvec3& high) {
    return square(glm::max(glm::max(low - p, p - high), glm::dvec3(0.0)));
}

/// Where a ray enters a box, in lengths of its direction; infinity when it misses.
double entry(const glm::dvec3& origin, const glm::dvec3& inverse, const glm::dvec3& low, const glm::dvec3& high) {
    double from = 0.0, to = infinity;
    for (int axis = 0; axis < 3; ++axis) {
        if (!std::isfinite(inverse[axis])) {  // parallel to the sides of the box: between them or not
            if (origin[axis] < low[axis] || origin[axis] > high[axis]) return infinity;
            continue;
        }
        const double a = (low[axis] - origin[axis]) * inverse[axis], b = (high[axis] - origin[axis]) * inverse[axis];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    // Boxes are rounded outwards by less than this.
    return from <= to * (1 + 1e-12) ? from : infinity;
}

}  // namespace

void TriangleTree::fit(Node& node, std::uint32_t first, std::uint32_t count, TriangleMesh mesh) const noexcept {
    node.low = glm::vec3(std::numeric_limits<float>::max());
    node.high = glm::vec3(std::numeric_limits<float>::lowest());
    for (std::uint32_t i = first; i < first + count; ++i)
        for (const std::uint32_t point : mesh.triangles[order_[i]]) {
            // Positions were floats, so the boxes are exact.
            node.low = glm::min(node.low, glm::vec3(mesh.positions[point]));
            node.high = glm::max(node.high, glm::vec3(mesh.positions[point]));
        }
}

void TriangleTree::build(TriangleMesh mesh) {
    nodes_.clear();
    order_.clear();
    if (mesh.triangles.empty()) return;
    // All data of a triangle, moved together with it: each level of the tree reads its part sequentially.
    struct Item {
        glm::vec3 centre, low, high;
        std::uint32_t triangle;
    };
    std::vector<Item> items(mesh.triangles.size());
    order_.resize(items.size());
    for (std::uint32_t t = 0; t < items.size(); ++t) {
        order_[t] = t;
        Node box;
        fit(box, t, 1, mesh);
        items[t] = {.centre = glm::vec3(0.0f), .low = box.low, .high = box.high, .triangle = t};
        for (const std::uint32_t point : mesh.triangles[t]) items[t].centre += glm::vec3(mesh.positions[point]) / 3.0f;
    }
    struct Job {
        std::uint32_t first, count;
        std::uint32_t parent;  ///< the node whose second child this is
    };
    constexpr std::uint32_t none = 0xffffffff;
    std::vector<Job> jobs{{0, static_cast<std::uint32_t>(items.size()), none}};
    nodes_.reserve(items.size());
    while (!jobs.empty()) {
        const Job job = jobs.back();
        jobs.pop_back();
        if (job.parent != none) nodes_[job.parent].first = static_cast<std::uint32_t>(nodes_.size());
        const auto begin = items.begin() + job.first, end = begin + job.count;
        Node node{.low = begin->low, .high = begin->high, .first = job.first, .count = job.count};
        for (auto item = begin; item != end; ++item) {
            node.low = glm::min(node.low, item->low);
            node.high = glm::max(node.high, item->high);
        }
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        if (job.count > leaf_size) {
            const glm::vec3 size = node.high - node.low;
            const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            const std::uint32_t half = job.count / 2;
            // The lower number wins a tie, so that the tree is the same everywhere.
            std::nth_element(begin, begin + half, end, [axis](const Item& a, const Item& b) {
                return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis] : a.triangle < b.triangle;
            });
            node.count = 0;
            jobs.push_back({job.first + half, job.count - half, index});
            jobs.push_back({job.first, half, none});
        }
        nodes_.push_back(node);
    }
    for (std::size_t i = 0; i < items.size(); ++i) order_[i] = items[i].triangle;
}

void TriangleTree::refit(TriangleMesh mesh) noexcept {
    // Children come after their parent.
    for (std::size_t n = nodes_.size(); n-- > 0;) {
        Node& node = nodes_[n];
        if (node.count > 0) {
            fit(node, node.first, node.count, mesh);
            continue;
        }
        node.low = glm::min(nodes_[n + 1].low, nodes_[node.first].low);
        node.high = glm::max(nodes_[n + 1].high, nodes_[node.first].high);
    }
}

bool TriangleTree::nearest(TriangleMesh mesh, const glm::dvec3& point, SurfacePoint& place, double within,
                           ComponentFilter filter) const {
    if (nodes_.empty()) return false;
    double best_square = within * within;
    bool found = false;
    Stack stack;
    std::size_t size = 0;
    stack[size++] = 0;
    const auto reach = [&](std::uint32_t n) { return distance_to_box(point, nodes_[n].low, nodes_[n].high); };
    while (size > 0) {
        const std::uint32_t n = stack[--size];
        const Node& node = nodes_[n];
        if (reach(n) > best_square) continue;
        if (node.count == 0) {
            const std::uint32_t left = n + 1, right = node.first;
            const bool left_first = reach(left) <= reach(right);
            stack[size++] = left_first ? right : left;
            stack[size++] = left_first ? left : right;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const std::uint32_t t = order_[i];
            const auto& corners = mesh.triangles[t];
            if (!filter.component_of.empty() && filter.component_of[corners[0]] == filter.skipped) continue;
            const glm::dvec3 &a = mesh.positions[corners[0]], &b = mesh.positions[corners[1]],
                             &c = mesh.positions[corners[2]];
            const glm::dvec3 weights = nearest_weights(point, a, b, c);
            const glm::dvec3 position = weights.x * a + weights.y * b + weights.z * c;
            const double d = square(position - point);
            if (d < best_square || (found && d == best_square && t < place.triangle)) {
                best_square = d;
                place = {t, weights, position, 0.0};
                found = true;
            }
        }
    }
    if (found) place.distance = std::sqrt(best_square);
    return found;
}

bool TriangleTree::first_hit(TriangleMesh mesh, const glm::dvec3& origin, const glm::dvec3& direction,
                             SurfacePoint& hit) const {
    if (nodes_.empty() || !(square(direction) > 0.0)) return false;
    const glm::dvec3 inverse = 1.0 / direction;
    double nearest = infinity;
    Stack stack;
    std::size_t size = 0;
    stack[size++] = 0;
    while (size > 0) {
        const std::uint32_t n = stack[--size];
        const Node& node = nodes_[n];
        const double from = entry(origin, inverse, node.low, node.high);
        if (from == infinity || from > nearest) continue;
        if (node.count == 0) {
            stack[size++] = node.first;
            stack[size++] = n + 1;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            // Moeller and Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997.
            const std::uint32_t t = order_[i];
            const auto& corners = mesh.triangles[t];
            const glm::dvec3 &a = mesh.positions[corners[0]], &b = mesh.positions[corners[1]],
                             &c = mesh.positions[corners[2]];
            const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(direction, ac);
            const double determinant = glm::dot(ab, p);
            if (determinant == 0.0) continue;
            const glm::dvec3 s = origin - a, q = glm::cross(s, ab);
            const double v = glm::dot(s, p) / determinant, w = glm::dot(direction, q) / determinant;
            const double along = glm::dot(ac, q) / determinant;
            if (v < -rounding || w < -rounding || v + w > 1 + rounding || along < 0) continue;
            if (along > nearest || (along == nearest && t > hit.triangle)) continue;
            nearest = along;
            hit = {t, {1 - v - w, v, w}, origin + along * direction, along * glm::length(direction)};
        }
    }
    return nearest < infinity;
}

bool TriangleTree::meets_path(const Node& node, const glm::dvec3& a, const glm::dvec3& path, double radius) {
    const glm::dvec3 low = glm::dvec3(node.low) - radius, high = glm::dvec3(node.high) + radius;
    double from = 0.0, to = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        if (path[axis] == 0.0) {
            if (a[axis] < low[axis] || a[axis] > high[axis]) return false;
            continue;
        }
        const double s = (low[axis] - a[axis]) / path[axis], e = (high[axis] - a[axis]) / path[axis];
        from = std::max(from, std::min(s, e));
        to = std::min(to, std::max(s, e));
    }
    return from <= to;
}

}  // namespace lapfx
