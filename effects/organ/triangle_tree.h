// A tree of boxes over triangles that finds the nearest place, the first hit of a ray, and the triangles near a path.
// It keeps no triangles: every call takes those that it was built for, in the same or (after refit) a moved shape.
// Queries are const, allocate nothing but their result, and may run on any thread.
//
// Embree is not used: it works in floats, does not define which of equally near triangles it gives, and takes twice as
// long to build, nine times as long to refit and 1.7 times as long to find the nearest place. It finds a ray's hit
// seven times as fast, but only one ray per frame is needed. CGAL's tree cannot refit and is under the GPL.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <span>
#include <vector>

namespace lapfx {

/// A place on a surface.
struct SurfacePoint {
    std::uint32_t triangle = 0;
    glm::dvec3 weights{0.0};   ///< barycentric weights of the triangle's three points; sum 1
    glm::dvec3 position{0.0};  ///< mm
    double distance = 0.0;     ///< mm from the point or from the ray's origin
};

/// The triangles of a tree.
struct TriangleMesh {
    std::span<const glm::dvec3> positions;
    std::span<const std::array<std::uint32_t, 3>> triangles;
};

/// Excludes the triangles of one component.
struct ComponentFilter {
    std::span<const std::uint32_t> component_of;  ///< per point; empty: all triangles count
    std::uint32_t skipped = 0;
};

class TriangleTree {
  public:
    void build(TriangleMesh mesh);
    /// Updates the boxes after the points have moved. The tree itself stays, so queries become slower as the shape
    /// departs from the original.
    void refit(TriangleMesh mesh) noexcept;
    bool empty() const { return nodes_.empty(); }

    /// The place nearest to `point`, if it is nearer than `within`; among equally near places, the one on the lowest
    /// triangle.
    bool nearest(TriangleMesh mesh, const glm::dvec3& point, SurfacePoint& place,
                 double within = std::numeric_limits<double>::infinity(), ComponentFilter filter = {}) const;

    /// The first place that the ray hits, from either side. `direction` need not be of unit length.
    bool first_hit(TriangleMesh mesh, const glm::dvec3& origin, const glm::dvec3& direction, SurfacePoint& hit) const;

    /// Calls visit(triangle) for every triangle that comes within `radius` of the straight path from `a` to `b`, and
    /// for some that are a little farther away.
    template <class Visit>
    void near_path(const glm::dvec3& a, const glm::dvec3& b, double radius, Visit visit) const {
        if (nodes_.empty()) return;
        Stack stack;
        std::size_t size = 0;
        stack[size++] = 0;
        while (size > 0) {
            const std::uint32_t n = stack[--size];
            const Node& node = nodes_[n];
            if (!meets_path(node, a, b - a, radius)) continue;
            if (node.count == 0) {
                stack[size++] = node.first;
                stack[size++] = n + 1;
                continue;
            }
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i) visit(order_[i]);
        }
    }

  private:
    /// A box around a run of triangles, or around two boxes.
    struct Node {
        glm::vec3 low, high;
        std::uint32_t first = 0;  ///< leaf: into order_; else the second child (the first is the next node)
        std::uint32_t count = 0;  ///< leaf: triangles; else 0
    };
    /// Each level halves the triangles, so no tree of 2^32 triangles is deeper.
    using Stack = std::array<std::uint32_t, 64>;

    /// Whether the path meets the box grown by the radius: a little more than what is within the radius, never less.
    static bool meets_path(const Node& node, const glm::dvec3& a, const glm::dvec3& path, double radius);
    void fit(Node& node, std::uint32_t first, std::uint32_t count, TriangleMesh mesh) const noexcept;

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;  ///< triangles, by leaf
};

}  // namespace lapfx
