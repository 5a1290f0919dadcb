// PLY, text and binary of either byte order.
//
// Not through OpenMesh 9.0: its PLY reader loses its place at list properties that it does not know, takes no
// coordinates in integers and no lines that end in CR, and reserves memory for any count that the header
// claims. Of the well-formed PLY files that our tests walk over it reads less than half. Assimp's hangs on 19 of the
// 92 files that we test with, where a word in the header is wrong; Draco's reads no big-endian numbers.
#pragma once

#include "organ/file.h"
#include "organ/raw.h"

namespace lapfx::organ {

/// x y z, nx ny nz, texture coordinates (s t, u v, texture_u texture_v), colours (red green blue alpha) and
/// the faces' vertex lists; all else is skipped. Throws Error: malformed header, truncated, malformed number.
RawOrgan read_ply(const std::string& file, const Bytes& bytes);

}  // namespace lapfx::organ
