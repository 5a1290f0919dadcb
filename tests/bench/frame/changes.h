// What the core costs a host: memory, objects of OpenGL, threads, and how long a frame takes in which a preset, its
// clips or the organ change.
#pragma once

#include "bench/report.h"

namespace lapfx::bench {

class HostFrame;

/// Adds its rows, and for each change the ratio
///   hitch_CHANGE_over_16ms   time of a frame with that change beyond frames without one, the median of the runs, over
///                            16 ms; what takes longer is made on another thread before, as the headers say
/// `host`: what is drawn into. `short_form`: as in BenchOptions. Context current.
void measure_changes(const HostFrame& host, BenchReport& report, bool short_form);

}  // namespace lapfx::bench
