// Once the amounts are fitted, the colours of what was found are matched: --colors of lapfx fit, and Colours of the
// editor's Fit.
//
//     const std::vector<std::string> lines = fit_colors(result, {.reference = peaks.at_peak(), .target = target},
//     curve);
//
// The thread that asks `curve` for its pictures.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lapfx/progress.h"
#include "match/fit/color_match.h"
#include "match/fit/fit.h"

namespace lapfx::match {

struct ColorFit {
    ColorsAtPeak reference = {};  ///< measured in the video
    std::span<const TargetPoint> target = {};
    std::vector<std::string> keys = {color_keys().begin(), color_keys().end()};  ///< that are free
    Progress progress = {};  ///< of all that is drawn, about; false ends it with the best so far
};

/// What was found becomes the result's, with its curves. Lines for people, of the differences and of what was changed.
/// Throws as PreviewCurve::measure().
std::vector<std::string> fit_colors(FitResult& result, const ColorFit& input, PreviewCurve& curve);

}  // namespace lapfx::match
