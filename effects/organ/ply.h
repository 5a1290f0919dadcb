// PLY, text and binary of either byte order.
//
// OpenMesh 9.0 is not used. Its PLY reader loses its position at unknown list properties, accepts neither integer
// coordinates nor lines that end in CR, and reserves memory for any count that the header claims; it reads less than
// half of the well-formed PLY files of our tests. The reader of Assimp hangs on 19 of the 92 test files, in which a
// word of the header is wrong. That of Draco does not read big-endian numbers.
#pragma once

#include "organ/file.h"
#include "organ/raw.h"

namespace lapfx::organ {

/// x y z, nx ny nz, texture coordinates (s t, u v, texture_u texture_v), colours (red green blue alpha), the faces'
/// vertex lists, texture coordinates, colours and numbers of textures, and the textures that comments name; everything
/// else is skipped. Throws Error: malformed header, truncated, malformed number.
RawOrgan read_ply(const std::filesystem::path& path, const std::string& file, const Bytes& bytes);

}  // namespace lapfx::organ
