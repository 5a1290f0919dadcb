// Cautery power over time (lapfx/curves.h): contacts as they come from the tool, cut into parts with the power of their time. The
// heat models and the smoke then need know nothing of curves.
//
//     PowerCurve power;
//     power.set(scene.curves.cautery_power);
//     cautery.set(power.apply(contacts), parameters);
//
// Between two points the power goes in steps of at most `largest_step` that have the mean of the line, at times that depend on the
// curve alone: however a stay is cut into contacts, the same heat comes of it. One thread at a time.
#pragma once

#include <span>
#include <vector>

#include "lapfx/tool.h"
#include "preset/factor_curve.h"

namespace lapfx::cautery {

class PowerCurve {
  public:
    static constexpr double largest_step = 0.02;  ///< of the factor
    static constexpr double shortest = 0.005;     ///< s between steps, where the line is steep
    static constexpr std::size_t most_parts = 1u << 16;

    void set(std::span<const CurvePoint> points);
    const FactorCurve& curve() const { return curve_; }

    /// In the same order; those that are not hot stay as they are. With an even curve the same list, else one that is valid until
    /// the next call. Should there be more than `most_parts`, steps are larger.
    std::span<const ToolContact> apply(std::span<const ToolContact> contacts);

  private:
    void make_steps(int coarser);
    std::size_t count_parts(std::span<const ToolContact> contacts) const;
    void add_parts(const ToolContact& contact);
    double factor_from(double begin, double end) const;

    FactorCurve curve_;
    std::vector<double> steps_;  // s, ascending
    int coarser_ = 1;            // that steps_ are of
    std::vector<ToolContact> parts_;
};

}  // namespace lapfx::cautery
