// The veil of a frame: at each place the share of its light that is smoke's and not tissue's.
//
// Model (scattering, as in He, Sun and Tang, "Single image haze removal using dark channel prior", 2009, with the clear
// frame known): frame = (1 - veil) * baseline + veil * light. With the light of dense smoke known (haze_light.h), one
// number is fitted by least squares over a window around each pixel, from wide to narrow windows, each held to the one
// before as far as it says little. Pixels that no veil explains (blood, instruments) stand out and count less.
//
// The dark behind tissue lies farther back and has more smoke before it; it also has no noise to speak of. So it is
// solved apart: it says nothing of the veil over tissue, nor tissue of that over the dark.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace lapfx::match {

/// Reused from frame to frame.
class VeilSolver {
  public:
    /// `scale`: size of the pictures over that of the estimator's, for which the windows are meant.
    explicit VeilSolver(double scale = 1.0) : scale_(scale) {}
    /// `baseline`, `frame`: linear light, CV_32FC3. `counts`: CV_32F, 0..1, how much a pixel counts; 0 where there is
    /// blood, an instrument or white. `light`: linear light of dense smoke at each pixel, CV_32FC3.
    void solve(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& counts, const cv::Mat& light);
    /// Continues from the veil that was solved last, of the same frame, when other pixels count now.
    void refine(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& counts, const cv::Mat& light);
    /// Only the widest windows: what most of the picture says.
    void solve_wide(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& counts, const cv::Mat& light,
                    int passes);

    /// Only the narrowest windows, every pixel in full: what a veil could explain at most. `start`: where nothing
    /// counts.
    void solve_narrow(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& counts, const cv::Mat& light,
                      const cv::Mat& start);

    /// Gives the map this mean (0..1) over `part` (CV_8U, 255): by a factor, and what that cannot do evenly.
    void scale_to(double mean, const cv::Mat& part);
    /// Takes this map, CV_32F, 0..1, over `part` (CV_8U, 255).
    void put(const cv::Mat& veil, const cv::Mat& part) { veil.copyTo(veil_, part); }

    const cv::Mat& veil() const { return veil_; }      ///< CV_32F, 0..1
    const cv::Mat& weight() const { return weight_; }  ///< CV_32F, how much each pixel counted at last
    /// What the model leaves unexplained: distance of frame and model over what their noise allows, CV_32F. Where the
    /// light may be off by the share `light_error` (0 or more), a dense veil is allowed more than a thin one.
    void residual(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& light, double light_error,
                  cv::Mat& into) const;
    /// The sum over `part` (CV_8U, 255) of the squared residual, each cut off at an outlier's.
    double misfit(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& part, const cv::Mat& light) const;

  private:
    void weigh(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& counts, const cv::Mat& light, bool robust);
    void bound(const cv::Mat& frame, const cv::Mat& light);
    void solve_window(int reach, double hold);
    void solve_places(const cv::Mat& sums, float held, bool dark);
    void solve_widest();

    double scale_;
    cv::Mat veil_, weight_;
    cv::Mat smooth_, bound_;  // the frame, and the most that the veil can be
    cv::Mat dark_;            // CV_8U, 255 where the baseline shows the dark behind tissue
    bool has_dark_ = false;
    // CV_32FC2: weighted (light - baseline)^2 and (frame - baseline) * (light - baseline), of tissue and of the dark
    cv::Mat normal_, normal_of_dark_, sums_;
};

/// How much of a veil stands out over an even one: the mean over `part` (CV_8U, 255) of what is above its median there,
/// 0..1. A plume does; haze, which lies over the whole view, hardly. `veil`: CV_32F; `sorted`: reused.
double standing_out(const cv::Mat& veil, const cv::Mat& part, std::vector<float>& sorted);

/// VeilSolver::misfit of a frame that is the baseline with its channels multiplied, without veil.
double misfit_of_gains(const cv::Mat& baseline, const cv::Vec3f& gains, const cv::Mat& frame, const cv::Mat& part);

}  // namespace lapfx::match
