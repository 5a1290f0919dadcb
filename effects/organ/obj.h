// Wavefront OBJ: OpenMesh reads the numbers, we read what it does not tell (groups, materials) and keep it
// from harm.
#pragma once

#include "organ/file.h"
#include "organ/raw.h"

namespace lapfx::organ {

/// One part for each run of a material. Throws Error when the file is no text or cannot be read; lines that
/// make no sense are left out with a warning.
RawOrgan read_obj(const std::filesystem::path& path, const std::string& file, const Bytes& bytes);

}  // namespace lapfx::organ
