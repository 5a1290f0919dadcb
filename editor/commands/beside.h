// lapfx render --beside: the surgery video beside each picture, and below them the curves of both.
#pragma once

#include <memory>
#include <string>

#include "commands/shown_scene.h"
#include "lapfx/prepared_organ.h"
#include "output/frame_page.h"

namespace lapfx::commands {

/// Opens the video `file` and measures scene and video, which is told while it lasts. Where the video is the scene's
/// own reference, it lies and is measured as the scene says; else it begins with the scene. `scene`: the scene's file;
/// `frame`: px of the preview's pictures. Throws Error that names the file. A context must be current, and stay so.
std::unique_ptr<output::FramePage> beside_page(const ShownScene& shown, const std::string& scene,
                                               const std::string& file, glm::ivec2 frame,
                                               std::shared_ptr<const PreparedOrgan> organ);

}  // namespace lapfx::commands
