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
};

/// Joins vertices whose coordinates are equal; -0 equals 0. Vertices with a NaN stay single.
Weld weld_positions(std::span<const glm::vec3> positions);

}  // namespace lapfx::organ
