// How far the curves of a scene are from those of the reference, as a search takes it: residuals in standard errors, to
// be squared and summed.
//
// - Each amount at each time: (shown - aim) / error, where the error is that within a video (course_error). Errors of
//   neighbouring times go together (`block`): all times within one count as one.
// - The baseline of the reference may be a little hazy itself: the veil has an offset of its own, 0 +- 0.03
//   (`offset_error`), that is found along.
// - Parameters stay near where they were unless the curves say otherwise: 0 +- `prior` coordinates. So what the video
//   does not determine keeps its value.
//
// Pure functions, any thread.
#pragma once

#include <span>
#include <vector>

#include "match/fit/carried.h"
#include "match/fit/target.h"

namespace lapfx::match {

struct Weights {
    double blood = 1.0, veil = 1.0;  ///< 0 leaves an amount out
};

class Objective {
  public:
    static constexpr double offset_error = 0.03, prior = 2.0, block = 1.0;  ///< 1, coordinates, s

    Objective(std::vector<TargetPoint> target, const Weights& weights, std::vector<double> start);

    std::size_t times() const { return target_.size(); }
    /// Without an amount that is left out.
    std::span<const TargetPoint> target() const { return target_; }
    /// Blood and veil of each time, then those of the parameters, then that of the offset.
    std::size_t size() const { return 2 * times() + start_.size() + 1; }
    /// `offset`: of the veil. `residuals`: size().
    void residuals(const ShownCurves& shown, double offset, std::span<const double> coordinates,
                   std::span<double> residuals) const;
    /// The offset with which they are least.
    double best_offset(const ShownCurves& shown) const;
    /// Half the sum of squares, with the best offset.
    double cost(const ShownCurves& shown, std::span<const double> coordinates) const;

    /// How many blocks of time have an aim, of blood and of veil together: as many count as independent.
    double blocks() const;
    /// Of each residual of an amount: the part of its standard error in all of it, with the blood that smoke may hide.
    /// That is for how certain a result is; a search takes the residuals as they are, or it would lose what is there.
    std::vector<double> parts_of_error() const;
    /// How the residuals change where all aims are more by the standard error of their scale (CourseError).
    std::vector<double> blood_scaled() const;
    std::vector<double> veil_scaled() const;

  private:
    std::vector<TargetPoint> target_;
    std::vector<double> start_;
    double in_block_ = 1.0;                         ///< times within a block
    std::vector<double> blood_scale_, veil_scale_;  ///< of each time: 1 / error; 0: no aim
};

}  // namespace lapfx::match
