// A window on a scene: orbit, pan, zoom, cauterise, play. The editor's panels will stand around it.
#pragma once

#include "lapfx/preset.h"
#include "lapfx/scene.h"

namespace lapfx::window {

/// Opens the window and returns when it is closed. Throws Error: no_gl without a display or OpenGL 4.5, else as Preview.
void view(const Scene& scene, const Preset& preset, const std::vector<std::filesystem::path>& clip_folders);

}  // namespace lapfx::window
