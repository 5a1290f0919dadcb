// glTF 2.0, .glb and .gltf.
#pragma once

#include "organ/file.h"
#include "organ/raw.h"

namespace lapfx::organ {

/// The meshes of the default scene (without one: the first scene; without any: all root nodes), moved by
/// their nodes, in the file's unit. Throws Error (bad_input) with the JSON pointer of what is wrong.
RawOrgan read_gltf(const std::filesystem::path& path, const std::string& file, const Bytes& bytes);

}  // namespace lapfx::organ
