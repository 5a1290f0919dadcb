// A closed titanium clip: two jaws side by side, joined by a bend at one end, as a swept profile. mm; x along it, y
// away from the tissue, which is at y = 0. Pure.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace lapfx::render {

struct ClipMesh {
    std::vector<glm::vec3> positions, normals;
    std::vector<std::uint32_t> indices;  ///< triangles, counter-clockwise from outside
};

/// `length`: mm, from bend to tips.
ClipMesh clip_mesh(double length);

}  // namespace lapfx::render
