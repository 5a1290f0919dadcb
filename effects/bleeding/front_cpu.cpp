#include "bleeding/front_cpu.h"

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
    if (sy_squared < 0.0 || cy <= 0.0) return along_edges;
    const double sy = std::sqrt(sy_squared);
    const double crossing = sx + (cx - sx) * sy / (sy + cy);
    if (crossing < 0.0 || crossing > length) return along_edges;
    return std::hypot(cx - sx, cy + sy);
}

class March {
  public:
    explicit March(const Surface& surface)
        : surface_(surface), distance_(surface.positions.size(), unreached), done_(surface.positions.size(), false) {}

    void offer(std::uint32_t vertex, double distance) {
        if (done_[vertex] || distance >= distance_[vertex]) return;
        distance_[vertex] = distance;
        front_.push({distance, vertex});
    }

    std::vector<Reached> run(double limit) {
        std::vector<Reached> reached;
        while (!front_.empty()) {
            const auto [distance, vertex] = front_.top();
            front_.pop();
            if (done_[vertex] || distance > distance_[vertex]) continue;  // an older, longer offer
            if (distance > limit) break;
            done_[vertex] = true;
            reached.push_back({vertex, distance});
            for (const std::uint32_t triangle : surface_.triangles_at(vertex)) spread_over(triangle);
        }
        return reached;
    }

  private:
    /// Offers a distance to each open corner of the triangle, from the corners that are done.
    void spread_over(std::uint32_t triangle) {
        const auto& corners = surface_.triangles[triangle];
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t c = corners[i], a = corners[(i + 1) % 3], b = corners[(i + 2) % 3];
            if (done_[c] || (!done_[a] && !done_[b])) continue;
            const auto& p = surface_.positions;
            if (done_[a] && done_[b])
                offer(c, unfold(p[a], p[b], p[c], distance_[a], distance_[b]));
            else
                offer(c,
                      done_[a] ? distance_[a] + glm::distance(p[a], p[c]) : distance_[b] + glm::distance(p[b], p[c]));
        }
    }

    const Surface& surface_;
    std::vector<double> distance_;
    std::vector<char> done_;
    std::priority_queue<Candidate> front_;
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
