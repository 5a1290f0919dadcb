// Travel distance over a surface by fast marching (R. Kimmel, J. Sethian, "Computing geodesic paths on
// manifolds", PNAS 1998), with the update that is exact for a point source on a plane: the source is unfolded
// into the triangle's plane (M. Novotni, R. Klein, "Computing geodesic distances on triangular meshes", WSCG
// 2002). Distances follow the surface, not the edges, so they hardly depend on how finely it is cut into
// triangles.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "organ/surface.h"

namespace lapfx::bleeding {

struct Reached {
    std::uint32_t vertex;  ///< of the surface
    double distance;       ///< mm from the contact point
};

/// Every surface vertex within `limit` mm of `contact`, nearest first. The contact is moved to the closest
/// point of the surface, inside a triangle, not to a vertex. Other components are not reached. Pure; any
/// thread.
std::vector<Reached> march(const Surface& surface, glm::dvec3 contact, double limit);

}  // namespace lapfx::bleeding
