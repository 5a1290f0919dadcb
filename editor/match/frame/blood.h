// Blood in a frame: where a film of it explains the change since the baseline, its smoke removed, or, where the
// baseline does not lie well, what is redder than all tissue near by was.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "lapfx/scene.h"
#include "match/frame/film.h"

namespace lapfx::match {

/// Pixels that may be blood around those that surely are belong to it when enough are sure; where the veil or the dark
/// hides the colour, the nearest places that can be read decide.
class BloodFinder {
  public:
    /// How well the baseline lies over the frame.
    struct Laid {
        bool well = true;  ///< so well that a change of a pixel tells a film (film.h); else blood is what is redder
        /// How much of the baseline's texture is there, 0..1: the less, the farther tissue may have moved, and the
        /// wider the part of the baseline that it is compared with.
        double likeness = 1.0;
        cv::Mat tissue = {};  ///< CV_8U, 255 where the baseline shows tissue; empty: where the frame is valid
    };
    /// `baseline`, `frame`, `light`: linear light, CV_32FC3; `veil`: CV_32F; `valid`: CV_8U.
    void find(const cv::Mat& baseline, const cv::Mat& baseline_redness, const cv::Mat& frame, const cv::Mat& veil,
              const cv::Mat& light, const cv::Mat& valid, const BloodQualifier& qualifier, const Laid& laid);

    const cv::Mat& blood() const { return blood_; }      ///< CV_8U, 255 where there is blood
    const cv::Mat& redness() const { return redness_; }  ///< of the frame without smoke, CV_32F
    const cv::Mat& hidden() const { return hidden_; }    ///< CV_8U, 255 where the colour cannot be read
    /// CV_8U, 255 where blood may be, thinner or less sure than blood(): left out when the veil is looked for.
    const cv::Mat& redder() const { return redder_; }

  private:
    void find_film(const cv::Mat& baseline, const cv::Mat& baseline_redness, const cv::Mat& frame, const cv::Mat& veil,
                   const cv::Mat& light, const cv::Mat& valid, const BloodQualifier& qualifier);
    void find_redder(const cv::Mat& baseline, const cv::Mat& baseline_redness, const cv::Mat& frame,
                     const cv::Mat& veil, const cv::Mat& light, const cv::Mat& valid, const BloodQualifier& qualifier,
                     const Laid& laid);
    void see_covered(const cv::Mat& baseline, const cv::Mat& baseline_redness, const cv::Mat& tissue);
    void clear_smoke(const cv::Mat& frame, const cv::Mat& veil, const cv::Mat& light);
    void clear_sure_smoke(const cv::Mat& frame, const cv::Mat& veil, const cv::Mat& light, const cv::Mat& valid,
                          const cv::Mat& tissue, double within);
    float share_of_smoke(const cv::Mat& light, const cv::Mat& valid, const cv::Mat& tissue);
    void grow(const cv::Mat& valid, double of_patch);
    void fill_hidden(const cv::Mat& valid);

    FilmSolver film_;
    cv::Mat clear_, redness_, near_, nearer_, seen_, seen_redness_, sure_, maybe_, blood_, hidden_, redder_, labels_;
    std::vector<float> reds_;
    cv::Mat smoke_, covered_, unshaded_, unshaded_near_, unshaded_nearer_, decided_, share_, weight_;
};

}  // namespace lapfx::match
