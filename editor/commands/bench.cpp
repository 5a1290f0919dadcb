// lapfx bench: figures as ratios within one run.
#include "commands/bench.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "commands/command.h"
#include "commands/options.h"
#include "lapfx/authoring/file.h"
#include "lapfx/error.h"

namespace lapfx::commands {

namespace {

/// The processor's name from Linux.
std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
}

using Bench = BenchReport (*)(const BenchOptions&);

void run(Bench bench, const BenchOptions& options) {
    for (const auto& [option, file] :
         {std::pair{"--json", &options.json}, {"--plot", &options.plot}, {"--frames", &options.frames}})
        check_output(option, *file);
    BenchReport report = bench(options);
    report.short_form = options.short_form;
    print(report);
    if (!options.json.empty()) write_json(report, options.json);
}

}  // namespace

/// The comparison with Dear ImGui is a separate program next to this one, because the product links no other toolkit.
static void run_bench_ui(const BenchOptions& options) {
    check_output("--json", options.json);
    const std::filesystem::path program =
        std::filesystem::read_symlink("/proc/self/exe").parent_path() / "lapfx_bench_ui";
    if (!std::filesystem::exists(program))
        throw Error(Failure::runtime, Fault{.file = program.string(),
                                            .place = "",
                                            .reason = "not built: `bench ui` needs it; configure with LAPFX_TESTS=ON"});
    std::cout.flush();
    std::vector<const char*> arguments{program.c_str()};
    if (options.short_form) arguments.push_back("--short");
    if (!options.json.empty()) arguments.insert(arguments.end(), {"--json", options.json.c_str()});
    arguments.push_back(nullptr);
    execv(program.c_str(), const_cast<char* const*>(arguments.data()));
    throw Error(Failure::runtime, Fault{.file = program.string(), .place = "", .reason = std::strerror(errno)});
}

double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

void print(const BenchReport& report) {
    std::cout << report.bench << " on " << processor() << ", " << std::thread::hardware_concurrency() << " cores; "
              << report.renderer << "\n\n";
    if (report.short_form) std::cout << "short form: these figures show that the bench works, and nothing else\n\n";
    std::cout << report.table;
    for (const BenchRow& row : report.rows) {
        if (!report.table.empty()) break;
        for (const auto& [key, value] : row.of) std::cout << key << ' ' << std::setw(9) << std::left << value << ' ';
        std::cout << " |";
        for (const auto& [key, value] : row.measured)
            std::cout << "  " << key << ' ' << std::setw(10) << std::right << std::setprecision(4) << value;
        std::cout << '\n';
    }
    std::cout << '\n';
    for (const auto& [name, value] : report.ratios) std::cout << name << ' ' << std::setprecision(3) << value << '\n';
}

void write_json(const BenchReport& report, const std::filesystem::path& path) {
    nlohmann::json results = nlohmann::json::array();
    for (const BenchRow& row : report.rows) {
        nlohmann::json entry(row.of);
        for (const auto& [key, value] : row.measured) entry[key] = value;
        results.push_back(std::move(entry));
    }
    const nlohmann::json whole{
        {"bench", report.bench},
        {"short", report.short_form},
        {"machine",
         {{"processor", processor()}, {"cores", std::thread::hardware_concurrency()}, {"renderer", report.renderer}}},
        {"results", std::move(results)},
        {"ratios", report.ratios}};
    write_file(path, whole.dump(2) + "\n");
}

void add_bench(CLI::App& app) {
    CLI::App* verb = app.add_subcommand("bench", "Measure speed as ratios within one run");
    verb->require_subcommand(1);
    const auto add_part = [verb](const char* name, const char* help) {
        auto options = std::make_shared<BenchOptions>();
        CLI::App* part = verb->add_subcommand(name, help);
        part->group("Parts");
        part->footer("Example:\n  lapfx bench " + part->get_name() + " --short --json " + part->get_name() + ".json");
        part->add_option("--json", options->json, "Write the figures to this file, too")->option_text("FILE");
        part->add_flag("--short", options->short_form,
                       "Do all of it in seconds, to see that it works; the figures mean nothing");
        return std::pair(part, options);
    };
    const auto add = [&add_part](const char* name, const char* help, Bench bench) {
        const auto [part, options] = add_part(name, help);
        part->callback([bench, options] { run(bench, *options); });
        return std::pair(part, options);
    };
    add("bleeding", "CPU time and bytes per frame of blood on small and large organs", bench_bleeding);
    add("editor", "What the editor's panels cost compared with the scene that they show", bench_editor);
    const auto [fit, fit_options] =
        add("fit", "How well hidden presets are found again in videos of other organs, cameras and lights", bench_fit);
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
        "what the core takes of a host: memory, objects of OpenGL, threads, and the frames in which something changes",
        bench_frame);
    auto* simulation =
        frame->add_flag("--simulation", frame_options->simulation, "Measure only what is not drawn, in a few seconds");
    frame
        ->add_flag("--changes", frame_options->changes,
                   "Measure only what the core and its changes cost a host, in two minutes")
        ->excludes(simulation);
    const auto [measure, measure_options] =
        add("measure",
            "How far measured blood and smoke are from the true amounts, by class of picture, and how fast that is",
            bench_measure);
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
    const auto [ui, ui_options] = add_part("ui", "The editor's UI toolkit and Dear ImGui on the same screens");
    ui->callback([options = ui_options] { run_bench_ui(*options); });
    const auto [streaming, options] =
        add("streaming", "Smoke clips by the paper's schemes and ours, as in its table 2, and FFmpeg for comparison",
            bench_streaming);
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

}  // namespace lapfx::commands
