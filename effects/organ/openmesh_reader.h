// OpenMesh's file readers, filling a list of polygons instead of a half-edge mesh, which refuses or doubles parts that
// are not manifold, as real organs often have.
#pragma once

#include <string>

#include "organ/soup.h"

namespace lapfx::organ {

enum class OpenMeshFormat { off, stl_binary };

/// Reads `text`, which was checked for what the reader cannot handle. False when the reader fails. OpenMesh keeps state
/// in its readers, so one thread at a time enters.
bool read_with_openmesh(OpenMeshFormat format, const std::string& text, Soup& soup);

}  // namespace lapfx::organ
