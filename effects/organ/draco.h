// KHR_draco_mesh_compression: primitives that Draco decodes.
#pragma once

#include <string>

#include "organ/gltf_document.h"

namespace lapfx::organ {

/// Decodes what the extension object of a primitive describes, and gives the primitive accessors for it. Other
/// attributes of the primitive, which are not compressed, stay. Throws Error when the data is malformed or contradicts
/// the accessors.
void decode_draco(GltfDocument& document, tinygltf::Primitive& primitive, const tinygltf::Value& object,
                  const std::string& place);

}  // namespace lapfx::organ
