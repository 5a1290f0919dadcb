// Ratios of lapfx bench streaming that need more than the rows of its table. Each is measured separately.
#pragma once

#include "bench/streaming/case.h"

namespace lapfx::bench {

inline constexpr Way pipeline_way{"pipeline", Scheme::pipeline, SmokeResolution::screen};
inline constexpr Way buffered_way{"buffered", Scheme::buffered, SmokeResolution::screen};
inline constexpr Way resident_way{"resident", Scheme::resident, SmokeResolution::balanced};

struct Comparison {
    const char* name;  ///< name of its ratio, or of the first one; for --only
    void (*measure)(const HostFrame& host, const StreamingExtent& extent, int rounds, BenchReport& report);
};
std::span<const Comparison> comparisons();

}  // namespace lapfx::bench
