#include "bleeding/terrain.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace lapfx::bleeding {

namespace {

constexpr double near_radius = 2.5, far_radius = 5.0;  // mm; creases that guide blood are a few mm wide
constexpr double meeting_gap = 2.0;                    // mm
constexpr int direction_pairs = 3;
constexpr int longest_walk = 2'000;    // triangles; no mesh is finer than 5 um
constexpr double facet_height = 0.06;  // mm; less comes from approximating a smooth surface by triangles
constexpr std::int32_t unknown = -2, no_bridge = -1;

/// Normal of the surface at a point, by area; zero where the triangles around it cancel out.
glm::dvec3 normal_at(const Surface& surface, std::uint32_t point) {
    glm::dvec3 sum(0.0);
    const auto& p = surface.positions;
    for (const std::uint32_t t : surface.triangles_at(point)) {
        const auto& c = surface.triangles[t];
        sum += glm::cross(p[c[1]] - p[c[0]], p[c[2]] - p[c[0]]);
    }
    const double length = glm::length(sum);
    return length > 0.0 ? sum / length : glm::dvec3(0.0);
}

glm::dvec3 any_tangent(const glm::dvec3& normal) {
    const glm::dvec3 axis = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return glm::normalize(glm::cross(normal, axis));
}

}  // namespace

Terrain::Terrain(const Surface& surface, glm::dvec3 down)
    : surface_(surface),
      down_(down),
      crease_(surface.positions.size(), std::numeric_limits<float>::quiet_NaN()),
      bridges_(surface.connected ? 0 : surface.positions.size(), unknown) {}

/// Walks along the normal section of the surface, the curve in which the plane of `normal` and `direction` cuts it, and
/// gives its heights over the tangent plane at near_radius and far_radius of its length. False where it ends before.
bool Terrain::section_heights(std::uint32_t point, const glm::dvec3& normal, const glm::dvec3& direction, double& near,
                              double& far) const {
    const glm::dvec3 origin = surface_.positions[point], across = glm::cross(normal, direction);
    struct End {
        std::uint32_t point;
        double side;  // of the plane, mm
    };
    const auto end_at = [&](std::uint32_t v) { return End{v, glm::dot(surface_.positions[v] - origin, across)}; };
    // The triangle at the point whose opposite edge the section crosses.
    std::uint32_t triangle = 0;
    End a{}, b{};
    glm::dvec3 crossing(0.0);
    bool found = false;
    const auto cross_edge = [&](const End& from, const End& to) {
        if ((from.side < 0.0) == (to.side < 0.0)) return false;
        crossing =
            glm::mix(surface_.positions[from.point], surface_.positions[to.point], from.side / (from.side - to.side));
        a = from;
        b = to;
        return true;
    };
    for (const std::uint32_t t : surface_.triangles_at(point)) {
        const auto& c = surface_.triangles[t];
        const int i = c[0] == point ? 0 : c[1] == point ? 1 : 2;
        if (!cross_edge(end_at(c[(i + 1) % 3]), end_at(c[(i + 2) % 3])) ||
            glm::dot(crossing - origin, direction) <= 0.0)
            continue;
        triangle = t;
        found = true;
        break;
    }
    if (!found) return false;
    double walked = 0.0;
    glm::dvec3 place = origin;
    bool near_known = false;
    const auto height_at = [&](double radius, double step) {
        return glm::dot(glm::mix(place, crossing, (radius - walked) / step) - origin, normal);
    };
    for (int i = 0; i < longest_walk; ++i) {
        const double step = glm::distance(place, crossing);
        if (!near_known && walked + step >= near_radius) {
            near = height_at(near_radius, step);
            near_known = true;
        }
        if (walked + step >= far_radius) {
            far = height_at(far_radius, step);
            return true;
        }
        walked += step;
        place = crossing;
        std::uint32_t next = 0;
        if (!surface_.across(triangle, a.point, b.point, next)) return false;
        triangle = next;
        const auto& c = surface_.triangles[triangle];
        const auto is_new = [&](std::uint32_t v) { return v != a.point && v != b.point; };
        const End apex = end_at(is_new(c[0]) ? c[0] : is_new(c[1]) ? c[1] : c[2]), left = a, right = b;
        if (!cross_edge(left, apex) && !cross_edge(right, apex)) return false;
    }
    return false;
}

double Terrain::crease(std::uint32_t point) {
    float& known = crease_[point];
    if (!std::isnan(known)) return known;
    const glm::dvec3 normal = normal_at(surface_, point);
    known = 0.0f;
    if (normal == glm::dvec3(0.0)) return known;
    const glm::dvec3 u = any_tangent(normal), v = glm::cross(normal, u);
    double sum = 0.0;
    int pairs = 0;
    for (int i = 0; i < direction_pairs; ++i) {
        const double angle = std::numbers::pi * (i + 0.5) / direction_pairs;
        const glm::dvec3 direction = std::cos(angle) * u + std::sin(angle) * v;
        double near[2] = {}, far[2] = {};
        // Only both directions together, so that a slightly wrong slope of the tangent plane cancels out.
        if (!section_heights(point, normal, direction, near[0], far[0]) ||
            !section_heights(point, normal, -direction, near[1], far[1]))
            continue;
        constexpr double explained = near_radius * near_radius / (far_radius * far_radius);
        sum += 0.5 * (near[0] + near[1]) - explained * 0.5 * (far[0] + far[1]);
        ++pairs;
    }
    if (pairs > 0) known = static_cast<float>(sum / pairs);
    return known;
}

double Terrain::slowness(std::uint32_t point, double crease_bias) {
    if (crease_bias <= 0.0) return 1.0;
    const double c = crease(point);
    double drawn = std::clamp((c - facet_height) / 0.5, 0.0, 1.0);
    // The line along which two parts meet is a crease too.
    if (const SurfacePoint* other = bridge(point)) drawn = std::max(drawn, 1.0 - other->distance / meeting_gap);
    if (drawn > 0.0) return 1.0 - most_drawn * crease_bias * drawn;
    return 1.0 + 0.33 * crease_bias * std::clamp((-c - facet_height) / 0.5, 0.0, 1.0);
}

const SurfacePoint* Terrain::bridge(std::uint32_t point) {
    if (surface_.connected) return nullptr;
    std::int32_t& known = bridges_[point];
    if (known == unknown) {
        SurfacePoint place;
        known = no_bridge;
        if (surface_.closest_on_other_component(surface_.positions[point], surface_.component[point], bridge_longest,
                                                place)) {
            known = static_cast<std::int32_t>(places_.size());
            places_.push_back(place);
        }
    }
    return known == no_bridge ? nullptr : &places_[static_cast<std::size_t>(known)];
}

}  // namespace lapfx::bleeding
