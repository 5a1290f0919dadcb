// One case of lapfx bench streaming: so many clips, playing in a certain way.
#pragma once

#include "commands/bench_host.h"

namespace lapfx::commands {

constexpr std::size_t ample_memory = std::size_t{3} << 30;  // for 60 resident clips

struct Way {
    const char* name;
    Scheme scheme;
    SmokeResolution resolution;
    int step = 1;  ///< frames of a clip in a cycle of the display
    LateClips late = LateClips::repeat;
    std::size_t memory = ample_memory;
};

/// How much is measured.
struct StreamingExtent {
    std::vector<int> streams;  ///< of the table, ascending
    int compared = 15;         ///< streams, in the ratios whose names end in it
    int warm_up = 4, measured = 16;
    int clip_frames = bench_clip_frames;
    int long_frames = 300;                                ///< 10 s: clips that do not fit
    std::size_t long_memory = StreamingOptions{}.memory;  ///< what they do not fit into
};

/// Opens the clips, plays them until memory is full, and measures.
StreamingRow measure(const HostFrame& host, const Way& way, int streams, const BenchClips& clips,
                     const StreamingExtent& extent);
/// Takes the place of the row of the same case if it is better.
void keep_best(std::vector<StreamingRow>& rows, const StreamingRow& row);
/// The row must be there.
const StreamingRow& find(std::span<const StreamingRow> rows, const Way& way, int streams);
BenchRow as_bench_row(const StreamingRow& row);

}  // namespace lapfx::commands
