// Light that smoke adds to a frame, told apart from what the camera's gain takes from it.
//
// While bright smoke is near the lens the camera darkens: a line through the pixels of a frame over its baseline reads
// that dip as a veil. So what is seen is split by colour first:
//
//     frame / gain = transmission * baseline + light
//
// Light of smoke has nearly one tint. The colour across that tint is the tissue's alone and tells gain * transmission
// at each place; what is left over is light. Where least of it is added least is hidden, too: there the gain is told.
// Colours are means over small windows, so the baseline may lie a little beside the frame.
//
// What cannot be told apart is a gain and a veil that lies evenly over the view and throws no light back: it counts as
// gain, whose interval is wide for that reason (interval.h).
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace lapfx::match {

/// Of one frame.
struct AddedLight {
    /// Mean of what smoke adds, luminance in linear light before the camera's gain: a share of white, from 0. It may be
    /// above 1: the camera darkens before that.
    double light = 0.0;
    double gain = 1.0;  ///< factor of the camera against the baseline, least_gain..most_gain
    /// The gain if the smoke before the least lit places is as bright for its veil as it gets near the lens, and if it
    /// is as dim as it gets.
    double of_bright_smoke = 1.0, of_dim_smoke = 1.0;
    double spread = 0.0;  ///< of the gain: half the way between its quartiles over those places
    double tissue = 0.0;  ///< mean luminance of the baseline, linear
    /// Enough tissue with a colour of its own is seen; without it the gain is told as 1 and the light as 0.
    bool known = false;
};

/// Reused from frame to frame; one thread at a time, any thread; no OpenGL.
class AddedLightFinder {
  public:
    /// `baseline`, `frame`: linear light, CV_32FC3 (blue, green, red), of the same size. `dense`: linear light of dense
    /// smoke at each pixel, CV_32FC3. `part`: CV_8U, 255 where to look.
    AddedLight find(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& dense, const cv::Mat& part);

  private:
    /// Of one small window; colours are means over it.
    struct Place {
        cv::Vec3f baseline, frame;
        float dense;   // luminance of dense smoke
        float across;  // of the baseline's colour across the tint, squared
        float slope;   // gain * transmission
        float light;   // luminance that is added, after the gain
    };
    void mean_colors(const cv::Mat& picture, cv::Mat& into);
    void find_places(const cv::Mat& dense);
    void find_gain(AddedLight& found);
    void find_light(AddedLight& found) const;

    cv::Mat shares_, counted_, half_, means_of_baseline_, means_of_frame_;
    std::vector<Place> places_;
    std::vector<float> sorted_;
};

}  // namespace lapfx::match
