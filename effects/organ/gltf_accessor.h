// glTF accessors: typed arrays over buffer views, checked element by element range before a byte is read.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "organ/gltf_document.h"
#include "organ/raw.h"

namespace lapfx::organ {

/// Elements of an accessor that a file may have.
constexpr std::size_t most_elements = 3 * maximum_triangles;
/// The same for one without a buffer view, which takes no bytes in the file, however many zeros it stands for.
constexpr std::size_t most_elements_without_view = 4'000'000;

/// The values of an accessor as floats: normalised integers become 0..1 or -1..1, others keep their value;
/// sparse substitutions are made.
struct FloatArray {
    int components = 0;  ///< per element
    std::vector<float> values;

    std::size_t size() const { return values.size() / static_cast<std::size_t>(components); }
};

/// What an accessor must be where it is used.
struct Expected {
    int components_low = 1, components_high = 4;  ///< of each element
    std::size_t least = 0, most = 0;              ///< elements
};

/// Throws Error (bad_input) when it is not as expected, or when a part of it is outside the file. Nothing is read or
/// allocated before that is known.
FloatArray read_floats(GltfDocument& document, int accessor, const Expected& expected, const std::string& place);

/// Unsigned integers of 8, 16 or 32 bits, one per element.
std::vector<std::uint32_t> read_indices(GltfDocument& document, int accessor, const std::string& place);

}  // namespace lapfx::organ
