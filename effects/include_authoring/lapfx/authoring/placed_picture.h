// A picture of the reference moved, scaled and turned as the scene says (ReferencePlacement), so that the same tissue
// lies at the same place as in the preview. Lengths are heights of the picture, y downwards, in the aspect that it is
// shown in. Pure functions, any thread.
#pragma once

#include "lapfx/organ.h"
#include "lapfx/scene.h"

namespace lapfx {

/// Where a place of the reference is shown.
glm::dvec2 placed(const ReferencePlacement& placement, double aspect, glm::dvec2 place);

/// The whole picture, as many pixels; where the reference has none it is black and clear, so that what it lies over
/// is seen there.
Image placed(const Image& image, const ReferencePlacement& placement, double aspect);

}  // namespace lapfx
