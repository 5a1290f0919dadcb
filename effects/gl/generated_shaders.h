// Shader text made from the core's tables, so that C++ and GLSL use the same list of names. Included like the files of
// shaders/: #include "overlays.glsl".
#pragma once

#include <optional>
#include <string>

namespace lapfx::gl {

/// None: no such text. overlays.glsl: `const int OVERLAY_VESSELS = 1;` and so on, from lapfx/view.h.
std::optional<std::string> generated_text(const std::string& name);

}  // namespace lapfx::gl
