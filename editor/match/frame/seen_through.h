// Where tissue is seen through bright smoke. Smoke near the tip or the lens is brighter than haze, so no veil with the
// light of haze explains it; neither does one explain an instrument. The two are told apart by what is behind: smoke
// lets the tissue's colour through, metal does not.
//
//     frame = transmission * baseline + light * tint
//
// Light may differ from pixel to pixel. The colour across the tint is the tissue's alone: over a small window around
// each pixel it tells the transmission, by least squares, and how well that explains what is seen.
#pragma once

#include <opencv2/core.hpp>

namespace lapfx::match {

/// Reused from frame to frame; one thread at a time, any thread; no OpenGL.
class SeenThrough {
  public:
    /// `baseline`, `frame`: linear light, CV_32FC3 (blue, green, red), of the same size. `part`: CV_8U, 255 where to
    /// look.
    void find(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& part);

    const cv::Mat& smoke() const { return smoke_; }  ///< CV_8U, 255 where tissue is seen through bright smoke
    const cv::Mat& veil() const { return veil_; }    ///< CV_32F, 0..1: 1 - transmission, where smoke() is 255

  private:
    void add_up(const cv::Mat& baseline, const cv::Mat& frame, const cv::Rect& box);

    cv::Mat products_, sums_;  // CV_32FC3, of colours across the tint: tissue^2, seen * tissue, seen^2
    cv::Mat smoke_, veil_;
};

}  // namespace lapfx::match
