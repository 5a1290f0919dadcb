// What a camera does by itself: exposure and white balance multiply each channel of the whole picture.
#pragma once

#include <opencv2/core.hpp>

namespace lapfx::match {

/// The factor by which most of the picture changed, of blue, green and red, within what a camera does (.67 to 1.5).
/// `baseline`, `frame`: linear light, CV_32FC3; `counts`: CV_32F, above 0 where to look. 1 where too little counts.
cv::Vec3f camera_gains(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& counts);

}  // namespace lapfx::match
