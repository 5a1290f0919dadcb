// OpenMesh's file readers, over a list of polygons instead of a half-edge mesh: that one refuses or doubles
// what is not manifold, and real organs often are not.
#pragma once

#include <string>

#include "organ/soup.h"

namespace lapfx::organ {

enum class OpenMeshFormat { off, stl_binary };

/// Reads `text` (already checked for what the reader cannot stand). False when it gives up. OpenMesh keeps
/// state in its readers: one thread at a time is let in.
bool read_with_openmesh(OpenMeshFormat format, const std::string& text, Soup& soup);

}  // namespace lapfx::organ
