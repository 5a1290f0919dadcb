// The curves of a fit as CSV.
#pragma once

#include <span>
#include <string>

#include "match/fit/fit.h"

namespace lapfx::match {

/// A row for each time of the target, s of the scene: the reference's amounts with their intervals, and what the scene
/// showed before and after. What is not measurable is empty.
std::string curves_csv(std::span<const TargetPoint> target, const FitResult& result);

}  // namespace lapfx::match
