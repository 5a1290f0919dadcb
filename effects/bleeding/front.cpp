#include "bleeding/front.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lapfx::bleeding {

namespace {

constexpr double least_gain = 1e-9;  // mm; a smaller gain is rounding and would not end

/// Distance at `c` when the distances `da` at `a` and `db` at `b` come from one point source. The source is unfolded
/// into the triangle's plane, on the far side of ab. The straight line from it must cross ab; otherwise the path
/// follows an edge.
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
    // A source on the line through ab may come out slightly below 0; anything more is not a triangle.
    if (sy_squared < -1e-9 * da * da || cy <= 0.0) return along_edges;
    const double sy = std::sqrt(std::max(sy_squared, 0.0));
    const double crossing = sx + (cx - sx) * sy / (sy + cy);
    if (crossing < 0.0 || crossing > length) return along_edges;
    return std::hypot(cx - sx, cy + sy);
}

}  // namespace

bool is_place(const glm::dvec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

Metric metric_of(const BleedingParameters& b) {
    return {.gravity_bias = b.gravity_bias, .crease_bias = b.crease_bias, .bridge_gap = b.bridge_gap};
}

Front::Front(FrontRoom& room, const Metric& metric, const glm::dvec3& contact)
    : metric_(metric), id_(++room.fronts_), done_(room.surface.triangles.empty() || !is_place(contact)) {
    if (done_) return;
    const Surface& surface = room.surface;
    const SurfacePoint start = surface.closest_point(contact);
    for (int i = 0; i < 3; ++i)
        start_drop_ += start.weights[i] * room.terrain.drop(surface.triangles[start.triangle][i]);
    load(room);
    for (const std::uint32_t corner : surface.triangles[start.triangle])
        offer(corner, glm::distance(surface.positions[corner], start.position), room);
    for (Known& known : pending_) known.length = room.cells_[known.vertex].length;
}

double Front::distance_of(std::uint32_t vertex, double length, const FrontRoom& room) const {
    return length - metric_.gravity_bias * (room.terrain.drop(vertex) - start_drop_);
}

std::span<const Reached> Front::ring(std::size_t ring, FrontRoom& room) {
    while (!done_ && ring >= rings_.size()) march_ring(room);
    if (ring >= rings_.size()) return {};
    const std::size_t begin = ring == 0 ? 0 : rings_[ring - 1].end;
    return std::span(reached_).subspan(begin, rings_[ring].end - begin);
}

/// Fronts take turns in the shared memory. Of frozen vertices only the rim, from which the front grows, needs more than
/// the fact that they are frozen.
void Front::load(FrontRoom& room) {
    if (room.loaded_ == id_) return;
    room.loaded_ = id_;
    ++room.stamp_;
    // Offers go outwards from the rim; only a bridge can lead back into the middle.
    if (metric_.bridge_gap > 0.0 && !room.surface.connected)
        for (const Reached& r : reached_) room.cells_[r.vertex] = {0.0, room.stamp_, true};
    for (const Known& known : rim_) room.cells_[known.vertex] = {known.length, room.stamp_, true};
    for (const Known& known : pending_) room.cells_[known.vertex] = {known.length, room.stamp_, false};
}

/// Marching that also corrects. Near a point source, and with obtuse triangles, a vertex can be reached before both
/// ends of the edge that its straight line crosses are final. unfold() does not decrease when one of its distances
/// increases, so offers from preliminary distances are too long at worst, and better ones replace them.
void Front::march_ring(FrontRoom& room) {
    load(room);
    const double limit = static_cast<double>(rings_.size() + 1) * ring_width;
    while (!candidates_.empty()) {
        const auto [distance, vertex] = candidates_.front();
        // One end of an edge on the way to a vertex within the limit may be just beyond the limit.
        if (distance > limit + 2.0 * longest_edge_) break;
        std::pop_heap(candidates_.begin(), candidates_.end());
        candidates_.pop_back();
        const FrontRoom::Cell& cell = room.cells_[vertex];
        if (cell.frozen || distance > distance_of(vertex, cell.length, room)) continue;  // an older, longer offer
        for (const std::uint32_t triangle : room.surface.triangles_at(vertex)) spread_over(triangle, vertex, room);
        cross_bridge(vertex, room);
    }
    freeze(limit, room);
    done_ = candidates_.empty() && pending_.empty();
}

/// Distances within the limit are final: they become the next ring.
void Front::freeze(double limit, FrontRoom& room) {
    const std::size_t begin = reached_.size();
    const auto still_pending = [&](Known& known) {
        FrontRoom::Cell& cell = room.cells_[known.vertex];
        known.length = cell.length;
        const double distance = distance_of(known.vertex, cell.length, room);
        if (distance > limit) return true;
        cell.frozen = true;
        reached_.push_back({known.vertex, static_cast<float>(distance)});
        rim_.push_back(known);
        return false;
    };
    pending_.erase(std::stable_partition(pending_.begin(), pending_.end(), still_pending), pending_.end());
    std::sort(reached_.begin() + static_cast<std::ptrdiff_t>(begin), reached_.end(),
              [](const Reached& a, const Reached& b) { return a.vertex < b.vertex; });
    const auto is_frozen = [&](std::uint32_t v) {
        return room.cells_[v].stamp == room.stamp_ && room.cells_[v].frozen;
    };
    std::erase_if(rim_, [&](const Known& known) {
        const auto around = room.surface.neighbours_of(known.vertex);
        return std::all_of(around.begin(), around.end(), is_frozen);
    });
    rings_.push_back({reached_.size(), longest_edge_});
}

void Front::offer(std::uint32_t vertex, double length, FrontRoom& room) {
    FrontRoom::Cell& cell = room.cells_[vertex];
    if (cell.stamp != room.stamp_) {
        cell = {std::numeric_limits<double>::infinity(), room.stamp_, false};
        pending_.push_back({vertex, length});
    }
    if (cell.frozen || !(length < cell.length - least_gain)) return;
    cell.length = length;
    candidates_.push_back({distance_of(vertex, length, room), vertex});
    std::push_heap(candidates_.begin(), candidates_.end());
}

/// Offers a distance to both other corners of the triangle, now that the one at `from` has changed.
void Front::spread_over(std::uint32_t triangle, std::uint32_t from, FrontRoom& room) {
    const auto& corners = room.surface.triangles[triangle];
    const auto& p = room.surface.positions;
    double slowness = 1.0;
    if (metric_.crease_bias > 0.0) {
        slowness = 0.0;
        for (const std::uint32_t c : corners) slowness += room.terrain.slowness(c, metric_.crease_bias) / 3.0;
        // Gravity alone must not drive blood: each mm costs something in every direction.
        slowness = std::max(slowness, std::min(1.0, metric_.gravity_bias + least_cost));
    }
    const auto known = [&](std::uint32_t v) { return room.cells_[v].stamp == room.stamp_; };
    const auto length = [&](std::uint32_t v) { return room.cells_[v].length / slowness; };
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t c = corners[i], a = corners[(i + 1) % 3], b = corners[(i + 2) % 3];
        if (c == from) continue;
        longest_edge_ = std::max(longest_edge_, glm::distance(p[from], p[c]));
        const std::uint32_t other = a == from ? b : a;
        if (known(other))
            offer(c, slowness * unfold(p[a], p[b], p[c], length(a), length(b)), room);
        else
            offer(c, slowness * (length(from) + glm::distance(p[from], p[c])), room);
    }
}

/// Blood continues where one part of the organ touches the next.
void Front::cross_bridge(std::uint32_t from, FrontRoom& room) {
    if (metric_.bridge_gap <= 0.0) return;
    const SurfacePoint* place = room.terrain.bridge(from);
    if (place == nullptr || place->distance > metric_.bridge_gap) return;
    const double there = room.cells_[from].length + place->distance;
    for (const std::uint32_t c : room.surface.triangles[place->triangle])
        offer(c, there + glm::distance(place->position, room.surface.positions[c]), room);
}

std::vector<Reached> march(FrontRoom& room, const Metric& metric, const glm::dvec3& contact, double limit) {
    Front front(room, metric, contact);
    std::vector<Reached> all;
    for (std::size_t i = 0; !front.ended(i) && static_cast<double>(i) * Front::ring_width <= limit; ++i)
        for (const Reached& r : front.ring(i, room))
            if (r.distance <= limit) all.push_back(r);
    std::sort(all.begin(), all.end(), [](const Reached& a, const Reached& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.vertex < b.vertex;
    });
    return all;
}

}  // namespace lapfx::bleeding
