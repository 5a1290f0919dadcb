// The pages of `lapfx gallery` by name: the product does not link the pages themselves (tests/gallery), which are
// compared with this list when they are compiled.
#pragma once

#include <array>
#include <string_view>

namespace lapfx::commands {

inline constexpr std::array<std::string_view, 14> gallery_pages = {
    "Overview", "Basic", "Fields",   "Params", "Lists", "Panels", "Pictures",
    "Graphs",   "Shell", "Overlays", "Layout", "Text",  "Icons",  "Colours"};

}  // namespace lapfx::commands
