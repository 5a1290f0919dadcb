// The sides take turns, and the best round counts.
//
// The paper's pipeline waits for frames and sends them, and a plain shader (plain_smoke.h) draws them over the
// frame. Ours plays from graphics memory and is shaded at the default resolution of Effects. The saving is split into
// three parts: waiting and sending, drawing at the same resolution (the screen's), and drawing at another resolution.
// It also compares both at the clips' resolution, where ours saves nothing by resolution.
//
// Clips that do not fit: 10 s each, in the default memory; those that do not fit are decoded in every loop and sent as
// planes.
//
// FFmpeg keys the same clips by luma and puts them over a frame of one colour, on all processors, with the cheapest
// graph of those tried. Decoding counts on neither side (both play from memory) or on both, and ours then decodes every
// frame (planes). Without scaling its clips cover a quarter of the frame.
#include "bench/streaming/comparisons.h"

#include <algorithm>
#include <limits>
#include <set>

#include "bench/streaming/decoding_rate.h"
#include "bench/streaming/plain_smoke.h"
#include "commands/progress.h"

namespace lapfx::bench {

namespace {

constexpr Way resident_at_screen{"resident, screen", Scheme::resident, SmokeResolution::screen};
constexpr Way resident_at_clips{"resident, clip", Scheme::resident, SmokeResolution::clip};
constexpr Way planar_way{"buffered planar", Scheme::buffered_planar, SmokeResolution::balanced};

constexpr double endless = std::numeric_limits<double>::infinity();

void compare_with_paper(const HostFrame& host, const StreamingExtent& extent, int rounds, BenchReport& report) {
    const BenchClips clips(extent.compared, extent.clip_frames);
    std::vector<StreamingRow> rows;
    double plain_screen = endless, plain_clips = endless;
    commands::Progress progress("measuring", 4 * rounds);
    for (int round = 0; round < rounds; ++round) {
        for (const Way* way : {&pipeline_way, &resident_way, &resident_at_screen, &resident_at_clips}) {
            keep_best(rows, measure(host, *way, extent.compared, clips, extent));
            progress.step();
        }
        const PlainSmoke plain(clips, extent.compared);
        std::vector<double> screen, small;
        for (int i = 0; i < extent.warm_up + extent.measured; ++i) {
            const double at_screen = plain.over_frame_ms(host), at_clips = plain.at_clip_resolution_ms(host);
            if (i >= extent.warm_up) screen.push_back(at_screen), small.push_back(at_clips);
        }
        plain_screen = std::min(plain_screen, median(screen)), plain_clips = std::min(plain_clips, median(small));
    }
    const auto row = [&](const Way& way) -> const StreamingRow& { return find(rows, way, extent.compared); };
    const auto drawing = [&](const Way& way) { return row(way).frame - row(way).sending; };
    const double sending = row(pipeline_way).sending, ours = row(resident_way).frame, paper = sending + plain_screen,
                 by_sending = sending - row(resident_way).sending,
                 by_drawing = plain_screen - drawing(resident_at_screen),
                 by_resolution = drawing(resident_at_screen) - drawing(resident_way);
    report.rows.push_back({.of = {{"smoke of 15 clips", "ms a frame"}},
                           .measured = {{"paper_sending", sending},
                                        {"paper_drawing", plain_screen},
                                        {"paper_drawing_at_clips", plain_clips},
                                        {"ours", ours},
                                        {"ours_at_screen", row(resident_at_screen).frame},
                                        {"ours_at_clips", row(resident_at_clips).frame},
                                        {"saved_by_resolution", by_resolution},
                                        {"saved_by_drawing", by_drawing},
                                        {"saved_by_sending", by_sending}}});
    report.ratios["smoke_ours_over_paper_15"] = ours / paper;
    report.ratios["smoke_ours_over_paper_same_resolution_15"] = row(resident_at_clips).frame / (sending + plain_clips);
    // Parts of the paper's frame; together 1 - smoke_ours_over_paper_15. Below 0: ours costs more there.
    report.ratios["smoke_saved_by_resolution_over_paper_15"] = by_resolution / paper;
    report.ratios["smoke_saved_by_drawing_over_paper_15"] = by_drawing / paper;
    report.ratios["smoke_saved_by_sending_over_paper_15"] = by_sending / paper;
}

void compare_not_fitting(const HostFrame& host, const StreamingExtent& extent, int rounds, BenchReport& report) {
    constexpr int distinct = 3;
    const BenchClips clips(extent.compared, extent.long_frames, distinct);
    Way ours{"resident, 10 s", Scheme::resident, SmokeResolution::balanced};
    ours.memory = extent.long_memory;
    Way paper{"pipeline, 10 s", Scheme::pipeline, SmokeResolution::screen};
    paper.memory = extent.long_memory;
    std::vector<StreamingRow> rows;
    commands::Progress progress("measuring", 2 * rounds);
    for (int round = 0; round < rounds; ++round)
        for (const Way* way : {&ours, &paper}) {
            keep_best(rows, measure(host, *way, extent.compared, clips, extent));
            progress.step();
        }
    for (const StreamingRow& row : rows) report.rows.push_back(as_bench_row(row));
    report.ratios["upload_resident_over_pipeline_15_not_fitting"] =
        find(rows, ours, extent.compared).sending / find(rows, paper, extent.compared).sending;
}

void compare_with_ffmpeg(const HostFrame& host, const StreamingExtent& extent, int rounds, BenchReport& report) {
    struct Theirs {
        const char* name;
        FfmpegGraph graph;
        FfmpegInput input;
    };
    constexpr Theirs graphs[] = {{"ffmpeg, each scaled", FfmpegGraph::each_scaled, FfmpegInput::from_memory},
                                 {"ffmpeg, scaled once", FfmpegGraph::scaled_once, FfmpegInput::from_memory},
                                 {"ffmpeg, unscaled", FfmpegGraph::unscaled, FfmpegInput::from_memory},
                                 {"ffmpeg, each scaled, decoding", FfmpegGraph::each_scaled, FfmpegInput::decoded},
                                 {"ffmpeg, scaled once, decoding", FfmpegGraph::scaled_once, FfmpegInput::decoded}};
    const BenchClips clips(extent.compared, extent.clip_frames);
    const std::set<int> numbers{std::min(5, extent.compared), extent.compared};  // the short form has one
    commands::Progress progress("measuring",
                                static_cast<int>(numbers.size()) * rounds * static_cast<int>(std::size(graphs)));
    for (const int streams : numbers) {
        std::vector<StreamingRow> rows;
        double theirs[std::size(graphs)];
        std::fill(std::begin(theirs), std::end(theirs), endless);
        for (int round = 0; round < rounds; ++round) {
            for (const Way* way : {&resident_way, &planar_way})
                keep_best(rows, measure(host, *way, streams, clips, extent));
            for (std::size_t i = 0; i < std::size(graphs); ++i) {
                if (const auto ms = ffmpeg_overlay_ms(clips, streams, graphs[i].graph, graphs[i].input))
                    theirs[i] = std::min(theirs[i], *ms);
                progress.step();
            }
        }
        for (const StreamingRow& row : rows) report.rows.push_back(as_bench_row(row));
        for (std::size_t i = 0; i < std::size(graphs); ++i)
            if (theirs[i] < endless)
                report.rows.push_back({.of = {{"scheme", graphs[i].name}, {"streams", std::to_string(streams)}},
                                       .measured = {{"frame_ms", theirs[i]}}});
        const std::string end = "_" + std::to_string(streams);
        const auto ratio = [&](const std::string& name, const Way& way, double ms) {
            if (ms < endless) report.ratios[name + end] = find(rows, way, streams).frame / ms;
        };
        ratio("smoke_ours_over_ffmpeg", resident_way, std::min(theirs[0], theirs[1]));
        ratio("smoke_ours_over_ffmpeg_each_scaled", resident_way, theirs[0]);
        ratio("smoke_ours_over_ffmpeg_unscaled", resident_way, theirs[2]);
        ratio("smoke_ours_over_ffmpeg_decoding", planar_way, std::min(theirs[3], theirs[4]));
    }
}

void compare_decoding(const HostFrame&, const StreamingExtent& extent, int rounds, BenchReport& report) {
    const BenchClips clips(extent.compared, extent.clip_frames);
    std::vector<std::filesystem::path> files;
    for (int i = 0; i < extent.compared; ++i) files.push_back(clips.path(i));
    double ours = 0, theirs = 0;
    for (int round = 0; round < rounds; ++round) {
        ours = std::max(ours, decoding_rate(files, 5));
        theirs = std::max(theirs, ffmpeg_decode_fps(clips, extent.compared).value_or(0));
    }
    report.rows.push_back({.of = {{"scheme", "decoding"}, {"streams", std::to_string(extent.compared)}},
                           .measured = {{"fps", ours}, {"ffmpeg_fps", theirs}}});
    if (theirs > 0) report.ratios["decode_over_ffmpeg"] = ours / theirs;
}

}  // namespace

std::span<const Comparison> comparisons() {
    static constexpr Comparison all[] = {
        {"smoke_ours_over_paper_15", compare_with_paper},
        {"upload_resident_over_pipeline_15_not_fitting", compare_not_fitting},
        {"smoke_ours_over_ffmpeg_15", compare_with_ffmpeg},
        {"decode_over_ffmpeg", compare_decoding},
    };
    return all;
}

}  // namespace lapfx::bench
