// How much veil a whole frame shows, told by figures that do not need the baseline to lie exactly over it.
//
// A veil mixes every colour with the same light: contrast, colour and detail shrink, the darkest places rise. Each
// statistic compares one such property of frame and baseline over the same part of the picture, and says which veil
// would have changed it so. Each is wrong in its own way (tissue that came into view, noise, blood); together they say
// more than the map of veil.h where tissue or camera moved (veil_model.h).
//
// All in linear light, where a veil mixes. Any thread; no OpenGL.
#pragma once

#include <array>
#include <opencv2/core.hpp>

namespace lapfx::match {

/// What the statistics compare, of one picture.
struct Appearance {
    static constexpr int steps = 60;  ///< quantiles from 2 % to 97 %
    using Quantiles = std::array<double, steps>;
    std::array<Quantiles, 3> quantiles{};  ///< of blue, green and red, linear
    double dark = 0.0;                     ///< mean dark channel (He, Sun and Tang 2009), windows of 15 px
    double low = 0.0;                      ///< 10 % quantile of the darkest channel
    double saturation = 0.0;               ///< mean of (most - least) / most of the three channels
    double chroma = 0.0;                   ///< mean of most - least
    double detail = 0.0;                   ///< mean gradient of luma, a pixel's difference
    double spread = 0.0;                   ///< standard deviation of luma
};

/// Looks at pictures one after the other; holds what it needs between them.
class AppearanceFinder {
  public:
    /// `code`: CV_8UC3 BGR, sRGB code values; `part`: CV_8U, 255 where to look. Zero for an empty part.
    Appearance find(const cv::Mat& code, const cv::Mat& part);

  private:
    cv::Mat least_, luma_, dx_, dy_, inner_;
};

inline constexpr std::size_t veil_statistics = 8;
/// The veil that each property tells, -0.6..1.1: line through the quantiles, by its offset (a change of exposure
/// cancels) and by its slope; dark channel; low quantile; saturation; chroma; detail; spread.
using VeilStatistics = std::array<double, veil_statistics>;
/// `light`: linear light of dense smoke, blue, green, red, mean over the part.
VeilStatistics statistics_of(const Appearance& baseline, const Appearance& frame, const cv::Vec3d& light);

}  // namespace lapfx::match
