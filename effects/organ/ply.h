// PLY, text and binary of either byte order.
//
// Not through OpenMesh: its PLY reader takes coordinates in double (which many programs write) for 0, loses
// its place at list properties that it does not know, and believes any count in the header.
#pragma once

#include "organ/file.h"
#include "organ/raw.h"

namespace lapfx::mesh {

/// x y z, nx ny nz, texture coordinates (s t, u v, texture_u texture_v), colours (red green blue alpha) and
/// the faces' vertex lists; all else is skipped. Throws Error: malformed header, truncated, malformed number.
RawOrgan read_ply(const std::string& file, const Bytes& bytes);

}  // namespace lapfx::mesh
