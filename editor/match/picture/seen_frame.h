// What one frame shows by itself, without a baseline: tissue or not, and an order of haze.
//
//     const match::SeenFrame seen = match::look_at(image);
//     if (seen.in_view == match::InView::tissue) note(seen.haze);
//
// Pure, any thread.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

#include "lapfx/organ.h"
#include "match/picture/traps.h"

namespace lapfx::match {

/// Mats are at most 160 px on their longer side.
struct SeenFrame {
    InView in_view = InView::dark;
    cv::Mat code;       ///< CV_8UC3, BGR
    cv::Mat view;       ///< CV_8U, view_of
    cv::Mat texture;    ///< CV_8U, texture_of
    double haze = 0.0;  ///< the mean dark channel of the view, 0..1: it grows with haze and with the paleness of tissue
    double reddest = 0.0;  ///< reddest_tenth (traps.h)
};
SeenFrame look_at(const Image& image);

/// How alike the textures of two frames are within the first one's view, without moving either: 1 the same, 0 as two
/// pictures of other things.
double likeness(const SeenFrame& a, const SeenFrame& b);
/// Whether a cut lies between two frames that follow each other within `seconds`. Never beyond 0.2 s: there a camera
/// that moves looks the same.
bool is_cut(const SeenFrame& last, const SeenFrame& now, double seconds);
/// Whether the tissue of `a` is seen in `b`, also where the camera has moved a little.
bool shows_tissue_of(const SeenFrame& a, const SeenFrame& b);
/// Smoke may become so dense that no red is left, as before a bag: it is none while the tissue of an earlier frame is
/// still seen behind.
void tell_smoke_from_bag(const SeenFrame& earlier, SeenFrame& seen);

}  // namespace lapfx::match
