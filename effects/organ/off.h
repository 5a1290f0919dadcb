// OFF, through OpenMesh, which reads its many kinds of columns well.
#pragma once

#include "organ/file.h"
#include "organ/raw.h"

namespace lapfx::organ {

/// Text. Throws Error: truncated, malformed.
RawOrgan read_off(const std::string& file, const Bytes& bytes);

}  // namespace lapfx::organ
