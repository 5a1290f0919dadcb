#include "organ/moved_surface.h"

namespace lapfx {

void MovedSurface::move(std::span<const glm::vec3> positions) {
    if (positions_.empty()) {
        positions_.resize(rest_.positions.size());
        tree_ = rest_.tree();
    }
    for (std::size_t v = 0; v < positions.size(); ++v) positions_[rest_.weld[v]] = glm::dvec3(positions[v]);
    tree_.refit(mesh());
}

glm::dvec3 MovedSurface::to_rest(const glm::dvec3& place) const {
    SurfacePoint nearest;
    if (!moved() || !tree_.nearest(mesh(), place, nearest)) return place;
    const auto& corners = rest_.triangles[nearest.triangle];
    glm::dvec3 at_rest = place - nearest.position;
    for (int i = 0; i < 3; ++i) at_rest += nearest.weights[i] * rest_.positions[corners[i]];
    return at_rest;
}

bool MovedSurface::intersect_ray(const glm::dvec3& origin, const glm::dvec3& direction, SurfacePoint& hit) const {
    return moved() ? tree_.first_hit(mesh(), origin, direction, hit) : rest_.intersect_ray(origin, direction, hit);
}

void MovedSurface::normals(std::span<glm::vec3> normals) {
    sums_.assign(rest_.positions.size(), glm::dvec3(0.0));
    const std::vector<glm::dvec3>& p = moved() ? positions_ : rest_.positions;
    for (const auto& c : rest_.triangles) {
        const glm::dvec3 normal = glm::cross(p[c[1]] - p[c[0]], p[c[2]] - p[c[0]]);  // its length is twice the area
        for (const std::uint32_t corner : c) sums_[corner] += normal;
    }
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const glm::dvec3& sum = sums_[rest_.weld[v]];
        const double length = glm::length(sum);
        normals[v] = length > 0.0 ? glm::vec3(sum / length) : glm::vec3(0.0f, 1.0f, 0.0f);
    }
}

}  // namespace lapfx
