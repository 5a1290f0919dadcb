// The reference placed (lapfx/authoring/placed_picture.h) by what is seen in it.
#pragma once

#include <optional>

#include "lapfx/authoring/placed_picture.h"

namespace lapfx::app {

/// With which the round view of an endoscope in the picture lies where the preview's vignette has its own; it keeps
/// the rotation. None: the picture has no round view. `image` is in the aspect that it is shown in.
std::optional<ReferencePlacement> on_the_vignette(const Image& image, const ReferencePlacement& now);

}  // namespace lapfx::app
