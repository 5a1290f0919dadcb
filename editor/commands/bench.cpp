// lapfx bench: figures as ratios within one run. What measures is a program of its own, lapfx_bench (tests/bench), so
// that the product is built without it.
#include "commands/bench.h"

#include <memory>
#include <utility>

#include "commands/command.h"
#include "commands/options.h"
#include "commands/start_beside.h"

namespace lapfx::commands {

Verb bench_verb(RunBench run) {
    Verb verb{.name = "bench",
              .help = "Measure speed as ratios within one run",
              .footer = "tests/bench/README.md has the figures, and what each ratio compares."};
    const auto made = [&run](const std::string& name, const char* help) {
        const auto options = std::make_shared<BenchOptions>();
        Verb part{.name = name,
                  .help = help,
                  .footer = "Example:\n  lapfx bench " + name + " --short --json " + name + ".json",
                  .run = [run, name, options] { run(name, *options); }};
        part.option("--json", "FILE", "Write the figures to this file, too", &options->json);
        part.flag("--short", "Do all of it in seconds, to see that it works; the figures mean nothing",
                  &options->short_form);
        return std::pair(std::move(part), options);
    };
    const auto add = [&verb](Verb part) { verb.parts.push_back(std::move(part)); };
    add(made("bleeding", "CPU time and bytes per frame of blood on small and large organs").first);
    add(made("editor", "What the editor's panels cost compared with the scene that they show").first);
    auto [fit, fit_options] =
        made("fit", "How well hidden presets are found again in videos of other organs, cameras and lights");
    fit.option("--seed", "NUMBER", "Seed of what is drawn at random: the same seed gives the same figures",
               &fit_options->seed, {.shows_default = true, .range = Range{0, 1'000'000}});
    const auto add_case = [&part = fit](const char* name, int& value, const char* help) {
        part.option(name, "NUMBER", help, &value, {.range = Range{1, fit_cases}});
    };
    add_case("--first", fit_options->first, "Begin with this case");
    add_case("--last", fit_options->last, "End with this case");
    fit.flag("--quick",
             "Fit only the first four cases, by turns from another view and from the same, from smaller pictures at a "
             "third of the times, to judge a change by",
             &fit_options->quick, {.excludes = {"--short", "--first", "--last"}});
    fit.option("--bloodless", "FILE...",
               "Fit one of the scenes to these videos, too, in which nothing bleeds: how many of the fits leave "
               "bleeding as it is",
               &fit_options->bloodless);
    add(std::move(fit));
    auto [frame, frame_options] = made(
        "frame",
        "What 15 smoke clips add to a frame, how much they delay a haptic thread, what blood and wounds cost, and "
        "what the core takes of a host: memory, objects of OpenGL, threads, and the frames in which something changes");
    frame.flag("--simulation", "Measure only what is not drawn, in a few seconds", &frame_options->simulation);
    frame.flag("--changes", "Measure only what the core and its changes cost a host, in two minutes",
               &frame_options->changes, {.excludes = {"--simulation"}});
    add(std::move(frame));
    auto [measure, measure_options] =
        made("measure",
             "How far measured blood and smoke are from the true amounts, by class of picture, and how fast that is");
    measure.option("--seed", "NUMBER", "Seed of what is drawn at random: the same seed gives the same figures",
                   &measure_options->seed, {.shows_default = true, .range = Range{0, 1'000'000}});
    measure.option("--frames", "FILE", "Write the figures of each picture to this CSV", &measure_options->frames);
    measure.option("--over", "FILE...",
                   "Lay known smoke and blood over these videos and pictures of clear tissue, too. Files of one folder "
                   "whose names are the same up to the last _ count as one operation, and one at a time is left out",
                   &measure_options->over);
    measure.option("--labelled", "FOLDER",
                   "Measure real frames whose blood a person labelled, too: frame_S_0.png before the bleeding of "
                   "sequence S, its baseline; frame_S_N.png later, with its blood white in blood_S_N.png",
                   &measure_options->labelled);
    measure.option(
        "--puffs", "FILE",
        "Measure videos with a puff of smoke, too, whose times a person told by eye: how far onset, peak and "
        "end of the measured veil are from those. CSV with the columns video,onset,peak,end: the path from "
        "its folder, and s, empty where unknown; the end is when half of the peak is gone",
        &measure_options->puffs);
    measure.flag("--quick",
                 "Measure the main classes in two or three minutes: a tenth of the renders, half as "
                 "many pictures over each file, and not how fast that is",
                 &measure_options->quick, {.excludes = {"--short"}});
    measure.option("--pairs", "SMOKY CLEAR",
                   "Rank real recordings instead: pictures and videos with smoke in the first folder, the same with "
                   "less of it in the second, paired in the order of their names",
                   &measure_options->pairs,
                   {.count = 2, .excludes = {"--seed", "--over", "--labelled", "--puffs", "--quick", "--frames"}});
    measure.option("--learn", "FILE",
                   "Learn the model of the mean veil from the renders of this seed instead (with --over, over those "
                   "files), and write it; the shipped one is editor/match/veil_model.json",
                   &measure_options->learn, {.excludes = {"--frames", "--pairs", "--labelled", "--puffs", "--quick"}});
    measure.option("--model", "FILE", "Measure with this model of the mean veil", &measure_options->model,
                   {.excludes = {"--learn", "--pairs"}});
    add(std::move(measure));
    add(made("ui", "The editor's UI toolkit and Dear ImGui on the same screens").first);
    auto [streaming, options] =
        made("streaming", "Smoke clips by the paper's schemes and ours, as in its table 2, and FFmpeg for comparison");
    streaming.option("--plot", "FILE", "Draw the panels of the paper's figure 10 into this PNG", &options->plot);
    streaming.option("--only", "RATIO", "Measure this ratio alone, in about a minute", &options->only,
                     {.excludes = {"--plot"}});
    streaming.option("--rounds", "NUMBER", "How often each case is measured, 1 to 20; the best counts",
                     &options->rounds, {.shows_default = true, .range = Range{1, 20}});
    add(std::move(streaming));
    return verb;
}

Verb bench_verb() {
    return bench_verb([](const std::string&, const BenchOptions&) { start_program_of("bench"); });
}

}  // namespace lapfx::commands
