// How fast `lapfx measure` is.
#pragma once

namespace lapfx::bench {

/// Seconds that measuring takes (baseline, survey, each frame, all decoding) on one core, for the first frames of the
/// shipped reference at 720x480, over the seconds that playing them takes; the best of three. Throws Error (runtime)
/// where not nearly all frames are measurable: frames that are refused cost less.
double measure_over_playback(int frames);

}  // namespace lapfx::bench
