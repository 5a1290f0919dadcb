// What a camera does by itself: exposure and white balance multiply each channel of the whole picture.
#pragma once

#include <opencv2/core.hpp>

namespace lapfx::match {

/// The factor by which most of the picture changed, of blue, green and red, within what a camera does (.45 to 2.2).
/// `baseline`, `frame`: linear light, CV_32FC3; `part`: CV_8U, 255 where to look. 1 where that is too little.
cv::Vec3f camera_gains(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& part);

}  // namespace lapfx::match
