// The round view of an endoscope as a sign of how a video is meant to be shown: videos are often stored squeezed
// without saying so, and then it is an ellipse. Pure, any thread.
#pragma once

#include <optional>

#include "lapfx/organ.h"

namespace lapfx {

/// Width over height at which the round view in this picture is round; that of the picture where it is not squeezed.
/// None: it has no round view, or shows too little of its rim.
std::optional<double> aspect_of_round_view(const Image& picture);

}  // namespace lapfx
