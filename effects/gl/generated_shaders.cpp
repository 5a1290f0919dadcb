#include "gl/generated_shaders.h"

#include "lapfx/view.h"

namespace lapfx::gl {

std::optional<std::string> generated_text(const std::string& name) {
    if (name != "overlays.glsl") return std::nullopt;
    std::string text;
    for (const OverlayRow& row : overlays) {
        text += "const int OVERLAY_";
        for (const char c : row.key) text += static_cast<char>(c - 'a' + 'A');
        text += " = " + std::to_string(static_cast<int>(row.overlay)) + ";\n";
    }
    return text;
}

}  // namespace lapfx::gl
