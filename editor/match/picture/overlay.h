// Burnt-in text and logos of a video: what keeps its value while the picture around it changes.
#pragma once

#include <opencv2/core.hpp>

#include "lapfx/organ.h"

namespace lapfx::match {

/// Sees frames from all over a video. Text that changes, such as a clock, is found as far as it stays.
class OverlaySurvey {
  public:
    /// Frames of one shape and size.
    void add(const Image& frame);
    /// CV_8U of `size`, 255 where there is text or a logo. Nothing before four frames were seen, where the whole
    /// picture stands still, and in pictures of less than 160 px.
    cv::Mat found(cv::Size size) const;

  private:
    cv::Mat least_, most_;  ///< BGR code values of each pixel, at up to 1280 px: strokes are thin
    cv::Mat edges_;         ///< CV_8U, the least contrast of each pixel to those next to it, of all frames
    int frames_ = 0;
};

}  // namespace lapfx::match
