// The surface of an organ that the host has moved since it was loaded: where a place on the moved shape is at rest, and
// what a ray hits now. The connectivity is the same, so distances at rest stay. One thread at a time.
#pragma once

#include <span>
#include <vector>

#include "organ/surface.h"

namespace lapfx {

class MovedSurface {
  public:
    /// Keeps a reference to `rest`. Until move() is called it is the rest shape.
    explicit MovedSurface(const Surface& rest) : rest_(rest) {}

    /// New positions per organ vertex, mm; O(points). Copies of a welded vertex should move together: the last one
    /// counts.
    void move(std::span<const glm::vec3> positions);
    bool moved() const { return !positions_.empty(); }

    /// Carries `place` to rest: the nearest place on the moved shape goes to its place at rest, with the same distance
    /// from the surface.
    glm::dvec3 to_rest(const glm::dvec3& place) const;
    bool intersect_ray(const glm::dvec3& origin, const glm::dvec3& direction, SurfacePoint& hit) const;

    /// The moved triangles, for places that stay on them.
    TriangleMesh now() const { return moved() ? mesh() : rest_.mesh(); }

    /// Smooth normals of the moved shape, by area and over welded vertices, into `normals` (per organ vertex).
    void normals(std::span<glm::vec3> normals);

  private:
    TriangleMesh mesh() const { return {positions_, rest_.triangles}; }

    const Surface& rest_;
    std::vector<glm::dvec3> positions_;  // per point; empty: not moved
    std::vector<glm::dvec3> sums_;       // each point has its sum of normals
    TriangleTree tree_;
};

}  // namespace lapfx
