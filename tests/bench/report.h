// Shared by the benchmarks: rows of figures, ratios whose names explain themselves, and the machine. They are printed
// as a table and written as JSON: {"bench", "machine", "results": [...], "ratios": {...}}.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "commands/bench.h"
#include "lapfx/context.h"

namespace lapfx::bench {

using commands::BenchOptions;

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
    bool short_form = false;  ///< BenchOptions::short_form
};

/// Rows and ratios as text on stdout.
void print(const BenchReport& report);
/// Throws Error (runtime) when the file cannot be written.
void write_json(const BenchReport& report, const std::filesystem::path& path);

/// CPU time of the calling thread so far, s, without other threads and processes.
double thread_seconds();
double median(std::vector<double> values);

}  // namespace lapfx::bench
