// Polygons as triangles.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace lapfx::organ {

/// Appends 3 * (ring - 2) corner numbers (0 to ring - 1) to `out`, wound as the ring is. Corners may lie on an edge and
/// at the same place as others (a ring that is cut open to go round a hole): of a ring that does not cross itself every
/// triangle has an area, but for those at corners that repeat the one before them, and the angles are as even as the
/// corners allow (constrained Delaunay); four corners that all turn left are parted at the first. False when the ring
/// crosses itself, or has more corners than are cut with care: its triangles may overlap. However the corners lie, time
/// grows with their square; `looks` grows by how often one was looked at, at most 16 times their square.
bool triangulate(std::span<const glm::vec3> ring, std::vector<std::uint32_t>& out, std::size_t* looks = nullptr);

}  // namespace lapfx::organ
