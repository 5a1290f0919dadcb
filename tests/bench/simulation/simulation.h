// The simulation without drawing: the cost of a tool sample after a long history, and the time of a whole scene.
#pragma once

#include "bench/report.h"

namespace lapfx::bench {

/// Adds its rows, and the ratios
///   sample_cost_10min_over_10s   CPU time of a sample of a held stroke after ten minutes of strokes elsewhere, over
///                                that after ten seconds; the largest of four tools and of a cut after clips
///   suction_of_old_blood_10min_over_10s   the same for suction where all those strokes' blood is
///   simulation_over_real_time    CPU time of the amounts over 60 s of the sample scene, at 30 a second, over 60 s
/// `short_form`: as in BenchOptions. Context current.
void measure_simulation(BenchReport& report, bool short_form);

}  // namespace lapfx::bench
