// What is edited, and what is fitted to a video: a scene with a preset.
#pragma once

#include "lapfx/preset.h"
#include "lapfx/scene.h"

namespace lapfx::document {

struct Content {
    Scene scene;
    Preset preset;
};

}  // namespace lapfx::document
