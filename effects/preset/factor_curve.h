// A curve of lapfx/curves.h, prepared so that its value and its integral at any time cost O(log points).
//
//     const FactorCurve curve(scene.curves.emission);
//     const double mean = curve.integral(from, to) / (to - from);
//
// Changes only by assignment; any thread.
#pragma once

#include <span>
#include <vector>

#include "lapfx/curves.h"

namespace lapfx {

class FactorCurve {
  public:
    /// 1 all the time.
    FactorCurve() = default;
    /// Leaves out points that Curves does not allow. A value above `highest` counts as `highest`.
    explicit FactorCurve(std::span<const CurvePoint> points, double highest = 1000.0);

    bool even() const { return points_.empty(); }  ///< 1 all the time
    std::span<const CurvePoint> points() const { return points_; }
    double at(double time) const noexcept;
    double slope_after(double time) const noexcept;  ///< 1/s; at a point it is the slope of the line that begins there
    /// From `from` to `to`, s.
    double integral(double from, double to) const noexcept { return even() ? to - from : sum(to) - sum(from); }
    /// The points after `from` and before `to`.
    std::span<const CurvePoint> between(double from, double to) const noexcept;

    friend bool operator==(const FactorCurve& a, const FactorCurve& b) { return a.points_ == b.points_; }

  private:
    double sum(double time) const noexcept;  ///< the integral from the first point

    std::vector<CurvePoint> points_;
    std::vector<double> sums_;  // at each point
};

}  // namespace lapfx
