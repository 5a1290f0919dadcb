// The surface of an organ as one sheet, for distances along it and for pointing at it.
//
// Vertices at the same position are one point here, and so are those along seams that rounding has torn (organ/weld.h),
// so that texture seams and flat-shaded edges do not cut the surface. It is built once for an organ; all queries are
// const and may run on any thread.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "lapfx/organ.h"
#include "organ/triangle_tree.h"
#include "work/stages.h"

namespace lapfx {

class Surface {
  public:
    Surface() = default;
    explicit Surface(const Organ& organ, const work::Stages& stages = {});

    std::vector<std::uint32_t> weld;                      ///< organ vertex to point
    std::vector<glm::dvec3> positions;                    ///< of the points, mm
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< points, in the order of the organ's triangles
    std::vector<std::uint32_t> triangle_start;            ///< per point, into point_triangles; one more at the end
    std::vector<std::uint32_t> point_triangles;           ///< triangles at each point, ascending
    std::vector<std::uint32_t> neighbour_start;           ///< per point, into point_neighbours; one more at the end
    std::vector<std::uint32_t> point_neighbours;          ///< points joined by an edge, ascending
    std::vector<std::uint32_t> vertex_start;              ///< per point, into point_vertices; one more at the end
    std::vector<std::uint32_t> point_vertices;            ///< organ vertices at each point, ascending
    std::vector<std::uint32_t> component;                 ///< per point: the lowest point of its connected component
    bool connected = true;                                ///< all triangles belong to one component

    std::span<const std::uint32_t> triangles_at(std::uint32_t point) const {
        return std::span(point_triangles)
            .subspan(triangle_start[point], triangle_start[point + 1] - triangle_start[point]);
    }
    /// Vertices of the organ.
    std::span<const std::uint32_t> vertices_at(std::uint32_t point) const {
        return std::span(point_vertices).subspan(vertex_start[point], vertex_start[point + 1] - vertex_start[point]);
    }
    std::span<const std::uint32_t> neighbours_of(std::uint32_t point) const {
        return std::span(point_neighbours)
            .subspan(neighbour_start[point], neighbour_start[point + 1] - neighbour_start[point]);
    }

    /// The place nearest to `point`; among equally near places, the one on the lowest triangle. The surface must not be
    /// empty.
    SurfacePoint closest_point(const glm::dvec3& point) const;

    /// The nearest place to `point` on another component than `component_of_point`, if it is nearer than `within` mm.
    bool closest_on_other_component(const glm::dvec3& point, std::uint32_t component_of_point, double within,
                                    SurfacePoint& place) const;

    /// All points within `radius` mm of `centre` on any part of the surface, replacing the contents of `out`; each
    /// once, in an order that depends only on the surface. Points without a triangle are never found. Allocates only to
    /// grow `out`.
    void points_within(const glm::dvec3& centre, double radius, std::vector<std::uint32_t>& out) const;

    /// The first place that the ray hits, from either side; false when it misses. `direction` need not be
    /// unit length.
    bool intersect_ray(const glm::dvec3& origin, const glm::dvec3& direction, SurfacePoint& hit) const;

    /// Every point within `radius` mm of the straight path from `a` to `b`, ascending, of any component.
    std::vector<std::uint32_t> points_near(const glm::dvec3& a, const glm::dvec3& b, double radius) const;

    /// The triangle on the other side of the edge (p, q) of `triangle`; false at a boundary. If there are several (a
    /// non-manifold edge), the lowest.
    bool across(std::uint32_t triangle, std::uint32_t p, std::uint32_t q, std::uint32_t& other) const;

    double area(std::uint32_t triangle) const;  ///< mm2, at rest

    TriangleMesh mesh() const { return {positions, triangles}; }
    const TriangleTree& tree() const { return tree_; }
    std::size_t memory() const;  ///< bytes, without the tree

  private:
    void index_vertices();
    void build_adjacency();
    void find_components();

    TriangleTree tree_;
};

}  // namespace lapfx
