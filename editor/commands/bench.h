// What the benches share: rows of figures, ratios with names that read alone, and the machine they were taken on;
// printed as a table and written as JSON: {"bench", "machine", "results": [...], "ratios": {...}}.
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
    std::string table;        ///< what is printed in place of the rows, unless empty
    bool short_form = false;  ///< as in BenchOptions
};

struct BenchOptions {
    std::string json;         ///< file that the figures are written to, unless empty
    std::string plot;         ///< PNG that they are drawn to, unless empty
    std::string only;         ///< ratio that alone is measured, unless empty
    bool simulation = false;  ///< nothing that is drawn is measured
    int rounds = 3;           ///< of each case; the best is kept
    /// Everything that the bench does, in a few seconds: whether it works, not what it finds. For tests.
    bool short_form = false;
};

/// Rows and ratios as text on stdout.
void print(const BenchReport& report);
/// Throws Error (runtime) when the file cannot be written.
void write_json(const BenchReport& report, const std::filesystem::path& path);

/// CPU time of the calling thread so far, s: what other threads and processes do does not count.
double thread_seconds();
double median(std::vector<double> values);

BenchReport bench_bleeding(const BenchOptions& options);
BenchReport bench_editor(const BenchOptions& options);
BenchReport bench_frame(const BenchOptions& options);
BenchReport bench_streaming(const BenchOptions& options);

}  // namespace lapfx::commands
