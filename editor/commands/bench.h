// Shared by the benchmarks: rows of figures, ratios whose names explain themselves, and the machine. They are printed
// as a table and written as JSON: {"bench", "machine", "results": [...], "ratios": {...}}.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lapfx/context.h"

namespace lapfx::commands {

struct BenchRow {
    std::map<std::string, std::string> of;   ///< what was measured: {"wounds", "10"}
    std::map<std::string, double> measured;  ///< figures, units in their names: {"cpu_us_mean", 31.0}
};

struct BenchReport {
    std::string bench;
    std::string renderer;  ///< GL_RENDERER
    std::vector<BenchRow> rows;
    std::map<std::string, double> ratios;
    std::string table;        ///< printed instead of the rows, unless empty
    bool short_form = false;  ///< as in BenchOptions
};

struct BenchOptions {
    std::string json;                 ///< file that the figures are written to, unless empty
    std::string plot;                 ///< PNG that they are drawn to, unless empty
    std::string only;                 ///< the only ratio that is measured, unless empty
    bool simulation = false;          ///< measures only what is not drawn
    bool changes = false;             ///< measures only what the core and its changes cost a host
    int rounds = 3;                   ///< rounds of each case; the best counts
    int seed = 2;                     ///< of what is drawn at random
    int first = 1, last = 1'000'000;  ///< cases that are measured, from 1 on
    std::vector<std::string> pairs;   ///< two folders of recordings, ranked instead of renders; none: renders
    std::vector<std::string> over;    ///< videos and pictures of clear tissue that known amounts are laid over
    std::string learn;                ///< file that a model of the veil is written to, learned instead; none: not
    std::string model;                ///< file of the model of the veil that is measured with; none: the shipped one
    std::string frames;               ///< CSV that each frame's figures are written to, unless empty
    /// Does everything in a few seconds, for tests: it shows that the benchmark works, but its figures mean nothing.
    bool short_form = false;
};

inline constexpr int fit_cases = 24;  ///< of bench_fit

/// Rows and ratios as text on stdout.
void print(const BenchReport& report);
/// Throws Error (runtime) when the file cannot be written.
void write_json(const BenchReport& report, const std::filesystem::path& path);

/// CPU time of the calling thread so far, s, without other threads and processes.
double thread_seconds();
double median(std::vector<double> values);

BenchReport bench_bleeding(const BenchOptions& options);
BenchReport bench_editor(const BenchOptions& options);
BenchReport bench_fit(const BenchOptions& options);
BenchReport bench_frame(const BenchOptions& options);
BenchReport bench_measure(const BenchOptions& options);
BenchReport bench_measure_pairs(const BenchOptions& options);
BenchReport bench_measure_learn(const BenchOptions& options);
BenchReport bench_streaming(const BenchOptions& options);

}  // namespace lapfx::commands
