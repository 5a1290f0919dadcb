// KHR_draco_mesh_compression: primitives that Draco decodes.
#pragma once

#include <string>

#include "organ/gltf_document.h"

namespace lapfx::organ {

/// Decodes what the extension object of a primitive describes, and gives the primitive accessors of it. What the
/// primitive has besides, as bytes that are not packed, stays. Throws Error when it is malformed, or is not what the
/// accessors say.
void decode_draco(GltfDocument& document, tinygltf::Primitive& primitive, const tinygltf::Value& object,
                  const std::string& place);

}  // namespace lapfx::organ
