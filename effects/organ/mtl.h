// The materials of an OBJ.
//
// tinyobjloader 2.0 is not used: most code here finds and checks textures, which it leaves to its caller. In the text,
// it takes the first word of a name after "-s 1 1" for a number, a comment for a part of a name, and Kd 1e999 as
// infinite.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "organ/raw.h"

namespace lapfx::organ {

/// Appends the materials of the libraries, and their textures, to `organ`; each file is read once, however often and
/// under whatever names it is asked for. A library or texture that is missing or broken is a warning: an OBJ is often
/// passed on without them.
void read_mtl(const std::vector<std::string>& libraries, const std::filesystem::path& folder, RawOrgan& organ);

}  // namespace lapfx::organ
