// STL, binary and text.
//
// OpenMesh 9.0 is not used. Its reader of text takes the three lines after any "outer" for corners, even in the name of
// the solid, and reads words as 0; so a text had to be made binary for it, and numbers that are not finite replaced.
#pragma once

#include "organ/file.h"
#include "organ/raw.h"

namespace lapfx::organ {

/// Throws Error: truncated, or not an STL.
RawOrgan read_stl(const std::string& file, const Bytes& bytes);

}  // namespace lapfx::organ
