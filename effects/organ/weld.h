// Vertices at the same place are one point of the surface: texture seams, flat shading and STL split them.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace lapfx::organ {

struct Weld {
    std::vector<std::uint32_t> point;  ///< each vertex has its point here
    std::uint32_t points = 0;          ///< numbered in the order of their first vertex
    std::uint32_t sewn = 0;            ///< places that were joined to a different one
    double gap = 0.0;                  ///< greatest distance of one of them from the place it was joined to
};

/// Joins vertices whose coordinates are equal; -0 equals 0. Vertices with a NaN stay single.
Weld weld_positions(std::span<const glm::vec3> positions);

/// weld_positions(), and sews seams that rounding has torn: two open edges are joined when both their ends are within a
/// hundredth of the shortest edge there, or within the rounding of a float, and the surface continues across them.
/// Sheets on top of each other, closed bodies that touch, and other open edges that are close stay apart; no edge loses
/// its length. `indices`: three for each triangle, all in range. Time grows with the number of triangles.
Weld weld_surface(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

/// The first vertex of each point.
std::vector<std::uint32_t> first_vertices(const Weld& weld);

}  // namespace lapfx::organ
