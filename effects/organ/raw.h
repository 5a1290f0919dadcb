// What a reader found in a file, before it is mended and completed: the common form of all mesh formats.
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

/// More than this is refused: such a file is no organ, and would take the machine down with it.
constexpr std::size_t maximum_triangles = 20'000'000;
constexpr std::uintmax_t maximum_file_size = std::uintmax_t{2} << 30;

/// Triangles with one material. Every attribute but the positions may be empty: the file had none. Indices
/// may be out of range, coordinates may be NaN: mend() deals with both.
struct RawPart {
    std::string name;
    int material = -1;                 ///< index into RawOrgan::materials, or -1: the file names none
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
    std::vector<Encoded> encoded;  ///< by image: the file that it was decoded from
    std::vector<std::string> warnings;
    std::vector<std::filesystem::path> files;  ///< besides the one that was asked for: read, and what they should be
    std::vector<std::filesystem::path> unread_files;
    std::string holds;             ///< what the file holds in place of triangles, as far as the reader knows
    std::size_t unreadable = 0;    ///< triangles of the file that are in no part: a corner is missing, or no number
    std::size_t without_area = 0;  ///< the same, because two corners are one
};

/// Applies an affine map; a mirroring one also turns the triangles round, so that they still face outwards.
void transform(RawPart& part, const glm::dmat4& matrix);
/// The same for an organ whose triangles need not be turned.
void transform(Organ& organ, const glm::dmat4& matrix);

/// "1 vertex", "12 vertices".
std::string counted(std::size_t count, const char* one, const char* many);

/// The error of every reader: the file has to change.
[[noreturn]] inline void refuse(const std::string& file, const std::string& place, const std::string& reason) {
    throw Error(Failure::bad_input, Fault{file, place, reason});
}

}  // namespace lapfx::organ
