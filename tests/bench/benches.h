// The parts of `lapfx bench`. Each throws Error, and says progress on stderr.
#pragma once

#include "bench/report.h"

namespace lapfx::bench {

BenchReport bench_bleeding(const BenchOptions& options);
BenchReport bench_editor(const BenchOptions& options);
BenchReport bench_fit(const BenchOptions& options);
BenchReport bench_frame(const BenchOptions& options);
BenchReport bench_measure(const BenchOptions& options);
BenchReport bench_measure_pairs(const BenchOptions& options);
BenchReport bench_measure_learn(const BenchOptions& options);
BenchReport bench_streaming(const BenchOptions& options);

}  // namespace lapfx::bench
