// lapfx fit --colors: once the amounts are fitted, the colours of the scene are matched.
#pragma once

#include <string>
#include <vector>

#include "lapfx/progress.h"
#include "match/fit/color_match.h"
#include "match/fit/fit.h"
#include "match/measure.h"

namespace lapfx::commands {

/// Has the colours collected, too, when the reference is measured. `colors` must outlive measuring.
void watch_colors(match::MeasureOptions& options, match::PeakColors& colors);

/// Matches the colours of what was fitted, which becomes the result's: of the preset, and exposure where the scene is
/// written. Lines for people, of the differences and of what was changed. `progress` ends it with the best so far.
/// Render thread, context current. Throws as PreviewCurve::measure().
std::vector<std::string> fit_colors(match::FitResult& result, const match::PeakColors& reference,
                                    std::span<const match::TargetPoint> target, match::PreviewCurve& curve,
                                    bool scene_is_written, const lapfx::Progress& progress);

}  // namespace lapfx::commands
