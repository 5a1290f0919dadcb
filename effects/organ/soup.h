// Polygons as listed in a file, before they become triangles of parts.
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

    std::vector<std::uint32_t> corners;    ///< position indices of all faces, one after the other; may be out of range
    std::vector<std::uint32_t> first{0};   ///< where each face starts in `corners`, and the end
    std::vector<glm::vec2> corner_uvs;     ///< empty or one per corner; v up
    std::vector<glm::vec4> face_colors;    ///< empty or one per face; linear; where positions have none
    std::vector<std::uint32_t> face_part;  ///< empty (one part) or the part of each face

    std::size_t unreadable_faces = 0;      ///< faces that are not in the list: corners are missing or not numbers
    std::size_t unreadable_triangles = 0;  ///< triangles that these faces would have made

    std::size_t faces() const { return first.size() - 1; }
    /// Counts a face of `length` corners that cannot all be read, or that are fewer than three.
    void add_unreadable(std::size_t length) {
        ++unreadable_faces;
        unreadable_triangles += length > 2 ? length - 2 : 1;
    }
};

/// From sRGB, 0..1, as in files and on screens, to linear.
glm::vec4 linear_color(const glm::vec4& srgb);

/// Triangulates the faces, splits the vertices where texture coordinates differ, and adds the parts and the warnings
/// about faces to `organ`. `parts` have the names and materials. Vertices without a face stay in the first part, so
/// that they are counted later.
void add_parts(const Soup& soup, std::vector<RawPart> parts, RawOrgan& organ);

}  // namespace lapfx::organ
