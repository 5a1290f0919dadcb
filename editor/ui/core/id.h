// Who a widget is from one frame to the next: a hash of where it stands and what it is called.
#pragma once

#include <cstdint>
#include <string_view>

namespace lapfx::ui {

using Id = std::uint64_t;  ///< 0: none

/// 64 well mixed bits of `bytes` under `seed`, never 0; not for keeping: it may change from version to version.
std::uint64_t hash_bytes(std::uint64_t seed, std::string_view bytes);

/// A label as it is written in code. "Speed##left" shows Speed and is told from another Speed by the rest; "12
/// clips###clips" shows what comes first and is, whatever that says, always the same widget.
struct Label {
    std::string_view shown;  ///< may be empty
    std::string_view key;    ///< what is hashed
    std::string_view name;   ///< what it is called in the semantic tree: `shown`, or the hidden part
};
Label split_label(std::string_view text);

}  // namespace lapfx::ui
