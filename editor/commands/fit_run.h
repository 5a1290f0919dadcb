// One fit from its files to its files: what lapfx fit does, and lapfx batch for each of its items.
#pragma once

#include <cstdint>
#include <string>

#include "commands/command_line.h"
#include "commands/fit_files.h"
#include "commands/matched_videos.h"
#include "match/report/report.h"
#include "match/video/measure.h"

namespace lapfx::commands {

/// match::usual_parameters, separated by commas.
std::string usual_parameters();

struct FitOptions {
    FitFiles files = {};
    std::string parameters = usual_parameters();  ///< keys, separated by commas
    MatchOptions match = {};                      ///< without its reference
    bool colors = false;                          ///< are matched, once the amounts are fitted
    double budget = 600.0;                        ///< s
    std::uint32_t seed = 1;
};
/// --preset, --parameters, those of add_match_options(), --colors, --seed and --budget. `of`: what names the preset
/// that is replaced, "the scene".
void add_fit_options(Verb& verb, FitOptions& options, const std::string& of);

struct FitRun {
    match::FitReport report;      ///< with pictures only where a report was written
    match::Measurement measured;  ///< the reference
};

/// What is wrong with the options themselves, as far as the scene can be opened: else that is the scene's fault.
void check_options(const FitOptions& options);

/// Measures, fits and writes the files. Progress and notes go to stderr. Makes an OpenGL context. Throws Error:
/// bad_input for options and files, runtime where the budget ends before anything was drawn, it was interrupted or a
/// file cannot be written, no_gl.
FitRun run_fit(const FitOptions& options);

}  // namespace lapfx::commands
