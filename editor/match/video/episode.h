// A curve of amounts in a few figures: when it starts, how fast it rises, how far, how long it stays.
#pragma once

#include <optional>
#include <span>

#include "match/frame/frame_amounts.h"

namespace lapfx::match {

/// Times in s; a course is in units of its own, 0..1. What the curve does not show is missing: an amount that never
/// falls has no decay.
struct Episode {
    std::optional<double> peak;     ///< the largest amount, smoothed over 0.2 s; nothing: no frame is measurable
    std::optional<double> mean;     ///< over the time that is measurable
    std::optional<double> area;     ///< area under the curve where it is measurable, s
    std::optional<double> onset;    ///< when it last passes 10 % of the way from its floor, before its peak
    std::optional<double> rise;     ///< from 10 % to 90 % of that way
    std::optional<double> peak_at;  ///< nothing: the amount stays within its own uncertainty
    std::optional<double> decay;    ///< from the peak until half of the way is gone
};

/// Frames whose amount is not measurable are left out.
Episode episode_of(std::span<const FrameAmounts> frames, Curve curve);

}  // namespace lapfx::match
