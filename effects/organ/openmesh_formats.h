// STL and OFF, through OpenMesh.
#pragma once

#include "organ/file.h"
#include "organ/raw.h"

namespace lapfx::organ {

/// Binary or text. Throws Error: truncated, or neither.
RawOrgan read_stl(const std::string& file, const Bytes& bytes);

/// Text. Throws Error: truncated, malformed.
RawOrgan read_off(const std::string& file, const Bytes& bytes);

}  // namespace lapfx::organ
