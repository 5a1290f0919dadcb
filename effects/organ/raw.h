// The contents of a file before mending and completing: the common form of all mesh formats.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "lapfx/error.h"
#include "lapfx/organ.h"
#include "organ/pixels.h"

namespace lapfx::organ {

/// A file with more than this is refused: it is not an organ, and could exhaust the machine.
constexpr std::size_t maximum_triangles = 20'000'000;
constexpr std::uintmax_t maximum_file_size = std::uintmax_t{2} << 30;

/// Triangles with one material. Every attribute but the positions may be empty: the file had none. Indices
/// may be out of range, coordinates may be NaN: mend() deals with both.
struct RawPart {
    std::string name;
    int material = -1;                 ///< index into RawOrgan::materials, or -1 if the file names none
    std::vector<glm::vec3> positions;  ///< units of the file
    std::vector<glm::vec3> normals;    ///< of any length; zero = missing
    std::vector<glm::vec4> tangents;   ///< w = 0: missing
    std::vector<glm::vec2> uvs;
    std::vector<glm::vec4> colors;  ///< linear
    std::vector<std::uint32_t> indices;
};

struct RawOrgan {
    std::vector<RawPart> parts;
    std::vector<Material> materials;
    std::vector<Image> images;
    std::vector<Encoded> encoded;  ///< each image has the file that it was decoded from
    std::vector<std::string> warnings;
    std::vector<std::filesystem::path> files;  ///< further files that were read successfully
    std::vector<std::filesystem::path> unread_files;
    std::string holds;             ///< what the file has instead of triangles, if the reader knows
    std::size_t unreadable = 0;    ///< triangles of the file that are in no part: a corner is missing or not a number
    std::size_t without_area = 0;  ///< likewise, because two corners are equal
};

/// An affine map of points and of what lies on a surface.
class AffineMap {
  public:
    explicit AffineMap(const glm::dmat4& matrix);
    glm::vec3 point(const glm::vec3& p) const { return glm::vec3(glm::dvec3(matrix_ * glm::dvec4(p, 1.0))); }
    glm::vec3 normal(const glm::vec3& n) const;
    glm::vec4 tangent(const glm::vec4& t) const;
    bool mirrors() const { return side_ < 0.0; }

  private:
    glm::dmat4 matrix_;
    glm::dmat3 linear_, cofactors_;
    double side_;
};

/// Applies an affine map; if it mirrors, the triangles are reversed, so that they still face outwards.
void transform(RawPart& part, const glm::dmat4& matrix);
/// The same for an organ whose triangles need not be reversed.
void transform(Organ& organ, const glm::dmat4& matrix);

/// The index of a copy of an image; -1 of -1.
int copy_image(RawOrgan& organ, int image);

/// "1 vertex", "12 vertices".
std::string counted(std::size_t count, const char* one, const char* many);

/// The error of every reader: something is wrong with the file.
[[noreturn]] inline void refuse(const std::string& file, const std::string& place, const std::string& reason) {
    throw Error(Failure::bad_input, Fault{file, place, reason});
}

}  // namespace lapfx::organ
