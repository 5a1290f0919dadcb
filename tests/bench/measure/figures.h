// What `lapfx bench measure` says about measured amounts: figures, bounds on them, and how often intervals hold the
// true amount in pictures that they were not fitted to. Pure functions.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "match/frame/estimator.h"

namespace lapfx::bench {

/// One amount of one picture. Shares of the view, 0..1.
struct Reading {
    double truth = 0.0;
    match::Amount measured;
    std::optional<double> dice = {};  ///< of the true and the found area; none where there is next to nothing
};

/// By name, as in JSON. A figure that the readings do not have (the Dice without blood) is missing.
using Figures = std::map<std::string, double>;

/// count, and of at least one reading mean_absolute_error, bias (measured minus true), zero_error (mean absolute error
/// of the answer "none"), error_over_zero, interval_coverage, interval_width; of two that differ correlation; dice, the
/// mean; false_area, the mean of what is measured where there is nothing, and false_area_95, its 95th percentile.
Figures figures_of(std::span<const Reading> readings);

/// Most that a true amount may be to count as nothing.
inline constexpr double next_to_nothing = 0.0005;

struct Bound {
    std::string_view figure;
    double value = 0.0;
    bool at_least = false;  ///< the figure may not be below `value`; else its size may not be above
};
/// False where the figure is missing.
bool meets(const Figures& figures, const Bound& bound);
/// "MAE <= 0.03", or with another sign.
std::string text_of(const Bound& bound);
std::string text_of(const Bound& bound, const char* sign);

/// Coverage in a group of pictures by intervals that were fitted to all other groups.
struct LeftOut {
    std::string group;
    std::size_t count = 0;
    double factor = 0.0;    ///< of the intervals' half widths
    double coverage = 0.0;  ///< 0..1
};
/// Split conformal prediction (Lei et al., "Distribution-Free Predictive Inference for Regression", 2018): the factor
/// is the 90 % quantile of |error| over half width in the other groups. Nothing for fewer than two groups.
std::vector<LeftOut> leave_one_out(const std::map<std::string, std::vector<Reading>>& groups);

}  // namespace lapfx::bench
