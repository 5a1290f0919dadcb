// Cautery power over time (lapfx/curves.h): contacts as they come from the tool, cut into parts with the power of their
// time. The heat models and the smoke then need know nothing of curves.
//
// Between two points the power changes in steps, each with the mean of the line, at times that depend only on the curve
// and the level. So a stroke gives the same heat however it is cut into contacts. Only at the last level, which very
// long histories under a curve reach, each contact has the mean of its own time. One thread at a time.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lapfx/tool.h"
#include "preset/factor_curve.h"

namespace lapfx::tool {

class PowerCurve {
  public:
    static constexpr double largest_step = 0.02;  ///< of the factor in one step, at level 0
    static constexpr double shortest = 0.005;     ///< s between steps, where the line is steep
    /// How fine the steps are: level 0 has the step above, each next level a step twice as large. At the last level
    /// each contact is one part with the mean of its time.
    static constexpr int levels = 8;

    explicit PowerCurve(std::span<const CurvePoint> points = {});
    const FactorCurve& curve() const { return curve_; }

    /// How many parts a contact is cut into: one if it is not hot.
    std::uint32_t count(const ToolContact& contact, int level) const;
    /// Adds them to `parts`, in the order of their times. `contact`: usable.
    void cut(const ToolContact& contact, int level, std::vector<ToolContact>& parts) const;

  private:
    std::vector<double> steps_of(int level) const;
    double factor_from(double begin, double end) const;

    FactorCurve curve_;
    std::array<std::vector<double>, levels> steps_;  // s, ascending
};

}  // namespace lapfx::tool
