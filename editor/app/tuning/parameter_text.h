// Parameters as text on the clipboard, for another editor, a preset file or a person.
//
//     const std::string text = app::copy_parameters(preset, {"bleeding"});      // {"bleeding": {"speed": 4, ...}}
//     preset = app::paste_parameters(preset, text);                             // throws Error: every fault
//
// Text is laid over the preset: keys that are not in it stay. A whole preset is text like any other.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "lapfx/parameter.h"

namespace lapfx {
struct Preset;
}

namespace lapfx::app {

/// JSON, two-space indent: the groups ("smoke.keying") in their places. Empty `groups`: all, with clips, name and
/// description.
std::string copy_parameters(const Preset& preset, std::span<const std::string_view> groups);

/// A copy of `preset` with the values in `text`. With `group`, only that group is taken; it must be in the text. Throws
/// Error (bad_input, file "clipboard"): no JSON, unknown keys, values that are not allowed, rules that would not hold;
/// `preset` is not touched.
Preset paste_parameters(const Preset& preset, std::string_view text, std::string_view group = {});

/// What 0 means where it is no number: "automatic"; else empty.
std::string_view meaning_of_zero(const Parameter& row);

}  // namespace lapfx::app
