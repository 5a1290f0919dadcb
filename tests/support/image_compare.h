// Compares two 8-bit images and says where and how far they differ.
//
//     Comparison result = compare(reference, candidate, {.max_difference = 1});
//     EXPECT_TRUE(result.passed) << result.reason;
//
// A tolerance says what may differ; by default nothing. Images with another size or other channels never pass.
#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace lapfx::tests {

struct Tolerance {
    int max_difference = 0;         ///< per channel, code values 0..255, still taken as equal
    double failing_fraction = 0.0;  ///< share of the pixels that may differ by more
};

struct Comparison {
    bool passed = false;
    std::string reason;  ///< one line; also when it passed

    int max_difference = 0;        ///< over all pixels and channels
    double mean_difference = 0.0;  ///< over all pixels and channels
    int pixels = 0;
    int failing_pixels = 0;  ///< pixels that differ in a channel by more than the tolerance
    cv::Point worst;         ///< the first pixel with max_difference
};

Comparison compare(const cv::Mat& reference, const cv::Mat& candidate, const Tolerance& tolerance = {});

/// |reference - candidate| * gain in colour, opaque; empty if size or channels differ.
cv::Mat difference_image(const cv::Mat& reference, const cv::Mat& candidate, int gain = 16);

/// "max difference  failing pixels" for growing tolerances, a line each: shows what tolerance an image would
/// need.
std::string threshold_sweep(const cv::Mat& reference, const cv::Mat& candidate);

}  // namespace lapfx::tests
