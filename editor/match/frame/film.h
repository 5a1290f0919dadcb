// How thick a film of blood explains what has changed between the baseline and a frame, and how surely.
//
// A film takes from each channel by the law of Beer and Lambert; smoke that is not known exactly adds its light, and
// what has moved lies in another light. With d the change of the logarithms of light from baseline to frame, per
// channel and within a few pixels,
//
//     d = gain + shade - absorption * thickness + veil_left * light / (transmission * tissue)
//
// is solved by least squares. Each equation counts by its noise: that of the camera and of the encoder, and that of
// tissue that is not exactly in its place. `gain`, one for the whole frame, is the exposure and white balance since the
// baseline.
#pragma once

#include <opencv2/core.hpp>

namespace lapfx::match {

/// Powers of a half by which a film of blood of thickness 1 weakens blue, green and red: lapfx_blood_absorption of
/// shaders/bleeding.glsl.
inline const cv::Vec3f blood_absorption(7.5F, 8.0F, 2.6F);
inline constexpr float least_through = 0.2F;   ///< transmission below which colour cannot be read
inline constexpr float darkest_red = 0.0024F;  ///< linear; code value 9: colour cannot be read below

/// One thread; no picture is allocated after the first of a size.
class FilmSolver {
  public:
    /// `baseline`, `frame`, `light`: linear light, CV_32FC3, BGR; `veil`: CV_32F; `valid`: CV_8U.
    void solve(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& veil, const cv::Mat& light,
               const cv::Mat& valid);

    /// CV_32F, 1 is a film that takes all but 1/256 of the green; negative where the tissue became less red.
    const cv::Mat& thickness() const { return thickness_; }
    const cv::Mat& sureness() const { return sureness_; }  ///< CV_32F: thickness in units of its standard deviation
    const cv::Mat& clear() const { return clear_; }        ///< the frame without smoke, linear, CV_32FC3
    const cv::Mat& hidden() const { return hidden_; }      ///< CV_8U, 255 in the valid view where no colour can be read
    /// Factors on linear light, BGR, since the baseline.
    const cv::Vec3f& gains() const { return gains_; }

  private:
    void see_changes(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& veil, const cv::Mat& light,
                     const cv::Mat& valid);
    cv::Vec3f common_change(const cv::Mat& valid) const;
    void sum(const cv::Mat& baseline, const cv::Mat& veil, const cv::Mat& light, const cv::Vec3f& gain);
    void solve_places(const cv::Mat& veil, const cv::Mat& valid);
    void see_doubt(const cv::Mat& valid);

    cv::Vec3f gains_{1.0F, 1.0F, 1.0F};
    cv::Mat clear_, hidden_, thickness_, sureness_;
    cv::Mat log_, mean_, square_;       // of the baseline's light
    cv::Mat change_, variance_, sums_;  // variance_: of change_, CV_32FC3
    cv::Mat uncertain_;                 // variance of the thickness
    cv::Mat less_red_;  // CV_32FC2: squared thickness where the tissue became less red, and whether it did
};

}  // namespace lapfx::match
