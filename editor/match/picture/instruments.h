// Instruments in a clear picture, by their colour: no metal, ceramic or blue plastic is as red as tissue.
#pragma once

#include <opencv2/core.hpp>

namespace lapfx::match {

/// Instruments and burnt-in text of a clear picture, CV_8U 255: grey, white or blue parts of some size within `view`
/// (CV_8U 255), and the sides of shafts, which mirror the tissue. `code`: CV_8UC3 BGR. Dense smoke is as grey: of no
/// use for a frame that is not clear.
cv::Mat instruments_of(const cv::Mat& code, const cv::Mat& view);

}  // namespace lapfx::match
