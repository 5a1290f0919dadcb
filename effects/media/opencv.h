// Pictures of the core as OpenCV takes them.
#pragma once

#include <opencv2/imgproc.hpp>

#include "lapfx/organ.h"

namespace lapfx::media {

/// The pixels themselves, RGBA; not to be changed.
inline cv::Mat4b pixels_of(const Image& image) {
    return {image.height, image.width,
            reinterpret_cast<cv::Vec4b*>(const_cast<std::uint8_t*>(image.pixels.data()))};  // OpenCV has no const view
}

inline cv::Mat1b grey_of(const Image& image) {
    cv::Mat1b grey;
    cv::cvtColor(pixels_of(image), grey, cv::COLOR_RGBA2GRAY);
    return grey;
}

}  // namespace lapfx::media
