// The organ as one surface: vertices at the same place joined, so that texture seams and separate meshes that touch do not
// cut it. Distances travel over this, rays and contacts find it. Immutable after construction; any thread. Lengths mm.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "lapfx/organ.h"

namespace lapfx::organ {

/// A point of the surface: in `triangle`, at `barycentric` of its corners.
struct ClosestPoint {
    std::uint32_t triangle = 0;
    glm::dvec3 barycentric{1.0, 0.0, 0.0};
    glm::dvec3 position{0.0};
    double distance = 0.0;  ///< mm from what was asked
};

class Surface {
  public:
    explicit Surface(const Organ& organ);

    std::vector<std::uint32_t> weld;     ///< surface vertex of each organ vertex
    std::vector<glm::dvec3> positions;   ///< mm, per surface vertex
    std::vector<glm::uvec3> triangles;   ///< surface vertices, in the organ's order; those that collapse are left out

    std::span<const std::uint32_t> triangles_of(std::uint32_t vertex) const {
        return {around_.data() + first_around_[vertex], around_.data() + first_around_[vertex + 1]};
    }

    /// The nearest point of the surface; of equally near ones that in the lowest triangle. Needs at least one triangle.
    ClosestPoint closest_point(glm::dvec3 point) const;
    /// The first point along a ray, either side of a triangle; `direction` need not be unit. Distance in mm.
    std::optional<ClosestPoint> intersect_ray(glm::dvec3 origin, glm::dvec3 direction) const;

  private:
    /// Bounding volume hierarchy: a node holds two children, or the triangles order_[first, first + count).
    struct Node {
        glm::dvec3 minimum, maximum;
        std::uint32_t first = 0, count = 0;  ///< count 0: children at `first` and `first + 1`
    };
    void build_adjacency();
    void build_nodes();
    void fit(Node& node) const;

    std::vector<std::uint32_t> first_around_, around_;  // triangles of vertex v: around_[first_around_[v] ..]
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace lapfx::organ
