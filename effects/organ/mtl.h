// The materials of an OBJ.
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
