// How far the curves of a scene are from those of the reference, as a search takes it: residuals in standard errors, to
// be squared and summed.
//
// Amounts are blood, the veil, and what of the veil stands out over an even one (the plume), which weighs as the veil.
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

#include <array>
#include <span>
#include <vector>

#include "match/fit/carried.h"
#include "match/fit/target.h"

namespace lapfx::match {

struct Weights {
    double blood = 1.0, veil = 1.0;  ///< 0 leaves an amount out; the plume weighs as the veil, of which it is a part
};

class Objective {
  public:
    static constexpr double offset_error = 0.03, prior = 2.0, block = 1.0;  ///< 1, coordinates, s

    Objective(std::vector<TargetPoint> target, const Weights& weights, std::vector<double> start);

    static constexpr std::size_t curves = 3;

    std::size_t times() const { return target_.size(); }
    /// Of residuals: so many are of amounts.
    std::size_t amounts() const { return curves * times(); }
    /// Without an amount that is left out.
    std::span<const TargetPoint> target() const { return target_; }
    /// Blood of each time, then the veil, then the plume, then those of the parameters, then that of the offset.
    std::size_t size() const { return amounts() + start_.size() + 1; }
    /// `offset`: of the veil. `residuals`: size().
    void residuals(const ShownCurves& shown, double offset, std::span<const double> coordinates,
                   std::span<double> residuals) const;
    /// The offset with which they are least.
    double best_offset(const ShownCurves& shown) const;
    /// Half the sum of squares, with the best offset.
    double cost(const ShownCurves& shown, std::span<const double> coordinates) const;

    /// How many blocks of time have an aim, of all amounts together: as many count as independent.
    double blocks() const;
    /// Of each residual of an amount: the part of its standard error in all of it, with the blood that smoke may hide.
    /// That is for how certain a result is; a search takes the residuals as they are, or it would lose what is there.
    std::vector<double> parts_of_error() const;
    /// How the residuals change where all aims of one amount are more by the standard error of their scale
    /// (CourseError): of each amount.
    std::array<std::vector<double>, curves> scaled() const;

  private:
    std::vector<TargetPoint> target_;
    std::vector<double> start_;
    double in_block_ = 1.0;                           ///< times within a block
    std::array<std::vector<double>, curves> scales_;  ///< of each amount, at each time: 1 / error; 0: no aim
};

}  // namespace lapfx::match
