// lapfx bench streaming: the cost of N smoke clips over a 1280x1024 frame by each scheme, as in the paper's table 2,
// and the time of FFmpeg for comparable work.
//
// Method: clips 720x480, MPEG-4 part 2, 30 frames per second, each over the whole view (environmental smoke), luma
// keyed with noise; one frame of every clip a frame (Policy::wait: nothing is skipped). "Late" means the paper's two
// schemes on a display half as fast as the clips, which advance by two frames in each of its cycles: pipeline sends one
// of the two in every cycle, buffering (with LateClips::skip, as in the paper) one of four in every second cycle.
// Decoding stops before each of these cycles, so that only sending is compared: a scheme that skips frames which are
// not decoded in time would seem to send fast. The paper's schemes shade every layer at the screen's resolution, ours
// at the default of Effects. After the warm-up (a loop of the clips for resident, otherwise a few frames) `measured`
// frames follow. Times per frame are medians; waiting, sending, decoding and copying are means, because the buffered
// scheme does not send in every frame. The table is measured three times (--rounds), and the best round of each case
// counts, so that other work of the machine does not affect only one of them. comparisons.cpp has the other
// ratios. --only measures the cases of one ratio, in turns.
#include "bench/streaming/streaming.h"

#include <algorithm>

#include "bench/benches.h"
#include "bench/streaming/comparisons.h"
#include "commands/options.h"
#include "commands/progress.h"

namespace lapfx::bench {

namespace {

constexpr Way ways[] = {
    pipeline_way, buffered_way, {"buffered planar", Scheme::buffered_planar, SmokeResolution::balanced}, resident_way};

/// The paper's schemes on a slow display, where buffering skips frames.
constexpr Way pipeline_late{"pipeline, late", Scheme::pipeline, SmokeResolution::screen, 2};
constexpr Way buffered_late{"buffered, late", Scheme::buffered, SmokeResolution::screen, 2, LateClips::skip};

StreamingExtent extent_of(const BenchOptions& options) {
    if (!options.short_form) return {.streams = {1, 2, 3, 5, 8, 10, 15, 30, 60}};
    return {.streams = {1, 2},
            .compared = 2,
            .warm_up = 1,
            .measured = 2,
            .clip_frames = 12,
            .long_frames = 30,
            .long_memory = std::size_t{18} << 20};
}

/// One figure by two ways, one over the other.
struct Quotient {
    const char* name;
    const Way *above, *below;
    double StreamingRow::*figure;
};
/// The paper's comparison: late, so that buffering shows half as many frames. The other one shows the same frames at
/// the same rate.
constexpr Quotient quotients[] = {
    {"upload_buffered_over_pipeline_15", &buffered_late, &pipeline_late, &StreamingRow::sending},
    {"upload_buffered_over_pipeline_15_nothing_skipped", &buffered_way, &pipeline_way, &StreamingRow::sending},
    {"upload_resident_over_pipeline_15", &resident_way, &pipeline_way, &StreamingRow::sending},
    {"upload_resident_over_buffered_15", &resident_way, &buffered_way, &StreamingRow::sending}};

double value_of(const Quotient& quotient, std::span<const StreamingRow> rows, int streams) {
    return find(rows, *quotient.above, streams).*quotient.figure /
           find(rows, *quotient.below, streams).*quotient.figure;
}

/// The two cases of one ratio, in turns.
void measure_one(const Quotient& quotient, const HostFrame& host, const StreamingExtent& extent, int rounds,
                 BenchReport& report) {
    const BenchClips clips(extent.compared, extent.clip_frames);
    std::vector<StreamingRow> rows;
    commands::Progress progress("measuring", 2 * rounds);
    for (int round = 0; round < rounds; ++round)
        for (const Way* way : {quotient.above, quotient.below}) {
            keep_best(rows, measure(host, *way, extent.compared, clips, extent));
            progress.step();
        }
    for (const StreamingRow& row : rows) report.rows.push_back(as_bench_row(row));
    report.ratios[quotient.name] = value_of(quotient, rows, extent.compared);
}

void measure_only(const std::string& name, const HostFrame& host, const StreamingExtent& extent, int rounds,
                  BenchReport& report) {
    std::string names;
    const auto known = [&](const char* one) {
        names += (names.empty() ? "" : ", ") + std::string(one);
        return name == one;
    };
    for (const Quotient& quotient : quotients)
        if (known(quotient.name)) return measure_one(quotient, host, extent, rounds, report);
    for (const Comparison& comparison : comparisons())
        if (known(comparison.name)) return comparison.measure(host, extent, rounds, report);
    throw commands::wrong_option("--only", name + " is not one of " + names);
}

void measure_all(const HostFrame& host, const BenchOptions& options, const StreamingExtent& extent, int rounds,
                 BenchReport& report) {
    std::vector<StreamingRow> rows;
    {
        const BenchClips clips(extent.streams.back(), extent.clip_frames);
        commands::Progress progress("measuring", rounds * static_cast<int>(std::size(ways) * extent.streams.size()));
        for (int round = 0; round < rounds; ++round) {
            for (const Way& way : ways)
                for (const int streams : extent.streams) {
                    keep_best(rows, measure(host, way, streams, clips, extent));
                    progress.step();
                }
            for (const Way& way : {pipeline_late, buffered_late})
                keep_best(rows, measure(host, way, extent.compared, clips, extent));
        }
    }
    for (const StreamingRow& row : rows) report.rows.push_back(as_bench_row(row));
    for (const Quotient& quotient : quotients) report.ratios[quotient.name] = value_of(quotient, rows, extent.compared);
    for (const Comparison& comparison : comparisons()) comparison.measure(host, extent, rounds, report);
    report.table = streaming_table(rows);
    if (!options.plot.empty()) plot_streaming(rows, options.plot);
}

}  // namespace

BenchReport bench_streaming(const BenchOptions& options) {
    const Context context = Context::create(Backend::automatic);
    BenchReport report{.bench = "streaming", .renderer = context.renderer(), .rows = {}, .ratios = {}, .table = {}};
    const HostFrame host;
    const StreamingExtent extent = extent_of(options);
    const int rounds = options.short_form ? 1 : options.rounds;
    if (options.only.empty())
        measure_all(host, options, extent, rounds, report);
    else
        measure_only(options.only, host, extent, rounds, report);
    return report;
}

}  // namespace lapfx::bench
