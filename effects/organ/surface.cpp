#include "organ/surface.h"

#include <cassert>

#include "organ/path.h"
#include "organ/weld.h"

namespace lapfx {

namespace {

/// Offsets of runs from their lengths: {2, 0, 1} becomes {0, 2, 2, 3}.
std::vector<std::uint32_t> starts(const std::vector<std::uint32_t>& lengths) {
    std::vector<std::uint32_t> out(lengths.size() + 1, 0);
    for (std::size_t i = 0; i < lengths.size(); ++i) out[i + 1] = out[i] + lengths[i];
    return out;
}

}  // namespace

Surface::Surface(const Organ& organ, const work::Stages& stages) {
    stages.reach(0.0);
    organ::Weld welded = organ::weld_surface(organ.positions, organ.indices);
    weld = std::move(welded.point);
    positions.resize(welded.points);
    for (std::size_t v = 0; v < weld.size(); ++v) positions[weld[v]] = glm::dvec3(organ.positions[v]);
    triangles.resize(organ.triangle_count());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c) triangles[t][c] = weld[organ.indices[3 * t + c]];
    stages.reach(0.2);
    index_vertices();
    build_adjacency();
    stages.reach(0.5);
    find_components();
    stages.reach(0.6);
    tree_.build(mesh());
    stages.reach(1.0);
}

double Surface::area(std::uint32_t triangle) const {
    const auto& c = triangles[triangle];
    return 0.5 * glm::length(glm::cross(positions[c[1]] - positions[c[0]], positions[c[2]] - positions[c[0]]));
}

std::size_t Surface::memory() const {
    const auto indices = weld.size() + triangle_start.size() + point_triangles.size() + neighbour_start.size() +
                         point_neighbours.size() + vertex_start.size() + point_vertices.size() + component.size() +
                         3 * triangles.size();
    return positions.size() * sizeof(glm::dvec3) + indices * sizeof(std::uint32_t);
}

void Surface::index_vertices() {
    std::vector<std::uint32_t> lengths(positions.size(), 0);
    for (const std::uint32_t point : weld) ++lengths[point];
    vertex_start = starts(lengths);
    point_vertices.resize(weld.size());
    std::vector<std::uint32_t> next(vertex_start.begin(), vertex_start.end() - 1);
    for (std::uint32_t v = 0; v < weld.size(); ++v) point_vertices[next[weld[v]]++] = v;
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

void Surface::find_components() {
    component.resize(positions.size());
    for (std::uint32_t i = 0; i < component.size(); ++i) component[i] = i;
    const auto root = [&](std::uint32_t p) {
        while (component[p] != p) p = component[p] = component[component[p]];
        return p;
    };
    for (const auto& corners : triangles)
        for (int i = 1; i < 3; ++i) {
            const std::uint32_t a = root(corners[0]), b = root(corners[i]);
            component[std::max(a, b)] = std::min(a, b);
        }
    for (std::uint32_t i = 0; i < component.size(); ++i) component[i] = root(i);
    connected = std::all_of(triangles.begin(), triangles.end(),
                            [&](const auto& corners) { return component[corners[0]] == component[triangles[0][0]]; });
}

SurfacePoint Surface::closest_point(const glm::dvec3& point) const {
    assert(!triangles.empty());
    SurfacePoint place;
    tree_.nearest(mesh(), point, place);
    return place;
}

bool Surface::closest_on_other_component(const glm::dvec3& point, std::uint32_t component_of_point, double within,
                                         SurfacePoint& place) const {
    return !connected && tree_.nearest(mesh(), point, place, within, {component, component_of_point});
}

bool Surface::intersect_ray(const glm::dvec3& origin, const glm::dvec3& direction, SurfacePoint& hit) const {
    return tree_.first_hit(mesh(), origin, direction, hit);
}

void Surface::points_within(const glm::dvec3& centre, double radius, std::vector<std::uint32_t>& out) const {
    out.clear();
    if (!(radius >= 0.0)) return;
    tree_.near_path(centre, centre, radius, [&](std::uint32_t t) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t point = triangles[t][c];
            // A point is found by its first triangle, and that triangle's first corner there.
            if (point_triangles[triangle_start[point]] != t) continue;
            if ((c > 0 && triangles[t][0] == point) || (c > 1 && triangles[t][1] == point)) continue;
            if (glm::distance(positions[point], centre) <= radius) out.push_back(point);
        }
    });
}

std::vector<std::uint32_t> Surface::points_near(const glm::dvec3& a, const glm::dvec3& b, double radius) const {
    std::vector<std::uint32_t> points;
    tree_.near_path(a, b, radius, [&](std::uint32_t t) {
        for (const std::uint32_t p : triangles[t])
            if (organ::distance_to_path(positions[p], a, b) <= radius) points.push_back(p);
    });
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

bool Surface::across(std::uint32_t triangle, std::uint32_t p, std::uint32_t q, std::uint32_t& other) const {
    for (const std::uint32_t t : triangles_at(p)) {
        const auto& corners = triangles[t];
        if (t == triangle || (corners[0] != q && corners[1] != q && corners[2] != q)) continue;
        other = t;
        return true;
    }
    return false;
}

}  // namespace lapfx
