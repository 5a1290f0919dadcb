// One case of lapfx bench streaming: a number of clips and a way of playing.
#pragma once

#include "bench/streaming/host.h"

namespace lapfx::bench {

constexpr std::size_t ample_memory = std::size_t{3} << 30;  // 60 resident clips fit in

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
    std::vector<int> streams;  ///< numbers of streams in the table, ascending
    int compared = 15;         ///< number of streams at the end of the ratios' names
    int warm_up = 4, measured = 16;
    int clip_frames = bench_clip_frames;
    int long_frames = 300;                                ///< 10 s: clips that do not fit
    std::size_t long_memory = StreamingOptions{}.memory;  ///< the memory that they do not fit into
};

/// Opens the clips, plays them until memory is full, and measures.
StreamingRow measure(const HostFrame& host, const Way& way, int streams, const BenchClips& clips,
                     const StreamingExtent& extent);
/// Replaces the row of the same case if it is better.
void keep_best(std::vector<StreamingRow>& rows, const StreamingRow& row);
/// The row must be there.
const StreamingRow& find(std::span<const StreamingRow> rows, const Way& way, int streams);
BenchRow as_bench_row(const StreamingRow& row);

}  // namespace lapfx::bench
