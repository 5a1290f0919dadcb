// How alike frame and baseline are when tissue has moved by itself: each pixel is looked for near where the camera's
// motion (placement.h) lays it.
#pragma once

#include <opencv2/core.hpp>
#include <opencv2/video/tracking.hpp>

namespace lapfx::match {

/// Dense inverse search (Kroeger et al., "Fast Optical Flow using Dense Inverse Search", 2016) on textures of
/// texture_of, which smoke does not change. From frame to frame it goes on from what it found. One thread.
class DenseFlow {
  public:
    DenseFlow();
    /// `baseline`: as the camera's motion lays it over the frame; `counts`: CV_8U, where it is. `likeness`: of the
    /// two. Gives whether the flow makes them more alike; else there is none.
    bool find(const cv::Mat& baseline, const cv::Mat& counts, const cv::Mat& frame, double likeness);
    void forget() { flow_.release(); }

    double likeness() const { return likeness_; }

  private:
    cv::Ptr<cv::DISOpticalFlow> search_;
    cv::Mat flow_, map_, moved_;
    double likeness_ = 0.0;
};

}  // namespace lapfx::match
