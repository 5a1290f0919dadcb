// Which meshes a glTF shows, and where.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "organ/gltf_document.h"
#include "organ/raw.h"

namespace lapfx::organ {

struct MeshInstance {
    int mesh = -1;
    std::string node;  ///< its name
    glm::dmat4 to_world{1.0};
};

/// Every mesh of the default scene with its place, in the order of the node tree; in a file without nodes,
/// all meshes. A cycle and an index that is not in the file throw Error.
std::vector<MeshInstance> mesh_instances(const GltfDocument& document);

}  // namespace lapfx::organ
