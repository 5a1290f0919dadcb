// Polygons as triangles.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace lapfx::organ {

/// Appends 3 * (ring - 2) corner numbers (0 to ring - 1) to `out`, wound as the ring is. Corners may be on an edge or
/// at the place of others (a ring that is cut open around a hole). If the ring does not cross itself, every triangle
/// has an area, except at corners that repeat the one before, and the angles are as even as the corners permit
/// (constrained Delaunay); four corners that all turn left are divided at the first. False when the ring crosses itself
/// or has too many corners to be cut carefully; its triangles may then overlap. Time grows at most with the square of
/// the corners; `looks` grows by the number of corners examined, at most 16 times their square.
bool triangulate(std::span<const glm::vec3> ring, std::vector<std::uint32_t>& out, std::size_t* looks = nullptr);

}  // namespace lapfx::organ
