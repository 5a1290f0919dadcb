// Polygons as triangles.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace lapfx::organ {

/// Appends 3 * (ring - 2) corner numbers (0 to ring - 1) to `out`, wound as the ring is. A convex ring
/// becomes a fan, a concave one is cut by ears; one that is neither (it crosses itself, or has no plane)
/// becomes a fan all the same.
void triangulate(std::span<const glm::vec3> ring, std::vector<std::uint32_t>& out);

}  // namespace lapfx::organ
