#include "bleeding/front_cpu.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace lapfx::bleeding {

namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

struct Candidate {
    double distance;
    std::uint32_t vertex;
    // The smallest distance first; equal distances in vertex order, so that results repeat.
    bool operator<(const Candidate& other) const {
        return distance != other.distance ? distance > other.distance : vertex > other.vertex;
    }
};

/// Distance at `c` when the distances `da` at `a` and `db` at `b` come from one point source: the source is
/// laid out in the triangle's plane, on the far side of ab; the straight line from it must cross ab, else the
/// way goes along an edge.
double unfold(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double da, double db) {
    const double along_edges = std::min(da + glm::distance(a, c), db + glm::distance(b, c));
    const glm::dvec3 ab = b - a, ac = c - a;
    const double length = glm::length(ab);
    if (length <= 0.0) return along_edges;
    // Plane coordinates: a = (0, 0), b = (length, 0), c = (cx, cy) above the axis, the source (sx, -sy) below
    // it.
    const double cx = glm::dot(ac, ab) / length;
    const double cy = std::sqrt(std::max(0.0, glm::dot(ac, ac) - cx * cx));
    const double sx = (da * da - db * db + length * length) / (2.0 * length);
    const double sy_squared = da * da - sx * sx;
    // A source on the line through ab comes out as a hair below 0; anything more is no triangle.
    if (sy_squared < -1e-9 * da * da || cy <= 0.0) return along_edges;
    const double sy = std::sqrt(std::max(sy_squared, 0.0));
    const double crossing = sx + (cx - sx) * sy / (sy + cy);
    if (crossing < 0.0 || crossing > length) return along_edges;
    return std::hypot(cx - sx, cy + sy);
}

/// Marching that also corrects: near a point source, and with obtuse triangles, a vertex can be met before both ends of the
/// edge that its straight line crosses are known for good. unfold() never shrinks when a distance that goes in grows, so
/// offers made from preliminary distances are too long at worst, and are replaced when the better ones arrive.
class March {
  public:
    explicit March(const Surface& surface) : surface_(surface), distance_(surface.positions.size(), unreached) {}

    void offer(std::uint32_t vertex, double distance) {
        if (!(distance < distance_[vertex] - least_gain)) return;
        if (distance_[vertex] == unreached) met_.push_back(vertex);
        distance_[vertex] = distance;
        front_.push({distance, vertex});
    }

    std::vector<Reached> run(double limit) {
        while (!front_.empty()) {
            const auto [distance, vertex] = front_.top();
            // Just beyond the limit there may be one end of an edge that is crossed on the way to a vertex within it.
            if (distance > limit + longest_edge_) break;
            front_.pop();
            if (distance > distance_[vertex]) continue;  // an older, longer offer
            for (const std::uint32_t triangle : surface_.triangles_at(vertex)) spread_over(triangle, vertex);
        }
        std::vector<Reached> reached;
        for (const std::uint32_t vertex : met_)
            if (distance_[vertex] <= limit) reached.push_back({vertex, distance_[vertex]});
        std::sort(reached.begin(), reached.end(), [](const Reached& a, const Reached& b) {
            return a.distance != b.distance ? a.distance < b.distance : a.vertex < b.vertex;
        });
        return reached;
    }

  private:
    static constexpr double least_gain = 1e-9;  // mm; less is rounding, and would only go in circles

    /// Offers a distance to both other corners of the triangle, now that the one at `from` has changed.
    void spread_over(std::uint32_t triangle, std::uint32_t from) {
        const auto& corners = surface_.triangles[triangle];
        const auto& p = surface_.positions;
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t c = corners[i], a = corners[(i + 1) % 3], b = corners[(i + 2) % 3];
            if (c == from) continue;
            longest_edge_ = std::max(longest_edge_, glm::distance(p[from], p[c]));
            const std::uint32_t other = a == from ? b : a;
            if (distance_[other] < unreached)
                offer(c, unfold(p[a], p[b], p[c], distance_[a], distance_[b]));
            else
                offer(c, distance_[from] + glm::distance(p[from], p[c]));
        }
    }

    const Surface& surface_;
    std::vector<double> distance_;
    std::vector<std::uint32_t> met_;  // vertices with a distance, in no order
    std::priority_queue<Candidate> front_;
    double longest_edge_ = 0.0;
};

}  // namespace

std::vector<Reached> march(const Surface& surface, glm::dvec3 contact, double limit) {
    if (surface.triangles.empty()) return {};
    const SurfacePoint start = surface.closest_point(contact);
    March march(surface);
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t corner = surface.triangles[start.triangle][i];
        march.offer(corner, glm::distance(surface.positions[corner], start.position));
    }
    return march.run(limit);
}

}  // namespace lapfx::bleeding
