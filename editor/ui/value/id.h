// The id of a widget from frame to frame: a hash of its place in the tree and its label.
#pragma once

#include <cstdint>
#include <string_view>

namespace lapfx::ui {

using Id = std::uint64_t;  ///< 0: none

/// A 64-bit hash, never 0. Do not store it in files: it may change from version to version.
std::uint64_t hash_bytes(std::uint64_t seed, std::string_view bytes);

/// A label as it is written in code. "Speed##left" shows "Speed"; what follows ## tells it from another "Speed". "12
/// clips###clips" shows "12 clips" and stays the same widget when the number changes.
struct Label {
    std::string_view shown;  ///< may be empty
    std::string_view key;    ///< what is hashed
    std::string_view name;   ///< what it is called in the semantic tree: `shown`, or the hidden part
};
Label split_label(std::string_view text);

}  // namespace lapfx::ui
