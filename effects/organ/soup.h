// Polygons as a file lists them, before they become triangles of parts.
#pragma once

#include <limits>

#include "organ/raw.h"

namespace lapfx::organ {

/// Corners without texture coordinates have this u.
constexpr float no_uv = std::numeric_limits<float>::quiet_NaN();

struct Soup {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  ///< empty or one per position; zero = missing
    std::vector<glm::vec4> colors;   ///< empty or one per position; linear
    std::vector<glm::vec2> uvs;      ///< empty or one per position; v up, as these formats have it

    std::vector<std::uint32_t> corners;    ///< positions of all faces, one after the other; may be out of range
    std::vector<std::uint32_t> first{0};   ///< where each face starts in `corners`, and the end
    std::vector<glm::vec2> corner_uvs;     ///< empty or one per corner; v up
    std::vector<std::uint32_t> face_part;  ///< empty (one part) or the part of each face

    std::size_t faces() const { return first.size() - 1; }
};

/// 0..1 as files and screens have it, to linear.
glm::vec4 linear_color(const glm::vec4& srgb);

/// Triangulates the faces and splits the vertices where texture coordinates differ. `names` and `materials`
/// are those of the parts. Vertices that no face uses stay in the first part, so that they are counted later.
std::vector<RawPart> parts_of(const Soup& soup, std::vector<RawPart> parts);

}  // namespace lapfx::organ
