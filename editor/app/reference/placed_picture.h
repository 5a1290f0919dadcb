// The reference moved, scaled and turned under the preview, as the scene says, so that the same tissue lies at the same
// place in both. Lengths are heights of the picture, y downwards, in the aspect that it is shown in.
#pragma once

#include <optional>

#include "lapfx/organ.h"
#include "lapfx/scene.h"

namespace lapfx::app {

/// Where a place of the reference is shown.
glm::dvec2 placed(const ReferencePlacement& placement, double aspect, glm::dvec2 place);

/// The whole picture, as many pixels; where the reference has none it is black and clear, so that what it lies over
/// is seen there.
Image placed(const Image& image, const ReferencePlacement& placement, double aspect);

/// With which the round view of an endoscope in the picture lies where the preview's vignette has its own; it keeps
/// the rotation. None: the picture has no round view. `image` is in the aspect that it is shown in.
std::optional<ReferencePlacement> on_the_vignette(const Image& image, const ReferencePlacement& now);

}  // namespace lapfx::app
