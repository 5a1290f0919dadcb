// Where the round picture of an endoscope lies in a frame, to parts of a pixel: what disc_of() finds of the view's mask
// is softened and drawn in on purpose, and is not good enough to lay two pictures on one another.
//
//     if (const auto disc = match::round_view(frame)) lay(disc->center, disc->radius);
//
// Pure, any thread, no OpenGL.
#pragma once

#include <glm/glm.hpp>
#include <opencv2/core.hpp>
#include <optional>

namespace lapfx::match {

/// The round picture of an endoscope in a frame, px from its upper left corner.
struct Disc {
    glm::dvec2 center{0.0};
    double radius = 0.0;
};
/// From the mask of the view (view.h), CV_8U; none: it fills the frame, or its edge is no circle, as between
/// bars.
std::optional<Disc> disc_of(const cv::Mat& view);

/// `code`: CV_8UC3 BGR, in the aspect that it is shown in. The radius is where brightness is half of that inside. None:
/// the view fills the frame, or its edge is no circle.
std::optional<Disc> round_view(const cv::Mat& code);

}  // namespace lapfx::match
