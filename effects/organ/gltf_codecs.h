// Compressed glTF: one row for each extension that packs bytes, with the function that unpacks them. A codec packs
// buffer views or whole primitives.
#pragma once

#include <string>
#include <string_view>

#include "organ/gltf_document.h"

namespace lapfx::organ {

struct GltfCodec {
    std::string_view extension;
    /// The bytes of a buffer view, of what the extension's object in it describes. Null: it packs no views.
    Bytes (*decode_view)(const GltfDocument& document, const tinygltf::Value& object,
                         const std::string& place) = nullptr;
    /// Gives the primitive accessors of what the object describes, in place of those that have no bytes. Null: it packs
    /// none.
    void (*decode_primitive)(GltfDocument& document, tinygltf::Primitive& primitive, const tinygltf::Value& object,
                             const std::string& place) = nullptr;
};

/// Null: there is none of that name.
const GltfCodec* find_codec(std::string_view extension);
}  // namespace lapfx::organ
