// EXT_meshopt_compression: buffer views that meshoptimizer decodes.
#pragma once

#include <span>
#include <string>

#include "organ/gltf_document.h"

namespace lapfx::organ {

/// `length` bytes at `offset` of a buffer. Throws Error when they are not there.
std::span<const std::uint8_t> bytes_of(const GltfDocument& document, int buffer, std::size_t offset, std::size_t length,
                                       const std::string& place);

/// Decodes what the extension object of a buffer view describes. Throws Error when it is malformed.
Bytes decode_meshopt(const GltfDocument& document, const tinygltf::Value& extension, const std::string& place);

}  // namespace lapfx::organ
