// Where the round picture of an endoscope lies in a frame, to parts of a pixel: what disc_of() finds of the view's mask
// is softened and drawn in on purpose, and is not good enough to lay two pictures on one another.
//
//     if (const auto disc = match::round_view(frame)) lay(disc->center, disc->radius);
//
// Pure, any thread, no OpenGL.
#pragma once

#include <opencv2/core.hpp>
#include <optional>

#include "match/look.h"

namespace lapfx::match {

/// `code`: CV_8UC3 BGR, in the aspect that it is shown in. The radius is where brightness is half of that inside. None:
/// the view fills the frame, or its edge is no circle.
std::optional<Disc> round_view(const cv::Mat& code);

}  // namespace lapfx::match
