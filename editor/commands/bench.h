// The parts and options of `lapfx bench`: declared once, for `lapfx` and for the program that measures (tests/bench).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "commands/command_line.h"

namespace lapfx::commands {

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
    std::string labelled;             ///< folder of real frames whose blood a person labelled; none: no such frames
    std::string puffs;                ///< CSV of videos whose smoke a person timed by eye; none: no such videos
    std::string learn;                ///< file that a model of the veil is written to, learned instead; none: not
    std::string model;                ///< file of the model of the veil that is measured with; none: the shipped one
    std::string frames;               ///< CSV that each frame's figures are written to, unless empty
    bool quick = false;               ///< measures the main classes of few cases, to judge a change by
    /// Videos in which nothing bleeds, that `bench fit` fits a scene to, too.
    std::vector<std::string> bloodless;
    /// Does everything in a few seconds, for tests: it shows that the benchmark works, but its figures mean nothing.
    bool short_form = false;
};

inline constexpr int fit_cases = 24;  ///< of `bench fit`

/// `part` as in "streaming".
using RunBench = std::function<void(const std::string& part, const BenchOptions& options)>;

/// The verb with all of its parts, each of which calls `run`.
Verb bench_verb(RunBench run);

}  // namespace lapfx::commands
