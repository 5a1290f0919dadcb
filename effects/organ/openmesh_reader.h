// OpenMesh's reader of OFF, filling a list of polygons instead of a half-edge mesh, which refuses or doubles parts that
// are not manifold, as real organs often have.
#pragma once

#include <string>

#include "organ/soup.h"

namespace lapfx::organ {

/// Reads `text`, which was checked for what the reader cannot handle. False when the reader fails. OpenMesh keeps state
/// in its reader, so one thread at a time enters.
bool read_off_with_openmesh(const std::string& text, Soup& soup);

}  // namespace lapfx::organ
