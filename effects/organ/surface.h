// The surface of an organ as one sheet, for distances along it and for pointing at it.
//
// Vertices of the organ at the same position are one point here, so that a texture seam or a flat-shaded edge
// does not cut the surface. Built once for an organ; all queries are const and may run on any thread.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "lapfx/organ.h"

namespace lapfx {

/// A place on the surface.
struct SurfacePoint {
    std::uint32_t triangle = 0;
    glm::dvec3 weights{0.0};   ///< barycentric, of the triangle's three points; sum 1
    glm::dvec3 position{0.0};  ///< mm
    double distance = 0.0;     ///< mm from what was asked for: the point, or the ray's origin
};

class Surface {
  public:
    Surface() = default;
    explicit Surface(const Organ& organ);

    std::vector<std::uint32_t> weld;                      ///< organ vertex to point
    std::vector<glm::dvec3> positions;                    ///< of the points, mm
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< points, in the order of the organ's triangles
    std::vector<std::uint32_t> triangle_start;            ///< per point, into point_triangles; one more at the end
    std::vector<std::uint32_t> point_triangles;           ///< triangles at each point, ascending
    std::vector<std::uint32_t> neighbour_start;           ///< per point, into point_neighbours; one more at the end
    std::vector<std::uint32_t> point_neighbours;          ///< points joined by an edge, ascending

    std::span<const std::uint32_t> triangles_at(std::uint32_t point) const {
        return std::span(point_triangles)
            .subspan(triangle_start[point], triangle_start[point + 1] - triangle_start[point]);
    }
    std::span<const std::uint32_t> neighbours_of(std::uint32_t point) const {
        return std::span(point_neighbours)
            .subspan(neighbour_start[point], neighbour_start[point + 1] - neighbour_start[point]);
    }

    /// The place nearest to `point`; of equally near ones, that of the lowest triangle. The surface must not
    /// be empty.
    SurfacePoint closest_point(const glm::dvec3& point) const;

    /// All points within `radius` mm of `centre`, of whatever part of the surface, replacing what `out` held; each once, in
    /// an order that depends on the surface alone. Points without a triangle are never found. Allocates only to
    /// grow `out`.
    void points_within(const glm::dvec3& centre, double radius, std::vector<std::uint32_t>& out) const;

    /// The first place that the ray hits, from either side; false when it misses. `direction` need not be
    /// unit length.
    bool intersect_ray(const glm::dvec3& origin, const glm::dvec3& direction, SurfacePoint& hit) const;

  private:
    /// A box around a run of triangles, or around two boxes.
    struct Node {
        glm::vec3 low, high;
        std::uint32_t first = 0;  ///< leaf: into order_; else the second child (the first is the next node)
        std::uint32_t count = 0;  ///< leaf: triangles; else 0
    };

    void build_adjacency();
    void build_tree();

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;  ///< triangles, by leaf
};

}  // namespace lapfx
