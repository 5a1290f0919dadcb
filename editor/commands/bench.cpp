// lapfx bench: figures as ratios within one run. What measures is a program of its own, lapfx_bench (tests/bench), so
// that the product is built without it.
#include "commands/bench.h"

#include <memory>
#include <utility>

#include "commands/command.h"
#include "commands/options.h"
#include "commands/start_beside.h"

namespace lapfx::commands {

void declare_bench(CLI::App& app, RunBench run) {
    CLI::App* verb = app.add_subcommand("bench", "Measure speed as ratios within one run");
    verb->require_subcommand(1);
    const auto add = [verb, run = std::move(run)](const char* name, const char* help) {
        auto options = std::make_shared<BenchOptions>();
        CLI::App* part = verb->add_subcommand(name, help);
        part->group("Parts");
        part->footer("Example:\n  lapfx bench " + part->get_name() + " --short --json " + part->get_name() + ".json");
        part->add_option("--json", options->json, "Write the figures to this file, too")->option_text("FILE");
        part->add_flag("--short", options->short_form,
                       "Do all of it in seconds, to see that it works; the figures mean nothing");
        part->callback([run, name, options] { run(name, *options); });
        return std::pair(part, options);
    };
    add("bleeding", "CPU time and bytes per frame of blood on small and large organs");
    add("editor", "What the editor's panels cost compared with the scene that they show");
    const auto [fit, fit_options] =
        add("fit", "How well hidden presets are found again in videos of other organs, cameras and lights");
    fit->add_option("--seed", fit_options->seed,
                    "Seed of what is drawn at random: the same seed gives the same figures")
        ->option_text("NUMBER")
        ->check(CLI::Range(0, 1'000'000))
        ->capture_default_str();
    const auto add_case = [part = fit](const char* name, int& value, const char* help) {
        part->add_option(name, value, help)->option_text("NUMBER")->check(CLI::Range(1, fit_cases));
    };
    add_case("--first", fit_options->first, "Begin with this case");
    add_case("--last", fit_options->last, "End with this case");
    const auto [frame, frame_options] = add(
        "frame",
        "What 15 smoke clips add to a frame, how much they delay a haptic thread, what blood and wounds cost, and "
        "what the core takes of a host: memory, objects of OpenGL, threads, and the frames in which something changes");
    auto* simulation =
        frame->add_flag("--simulation", frame_options->simulation, "Measure only what is not drawn, in a few seconds");
    frame
        ->add_flag("--changes", frame_options->changes,
                   "Measure only what the core and its changes cost a host, in two minutes")
        ->excludes(simulation);
    const auto [measure, measure_options] =
        add("measure",
            "How far measured blood and smoke are from the true amounts, by class of picture, and how fast that is");
    measure
        ->add_option("--seed", measure_options->seed,
                     "Seed of what is drawn at random: the same seed gives the same figures")
        ->option_text("NUMBER")
        ->check(CLI::Range(0, 1'000'000))
        ->capture_default_str();
    measure->add_option("--frames", measure_options->frames, "Write the figures of each picture to this CSV")
        ->option_text("FILE");
    measure
        ->add_option(
            "--over", measure_options->over,
            "Lay known smoke and blood over these videos and pictures of clear tissue, too. Files of one folder "
            "whose names are the same up to the last _ count as one operation, and one at a time is left out")
        ->option_text("FILE...")
        ->expected(1, -1);
    measure
        ->add_option("--pairs", measure_options->pairs,
                     "Rank real recordings instead: pictures and videos with smoke in the first folder, the same with "
                     "less of it in the second, paired in the order of their names")
        ->option_text("SMOKY CLEAR")
        ->expected(2)
        ->excludes("--seed")
        ->excludes("--over")
        ->excludes("--frames");
    measure
        ->add_option("--learn", measure_options->learn,
                     "Learn the model of the mean veil from the renders of this seed instead (with --over, over those "
                     "files), and write it; the shipped one is editor/match/veil_model.json")
        ->option_text("FILE")
        ->excludes("--frames")
        ->excludes("--pairs");
    measure->add_option("--model", measure_options->model, "Measure with this model of the mean veil")
        ->option_text("FILE")
        ->excludes("--learn")
        ->excludes("--pairs");
    add("ui", "The editor's UI toolkit and Dear ImGui on the same screens");
    const auto [streaming, options] =
        add("streaming", "Smoke clips by the paper's schemes and ours, as in its table 2, and FFmpeg for comparison");
    streaming->add_option("--plot", options->plot, "Draw the panels of the paper's figure 10 into this PNG")
        ->option_text("FILE");
    streaming->add_option("--only", options->only, "Measure this ratio alone, in about a minute")
        ->option_text("RATIO")
        ->excludes("--plot");
    streaming->add_option("--rounds", options->rounds, "How often each case is measured, 1 to 20; the best counts")
        ->option_text("NUMBER")
        ->check(CLI::Range(1, 20))
        ->capture_default_str();
    verb->footer("tests/bench/README.md has the figures, and what each ratio compares.");
}

void add_bench(CLI::App& app) {
    declare_bench(app, [](const std::string&, const BenchOptions&) { start_program_of("bench"); });
}

}  // namespace lapfx::commands
