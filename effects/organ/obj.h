// Wavefront OBJ with its material libraries.
#pragma once

#include "organ/file.h"
#include "organ/raw.h"

namespace lapfx::organ {

/// One part for each material of each object. Throws Error when the file is not text; lines that make no sense are left
/// out with a warning.
RawOrgan read_obj(const std::filesystem::path& path, const std::string& file, const Bytes& bytes);

}  // namespace lapfx::organ
