// How close the colours of blood, smoke and tissue of two measured pictures are.
//
//     preview_estimator.measure(preview, 0), reference_estimator.measure(frame, 0);
//     const match::ColorLikeness likeness = match::likeness_of(match::colors_of(preview, preview_estimator),
//                                                              match::colors_of(frame, reference_estimator));
//
// Pure functions, any thread.
#pragma once

#include <optional>

#include "match/frame/measured_colors.h"

namespace lapfx::match {

/// CIE Delta E 2000 (color_difference.h); nothing where either picture has too few pixels. Smoke: of how bright it is
/// alone, unless both are tinted.
struct ColorLikeness {
    std::optional<double> blood, smoke, tissue;
};
ColorLikeness likeness_of(const MeasuredColors& preview, const MeasuredColors& reference);

}  // namespace lapfx::match
