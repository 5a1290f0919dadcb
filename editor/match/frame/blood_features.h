// What is looked at in and around each pixel to tell blood from what is none: its colour against that of the whole
// frame, the colour near by, and how uneven it is there.
//
//     const cv::Mat haze = match::haze_of(clear_code, clear_view);
//     const match::BloodFeatures features = match::blood_features(code, view, haze);
//
// Pure, any thread. Lengths are px of a picture of 256 on its longer side, and scaled with it.
#pragma once

#include <array>
#include <opencv2/core.hpp>

namespace lapfx::match {

/// ln G/R, ln B/R and ln R less their medians over the view; their means over 2 and over 5 px; their means over 2 px
/// less those over 12; and how far the first and the last go apart within 2 and 5 px, as a logarithm.
inline constexpr std::size_t blood_feature_count = 16;
using BloodFeatures = std::array<cv::Mat, blood_feature_count>;  ///< CV_32F each, 0 outside of the view

/// px of the picture for each px of one of 256.
double unit_of(cv::Size size);

/// Means near each pixel, by a Gaussian of so many px of the picture, over `view` alone (CV_8U, 255 inside).
class Neighbourhood {
  public:
    Neighbourhood(const cv::Mat& view, double px);
    cv::Mat mean(const cv::Mat& of) const;  ///< CV_32F, as `of`; 0 outside of the view

  private:
    cv::Mat view_, outside_, weight_;
    double px_;
};

/// The light that smoke may have added, linear, CV_32F: what the darkest of blue and green within 15 px still has.
/// `code`: CV_8UC3, BGR; `view`: CV_8U, 255 inside.
cv::Mat haze_of(const cv::Mat& code, const cv::Mat& view);

/// `clear_haze`: haze_of() a clear frame of the video: what is above it is taken away first; empty: nothing is.
BloodFeatures blood_features(const cv::Mat& code, const cv::Mat& view, const cv::Mat& clear_haze);

}  // namespace lapfx::match
