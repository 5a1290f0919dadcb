// lapfx fit: the values of a preset's parameters with which a scene shows as much blood and smoke as a video.
#include <chrono>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>

#include "commands/command.h"
#include "commands/fit_report.h"
#include "commands/matched_videos.h"
#include "commands/options.h"
#include "commands/progress.h"
#include "document/document.h"
#include "lapfx/authoring/documents.h"
#include "lapfx/authoring/file.h"
#include "lapfx/context.h"
#include "match/fit/curves_file.h"
#include "match/fit/fit.h"
#include "match/fit/proposal.h"

namespace lapfx::commands {

namespace {

constexpr int progress_steps = 100;
constexpr double reference_part = 0.3;  // of the progress: measuring the reference

/// What most videos can tell.
constexpr const char* usual_parameters =
    "bleeding.speed,bleeding.max_extent,smoke.haze.accumulation,smoke.haze.ventilation,smoke.plume.density";

struct Options {
    std::string scene, preset, output, fitted_scene, csv, report, parameters = usual_parameters;
    MatchOptions match;
    double budget = 600.0;
    std::uint32_t seed = 1;
};

using Clock = std::chrono::steady_clock;

std::vector<std::string> keys_of(const std::string& list) {
    std::vector<std::string> keys;
    std::istringstream parts(list);
    for (std::string key; std::getline(parts, key, ',');)
        if (!key.empty()) keys.push_back(key);
    return keys;
}

/// The progress of all that is done, in one bar.
class Steps {
  public:
    explicit Steps(double budget)
        : until_(Clock::now() + std::chrono::milliseconds(static_cast<std::int64_t>(1000.0 * budget))),
          progress_("fitting", progress_steps) {}
    bool to(double share) {
        progress_.to(share);
        return Clock::now() < until_;
    }

  private:
    Clock::time_point until_;
    Progress progress_;
};

void print_misfit(const char* name, const std::optional<double>& before, const std::optional<double>& after) {
    std::cout << name << ": ";
    if (!before || !after)
        std::cout << "not measurable\n";
    else
        std::cout << "RMS " << *before << " before, " << *after << " after\n";
}

void print(const match::FitResult& found) {
    std::cout.precision(3);
    print_misfit("blood", found.blood_before, found.blood_after);
    print_misfit("veil", found.veil_before, found.veil_after);
    for (const match::FittedParameter& p : found.parameters) {
        std::cout << p.parameter.key << ": ";
        if (!p.determined)
            std::cout << p.before << ", kept: not determined, " << p.why << '\n';
        else
            std::cout << p.before << " -> " << p.after << " (" << p.low << " to " << p.high << ")"
                      << (p.parameter.row->unit.empty() ? "" : " ") << p.parameter.row->unit
                      << (p.at_bound ? ", at its bound" : "") << '\n';
    }
}

constexpr std::string_view scene_ending = ".scene.json";

void check_fitted_scene(const Options& o) {
    if (o.fitted_scene.empty()) return;
    const auto refuse = [&](const std::string& why) {
        throw wrong_option("--fitted-scene", "\"" + o.fitted_scene + "\" " + why);
    };
    std::error_code none;
    if (!o.fitted_scene.ends_with(scene_ending)) refuse("does not end in " + std::string(scene_ending));
    if (std::filesystem::equivalent(o.fitted_scene, o.scene, none)) refuse("is the scene that is fitted");
    if (std::filesystem::weakly_canonical(o.fitted_scene, none) == std::filesystem::weakly_canonical(o.output, none))
        refuse("is the file of --output");
    check_folder(o.fitted_scene);
}

/// Events begin where the reference says, and the search goes on from there.
void begin_with_proposal(match::FitInput& input, const VideoReader& video) {
    const glm::dvec2 shape = video.info().size;
    const match::Proposal proposal =
        match::propose(input.start, input.organ, input.target, {.aspect = shape.x / shape.y});
    for (const std::string& line : proposal.lines) std::cout << line << '\n';
    input.before = std::move(input.start);
    input.start = proposal.tuned;
    for (const match::FreeParameter& p : input.parameters) p.set(input.start, p.get(input.start));  // within its bounds
}

/// With the fitted preset and the reference, as a document at its own place.
Scene fitted_scene(const Options& o, const SceneReference& reference, Scene scene) {
    const std::filesystem::path folder = document::folder_of(o.fitted_scene);
    document::move_scene(scene, folder);
    scene.preset = document::moved_path(std::filesystem::absolute(o.output).string(), {}, folder);
    scene.reference = reference;
    scene.reference.file = document::moved_path(std::filesystem::absolute(o.match.reference).string(), {}, folder);
    return scene;
}

/// The figures of the fit; those of measuring, and pictures, are missing yet.
match::FitReport report_of(const Options& o, const Scene& scene, const Window& window, const match::FitInput& input,
                           const match::FitResult& result) {
    const auto name = [](const std::filesystem::path& file) { return file.filename().string(); };
    return {.scene = name(o.scene),
            .reference = name(o.match.reference),
            .preset = name(o.preset.empty() ? scene.preset : o.preset),
            .fitted = name(o.output),
            .from = window.from,
            .to = window.to,
            .seed = o.seed,
            .target = input.target,
            .result = result};
}

void run(const Options& o) {
    const Clock::time_point began = Clock::now();
    if (std::filesystem::path(o.output).extension() != ".json")
        throw wrong_option("--output", "\"" + o.output + "\" does not end in .json");
    check_folder(o.output);
    if (!o.csv.empty()) check_folder(o.csv);
    check_fitted_scene(o);
    const std::vector<std::string> chosen = o.preset.empty() ? std::vector<std::string>() : std::vector{o.preset};
    const ShownScene shown = open_shown(o.scene, chosen, {});
    if (!o.report.empty())
        check_report(o.report,
                     files_of(shown.scene, {o.scene, o.match.reference, o.preset, o.output, o.fitted_scene, o.csv}));
    match::FitInput input{.start = {shown.scene, shown.presets.front()}, .seed = o.seed};
    input.parameters = match::free_parameters(input.start, keys_of(o.parameters));
    for (const match::FreeParameter& p : input.parameters)
        if (p.of_scene && o.fitted_scene.empty())
            throw wrong_option("--parameters", p.key + ": is the scene's, which is written with --fitted-scene only");
    const Window window = window_of(o.match.window, shown.scene.duration, "scene");
    VideoReader video = opened_video(o.match.reference);
    const SceneReference reference = reference_of(o.match, shown.scene);
    Steps steps(o.budget);
    const match::MeasureOptions options = measure_options(o.match, reference);
    const match::Measurement found =
        measured_video(video, o.match.reference, options, [&steps](double share) { steps.to(reference_part * share); });
    input.target = match::target_of(found.frames, {.offset = reference.offset, .from = window.from, .to = window.to});
    if (!input.target.empty())
        note_cover(o.match.reference, {input.target.front().time, input.target.back().time}, window, "fitted");
    const Context context = Context::create(Backend::automatic);
    input.organ = prepare_organ(shown.scene, input.start.preset.vessels);
    if (!o.fitted_scene.empty()) begin_with_proposal(input, video);
    match::PreviewCurve curve = preview_curve(shown, input.organ, options.estimator, video);
    double share = 0.0;
    input.draw = [&](const match::Tuned& tuned, std::span<const double> times) {
        return curve.measure(tuned.scene, tuned.preset, times, [&](double) { return steps.to(share); });
    };
    input.progress = [&](const match::FitProgress& progress) {
        share = reference_part + (1.0 - reference_part) * progress.share;
        return steps.to(share);
    };
    const match::FitResult result = match::fit(input);
    const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
    write_file(o.output, write_preset(result.tuned.preset));
    if (!o.fitted_scene.empty()) save_scene(fitted_scene(o, reference, result.tuned.scene), o.fitted_scene);
    if (!o.csv.empty()) write_file(o.csv, match::curves_csv(input.target, result));
    if (!o.report.empty()) {
        match::FitReport report = report_of(o, shown.scene, window, input, result);
        report.offset = reference.offset, report.seconds = seconds, report.notes = found.notes;
        if (!video.info().warning.empty()) report.notes.push_back(video.info().warning);
        add_pictures(report, video, input.before.value_or(input.start), input.organ, preview_options(shown));
        write_file(o.report, match::report_html(report));
    }
    print(result);
    std::cout << result.curves << " curves drawn, " << result.evaluations << " evaluations of the core, " << seconds
              << " s" << (result.ended_early ? ", ended early: the best so far" : "") << '\n';
}

}  // namespace

void add_fit(CLI::App& app) {
    auto o = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand("fit", "Find the preset that shows as much blood and smoke as a surgery video");
    verb->add_option("SCENE", o->scene, "The scene (.scene.json), whose preset it starts from")->required();
    verb->add_option("--reference", o->match.reference, "The video, or numbered images: frame_%04d.png")->required();
    verb->add_option("--preset", o->preset, "Start from this preset instead of the one that the scene names")
        ->option_text("FILE");
    verb->add_option("--parameters", o->parameters,
                     "What may change, separated by commas; each may have bounds of its own, KEY=LOW..HIGH")
        ->option_text("KEY,...")
        ->capture_default_str();
    add_match_options(*verb, o->match, "scene", "fitted");
    verb->add_option("--seed", o->seed, "Of the chance in the search and in the intervals")->capture_default_str();
    verb->add_option("--budget", o->budget, "Ends after so many seconds, with the best so far")
        ->option_text("S")
        ->check(finite_number())
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    verb->add_option("--fitted-scene", o->fitted_scene,
                     "First move the scene's events to when smoke and blood of the reference begin, with tools added "
                     "or silenced as it needs, and write that scene, with preset and reference, to this file")
        ->option_text("FILE.scene.json");
    verb->add_option("--csv", o->csv, "Write the curves of reference, before and after to this file")
        ->option_text("FILE");
    verb->add_option("--report", o->report,
                     "Write the result with curves, intervals and pictures as one file for a browser (.html)")
        ->option_text("FILE");
    verb->add_option("-o,--output", o->output, "The fitted preset (.json)")->option_text("FILE")->required();
    verb->footer(
        "The reference is measured (see lapfx measure), the scene is drawn off-screen and measured by the same\n"
        "estimator, and the parameters are changed until blood and veil over time are nearest. For each parameter it\n"
        "prints the value before and after, with an interval that is to hold the true one in nine of ten cases, or "
        "why\n"
        "the video does not tell it; what it does not tell keeps its value. The report needs no other file: curves,\n"
        "parameters, and frames of the reference beside the scene before and after.\n\n"
        "Example:\n"
        "  lapfx fit samples/lagb.scene.json --reference samples/reference/operation.mp4 --window 0,6 "
        "-o fitted.json --report fit.html");
    verb->callback([o] { run(*o); });
}

}  // namespace lapfx::commands
