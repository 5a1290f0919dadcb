// Cautery power over time (lapfx/curves.h): contacts as they come from the tool, cut into parts with the power of their
// time. The heat models and the smoke then need know nothing of curves.
//
// Between two points the power goes in steps of at most `largest_step` that have the mean of the line, at times that
// depend on the curve alone: however a stroke is cut into contacts, the same heat comes of it. One thread at a time.
#pragma once

#include <span>
#include <vector>

#include "lapfx/tool.h"
#include "preset/factor_curve.h"

namespace lapfx::tool {

class PowerCurve {
  public:
    static constexpr double largest_step = 0.02;  ///< of the factor
    static constexpr double shortest = 0.005;     ///< s between steps, where the line is steep
    static constexpr int coarsest = 64;

    explicit PowerCurve(std::span<const CurvePoint> points = {});
    const FactorCurve& curve() const { return curve_; }

    /// With steps of so many times the largest, 1 at first; beyond `coarsest` there are none, and each contact is one
    /// part, with the mean of its time.
    void make_steps(int coarser);
    int coarser() const { return coarser_; }

    /// How many parts a contact is cut into: one, unless it is hot.
    std::size_t count(const ToolContact& contact) const;
    /// Adds them to `parts`, in the order of their times. `contact`: usable.
    void cut(const ToolContact& contact, std::vector<ToolContact>& parts) const;

  private:
    double factor_from(double begin, double end) const;

    FactorCurve curve_;
    std::vector<double> steps_;  // s, ascending
    int coarser_ = 1;
};

}  // namespace lapfx::tool
