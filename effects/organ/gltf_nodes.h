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
    int skin = -1;        ///< it decides where the mesh is, not `to_world`
    bool hidden = false;  ///< by KHR_node_visibility, of its node or of one above
};

/// Every mesh of the default scene with its place, in the order of the node tree; in a file without nodes,
/// all meshes. A cycle and an index that is not in the file throw Error.
std::vector<MeshInstance> mesh_instances(const GltfDocument& document);

/// The place of every node of the file, in any scene. A node that is its own ancestor throws Error.
std::vector<glm::dmat4> node_places(const GltfDocument& document);

}  // namespace lapfx::organ
