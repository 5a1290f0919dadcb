// Vertices at the same place are one point of the surface: texture seams, flat shading and STL split them.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace lapfx::organ {

struct Weld {
    std::vector<std::uint32_t> point;  ///< of each vertex
    std::uint32_t points = 0;          ///< numbered in the order of their first vertex
    std::uint32_t sewn = 0;            ///< places that differ and were joined to another one all the same
    double gap = 0.0;                  ///< the farthest that one of them lay from the place it was joined to
};

/// Joins vertices whose coordinates are equal; -0 equals 0. Vertices with a NaN stay single.
Weld weld_positions(std::span<const glm::vec3> positions);

/// weld_positions(), and seams that rounding has torn are sewn: two open edges are joined when both their ends lie
/// within a hundredth of the shortest edge there, or within the rounding of a float, and the surface goes on across
/// them. Sheets that lie on one another, closed bodies that touch, and open edges that come near in any other way stay
/// apart; no edge loses its length. `indices`: three of each triangle, all in range. Time grows with the number of
/// triangles.
Weld weld_surface(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

/// The first vertex of each point.
std::vector<std::uint32_t> first_vertices(const Weld& weld);

}  // namespace lapfx::organ
