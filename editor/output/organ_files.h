// The files that an organ consists of: the mesh, and what it names beside itself.
#pragma once

#include <filesystem>
#include <vector>

namespace lapfx::output {

/// Relative to the organ's folder, the organ first. glTF: buffers and images; OBJ: material libraries and their textures. Only what is
/// there and inside of the folder, as it is loaded. Throws Error (bad_input) when the organ cannot be read.
std::vector<std::filesystem::path> organ_files(const std::filesystem::path& organ);

}  // namespace lapfx::output
