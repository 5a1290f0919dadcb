// The materials of an OBJ.
//
// Not through tinyobjloader 2.0: what takes room here is looking for textures and judging them, which it leaves to its
// caller; of the text it takes the first word of a name after "-s 1 1" for a number, a comment for a part of a name,
// and Kd 1e999 as infinite.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "organ/raw.h"

namespace lapfx::organ {

/// Appends the materials of the libraries, and their textures, to `organ`; each file is read once, however often and
/// under whichever names it is asked for. A library or texture that is missing or broken is a warning: an OBJ is often
/// passed on without them.
void read_mtl(const std::vector<std::string>& libraries, const std::filesystem::path& folder, RawOrgan& organ);

}  // namespace lapfx::organ
