// Writes a model as binary glTF: mm in, metres out, textures embedded as JPEG. The same input gives the same
// bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "patch.h"

namespace organs {

struct Surface {
    std::string name;
    Mesh mesh;
    dvec3 color{1.0};  ///< linear, times the texture
    double roughness = 0.4;
    double metallic = 0.0;
    double normal_scale = 1.0;
    bool double_sided = false;
    std::vector<std::uint8_t> color_jpeg;  ///< empty: no texture
    std::vector<std::uint8_t> normal_jpeg;
};

/// Throws std::runtime_error when the file cannot be written, or does not load again.
void write_glb(const std::filesystem::path& path, const std::string& name, const std::vector<Surface>& surfaces);

}  // namespace organs
