#include "organ/surface.h"

#include <cassert>
#include <limits>

#include "organ/weld.h"

namespace lapfx {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t leaf_size = 4;
/// Halving a leaf's triangles each time, no tree of 2^32 triangles is deeper.
constexpr std::size_t deepest = 64;

/// Offsets of runs from their lengths: {2, 0, 1} becomes {0, 2, 2, 3}.
std::vector<std::uint32_t> starts(const std::vector<std::uint32_t>& lengths) {
    std::vector<std::uint32_t> out(lengths.size() + 1, 0);
    for (std::size_t i = 0; i < lengths.size(); ++i) out[i + 1] = out[i] + lengths[i];
    return out;
}

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
        double a = (low[axis] - origin[axis]) * inverse[axis], b = (high[axis] - origin[axis]) * inverse[axis];
        if (a > b) std::swap(a, b);
        // A ray within a side plane gives 0 * infinity = NaN; such a side does not limit it.
        if (a > from) from = a;
        if (b < to) to = b;
    }
    // Boxes are rounded outwards by less than this.
    return from <= to * (1 + 1e-12) ? from : infinity;
}

}  // namespace

Surface::Surface(const Organ& organ) {
    organ::Weld welded = organ::weld_positions(organ.positions);
    weld = std::move(welded.point);
    positions.resize(welded.points);
    for (std::size_t v = 0; v < weld.size(); ++v) positions[weld[v]] = glm::dvec3(organ.positions[v]);
    triangles.resize(organ.triangle_count());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c) triangles[t][c] = weld[organ.indices[3 * t + c]];
    build_adjacency();
    if (!triangles.empty()) build_tree();
}

void Surface::build_adjacency() {
    std::vector<std::uint32_t> lengths(positions.size(), 0);
    for (const auto& triangle : triangles)
        for (const std::uint32_t point : triangle) ++lengths[point];
    triangle_start = starts(lengths);
    point_triangles.resize(triangle_start.back());
    std::vector<std::uint32_t> next(triangle_start.begin(), triangle_start.end() - 1);
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (const std::uint32_t point : triangles[t]) point_triangles[next[point]++] = t;

    neighbour_start.assign(1, 0);
    std::vector<std::uint32_t> around;
    for (std::uint32_t point = 0; point < positions.size(); ++point) {
        around.clear();
        for (const std::uint32_t t : triangles_at(point))
            for (const std::uint32_t other : triangles[t])
                if (other != point) around.push_back(other);
        std::sort(around.begin(), around.end());
        around.erase(std::unique(around.begin(), around.end()), around.end());
        point_neighbours.insert(point_neighbours.end(), around.begin(), around.end());
        neighbour_start.push_back(static_cast<std::uint32_t>(point_neighbours.size()));
    }
}

void Surface::build_tree() {
    std::vector<glm::vec3> centres(triangles.size());
    order_.resize(triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        order_[t] = t;
        for (const std::uint32_t point : triangles[t]) centres[t] += glm::vec3(positions[point]) / 3.0f;
    }
    struct Job {
        std::uint32_t first, count;
        std::uint32_t parent;  ///< whose second child this is
    };
    constexpr std::uint32_t none = 0xffffffff;
    std::vector<Job> jobs{{0, static_cast<std::uint32_t>(order_.size()), none}};
    nodes_.reserve(triangles.size());
    while (!jobs.empty()) {
        const Job job = jobs.back();
        jobs.pop_back();
        if (job.parent != none) nodes_[job.parent].first = static_cast<std::uint32_t>(nodes_.size());
        Node node{glm::vec3(std::numeric_limits<float>::max()), glm::vec3(std::numeric_limits<float>::lowest()),
                  job.first, job.count};
        for (std::uint32_t i = job.first; i < job.first + job.count; ++i)
            for (const std::uint32_t point : triangles[order_[i]]) {
                // Positions came from floats: the boxes are exact.
                node.low = glm::min(node.low, glm::vec3(positions[point]));
                node.high = glm::max(node.high, glm::vec3(positions[point]));
            }
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        if (job.count > leaf_size) {
            const glm::vec3 size = node.high - node.low;
            const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            const std::uint32_t half = job.count / 2;
            const auto begin = order_.begin() + job.first;
            // Ties go by number, so that the tree is the same everywhere.
            std::nth_element(begin, begin + half, begin + job.count, [&](std::uint32_t a, std::uint32_t b) {
                return centres[a][axis] != centres[b][axis] ? centres[a][axis] < centres[b][axis] : a < b;
            });
            node.count = 0;
            jobs.push_back({job.first + half, job.count - half, index});
            jobs.push_back({job.first, half, none});
        }
        nodes_.push_back(node);
    }
}

SurfacePoint Surface::closest_point(const glm::dvec3& point) const {
    assert(!triangles.empty());
    SurfacePoint best;
    double best_square = infinity;
    std::array<std::uint32_t, deepest> stack;
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
            const glm::dvec3 &a = positions[triangles[t][0]], &b = positions[triangles[t][1]],
                             &c = positions[triangles[t][2]];
            const glm::dvec3 weights = nearest_weights(point, a, b, c);
            const glm::dvec3 place = weights.x * a + weights.y * b + weights.z * c;
            const double d = square(place - point);
            if (d < best_square || (d == best_square && t < best.triangle)) {
                best_square = d;
                best = {t, weights, place, 0.0};
            }
        }
    }
    best.distance = std::sqrt(best_square);
    return best;
}

void Surface::points_within(const glm::dvec3& centre, double radius, std::vector<std::uint32_t>& out) const {
    out.clear();
    if (nodes_.empty() || !(radius >= 0.0)) return;
    const double limit = radius * radius;
    std::array<std::uint32_t, deepest> stack;
    std::size_t size = 0;
    stack[size++] = 0;
    while (size > 0) {
        const std::uint32_t n = stack[--size];
        const Node& node = nodes_[n];
        if (distance_to_box(centre, node.low, node.high) > limit) continue;
        if (node.count == 0) {
            stack[size++] = node.first;
            stack[size++] = n + 1;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const std::uint32_t t = order_[i];
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint32_t point = triangles[t][c];
                // Its first triangle tells of a point, and that triangle's first corner there.
                if (point_triangles[triangle_start[point]] != t) continue;
                if ((c > 0 && triangles[t][0] == point) || (c > 1 && triangles[t][1] == point)) continue;
                if (square(positions[point] - centre) <= limit) out.push_back(point);
            }
        }
    }
}

bool Surface::intersect_ray(const glm::dvec3& origin, const glm::dvec3& direction, SurfacePoint& hit) const {
    if (nodes_.empty() || !(square(direction) > 0.0)) return false;
    const glm::dvec3 inverse = 1.0 / direction;
    double nearest = infinity;
    std::array<std::uint32_t, deepest> stack;
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
            const glm::dvec3 &a = positions[triangles[t][0]], &b = positions[triangles[t][1]],
                             &c = positions[triangles[t][2]];
            const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(direction, ac);
            const double determinant = glm::dot(ab, p);
            if (determinant == 0.0) continue;
            const glm::dvec3 s = origin - a, q = glm::cross(s, ab);
            const double v = glm::dot(s, p) / determinant, w = glm::dot(direction, q) / determinant;
            const double along = glm::dot(ac, q) / determinant;
            if (v < 0 || w < 0 || v + w > 1 || along < 0) continue;
            if (along > nearest || (along == nearest && t > hit.triangle)) continue;
            nearest = along;
            hit = {t, {1 - v - w, v, w}, origin + along * direction, along * glm::length(direction)};
        }
    }
    return nearest < infinity;
}

}  // namespace lapfx
