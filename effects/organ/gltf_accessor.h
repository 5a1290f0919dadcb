// glTF accessors: typed arrays over buffer views, checked element by element range before a byte is read.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "organ/gltf_document.h"

namespace lapfx::organ {

/// The values of an accessor as floats: normalised integers become 0..1 or -1..1, others keep their value;
/// sparse substitutions are made.
struct FloatArray {
    int components = 0;  ///< per element
    std::vector<float> values;

    std::size_t size() const { return values.size() / static_cast<std::size_t>(components); }
};

/// Throws Error (bad_input) when a part of it is outside the file or its type is wrong here.
FloatArray read_floats(GltfDocument& document, int accessor, const std::string& place);

/// Unsigned integers of 8, 16 or 32 bits, one per element.
std::vector<std::uint32_t> read_indices(GltfDocument& document, int accessor, const std::string& place);

/// Number of elements of an accessor, without reading it. Throws Error when it is not in the file.
std::size_t accessor_count(const GltfDocument& document, int accessor, const std::string& place);

}  // namespace lapfx::organ
