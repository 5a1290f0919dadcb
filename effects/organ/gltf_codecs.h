// Compressed glTF: one row for each extension that packs bytes, with the function that unpacks them. A codec packs
// buffer views or whole primitives.
#pragma once

#include <string>
#include <string_view>

#include "organ/gltf_document.h"

namespace lapfx::organ {

struct GltfCodec {
    std::string_view extension;
    /// Unpacks the bytes of a buffer view that the extension's object describes. Null: the codec does not pack views.
    Bytes (*decode_view)(const GltfDocument& document, const tinygltf::Value& object,
                         const std::string& place) = nullptr;
    /// Gives the primitive accessors for what the object describes, instead of those without bytes. Null: the codec
    /// does not pack primitives.
    void (*decode_primitive)(GltfDocument& document, tinygltf::Primitive& primitive, const tinygltf::Value& object,
                             const std::string& place) = nullptr;
};

/// Null: there is no codec of that name.
const GltfCodec* find_codec(std::string_view extension);
}  // namespace lapfx::organ
