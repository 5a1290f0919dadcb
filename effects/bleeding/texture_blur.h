// Gaussians over a texture, of any standard deviation in texels, computed with OpenCV.
#pragma once

#include <glm/glm.hpp>
#include <opencv2/core.hpp>

#include "bleeding/texture_layout.h"

namespace lapfx::bleeding {

/// Means of values where the weights are above 0.
class TextureBlur {
  public:
    /// `weights`: CV_32F, 0..1. `deviation`: along x and y; less than 0.3 texels counts as 0.3.
    TextureBlur(const cv::Mat& weights, glm::dvec2 deviation, const Beyond& beyond);

    /// `weighted`: values times their weights, CV_32F, finite, the size of the weights. Far from all weight the result
    /// is near 0.
    cv::Mat operator()(const cv::Mat& weighted) const;

  private:
    /// One axis: its reduced length, and the deviation at that size.
    struct Axis {
        int length;
        double deviation;
    };
    static Axis reduced(int length, double deviation);
    cv::Mat blur(const cv::Mat& values) const;

    cv::Size size_;
    Beyond beyond_;
    Axis x_, y_;
    cv::Mat blurred_;  // the weights at reduced size
};

}  // namespace lapfx::bleeding
