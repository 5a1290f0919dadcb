// lapfx fit: the values of a preset's parameters with which a scene shows as much blood and smoke as a video.
#include <chrono>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>

#include "commands/command.h"
#include "commands/fit_colors.h"
#include "commands/fit_files.h"
#include "commands/fit_report.h"
#include "commands/matched_videos.h"
#include "commands/options.h"
#include "commands/progress.h"
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
    FitFiles files;
    std::string parameters = usual_parameters;
    MatchOptions match;  ///< match.reference is files.reference
    bool colors = false;
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
    explicit Steps(double budget) : budget_(budget), progress_("fitting", progress_steps) {}
    /// False: the time is over.
    bool to(double share) {
        progress_.to(share);
        return seconds() < budget_;
    }
    double seconds() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }
    Error over(const std::string& when) const {
        std::ostringstream reason;
        reason << budget_ << " s ended before " << when << "; nothing is written";
        return {Failure::runtime, Fault{.file = "", .place = "--budget", .reason = reason.str()}};
    }

  private:
    Clock::time_point began_ = Clock::now();
    double budget_;
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
            std::cout << p.after << (p.after == p.before ? ", kept" : "") << ": not determined, " << p.why << '\n';
        else
            std::cout << p.before << " -> " << p.after << " (" << p.low << " to " << p.high << ")"
                      << (p.parameter.row->unit.empty() ? "" : " ") << p.parameter.row->unit
                      << (p.at_bound ? ", at its bound" : "") << '\n';
    }
}

/// Events begin where the reference says, and the search goes on from there.
void begin_with_proposal(match::FitInput& input) {
    std::vector<std::string> keys;
    for (const match::FreeParameter& p : input.parameters) keys.push_back(p.key);
    const match::Proposal proposal =
        match::propose(input.start, input.organ, input.target, {.aspect = input.aspect, .keys = keys});
    for (const std::string& line : proposal.lines) std::cout << line << '\n';
    input.before = std::move(input.start);
    input.start = proposal.tuned;
    for (const match::FreeParameter& p : input.parameters) p.set(input.start, p.get(input.start));  // within its bounds
}

/// The figures of the fit; those of measuring, and pictures, are missing yet.
match::FitReport report_of(const Options& o, const Scene& scene, const Window& window, const match::FitInput& input,
                           const match::FitResult& result) {
    const auto name = [](const std::filesystem::path& file) { return file.filename().string(); };
    return {.scene = name(o.files.scene),
            .reference = name(o.match.reference),
            .preset = name(o.files.preset.empty() ? scene.preset : o.files.preset),
            .fitted = name(o.files.output),
            .from = window.from,
            .to = window.to,
            .seed = o.seed,
            .target = input.target,
            .result = result};
}

match::FitInput input_of(const Options& o, const ShownScene& shown) {
    match::FitInput input{.start = {shown.scene, shown.presets.front()}, .seed = o.seed};
    input.parameters = match::free_parameters(input.start, keys_of(o.parameters));
    for (const match::FreeParameter& p : input.parameters)
        if (p.of_scene && o.files.fitted_scene.empty())
            throw wrong_option("--parameters", p.key + ": is the scene's, which is written with --fitted-scene only");
    return input;
}

match::Measurement measured(const Options& o, VideoReader& video, const match::MeasureOptions& options, Steps& steps) {
    bool in_time = true;
    try {
        return measured_video(video, o.match.reference, options, [&](double share) {
            in_time = steps.to(reference_part * share);
            return in_time;
        });
    } catch (const Error&) {
        if (in_time) throw;
        throw steps.over("the reference was measured");
    }
}

match::FitResult fitted(const Options& o, match::FitInput& input, match::PreviewCurve& curve, Steps& steps) {
    double share = reference_part;
    input.draw = [&](const match::Tuned& tuned, std::span<const double> times) {
        return curve.measure(tuned.scene, tuned.preset, times, {.progress = [&](double) { return steps.to(share); }});
    };
    input.progress = [&](const match::FitProgress& progress) {
        share = reference_part + (1.0 - reference_part) * progress.share;
        return steps.to(share);
    };
    try {
        match::FitResult result = match::fit(input);
        if (result.after.empty()) throw steps.over("the scene was drawn");
        return result;
    } catch (const Error& error) {
        throw error.failure() == Failure::bad_input ? at_file(o.files.scene, error) : error;
    }
}

void run(const Options& o) {
    check_names(o.files);
    const FitFiles& files = o.files;
    const ShownScene shown =
        open_shown(files.scene, files.preset.empty() ? std::vector<std::string>() : std::vector{files.preset}, {});
    check_files(files, shown);
    match::FitInput input = input_of(o, shown);
    const Window window = window_of(o.match.window, shown.scene.duration, "scene");
    VideoReader video = opened_video(files.reference);
    const SceneReference reference = reference_of(o.match, shown.scene);
    Steps steps(o.budget);
    match::MeasureOptions options = measure_options(o.match, reference);
    match::PeakColors peaks(window.from + reference.offset, window.to + reference.offset);
    if (o.colors) watch_colors(options, peaks);
    const match::Measurement found = measured(o, video, options, steps);
    input.target = match::target_of(found.frames, {.offset = reference.offset, .from = window.from, .to = window.to});
    if (!input.target.empty())
        note_cover(files.reference, {input.target.front().time, input.target.back().time}, window, "fitted");
    const Context context = Context::create(Backend::automatic);
    input.organ = prepare_organ(shown.scene, input.start.preset.vessels);
    const glm::ivec2 size = match::preview_size(video.info().size, reference.aspect);
    input.aspect = static_cast<double>(size.x) / size.y;
    if (!files.fitted_scene.empty()) begin_with_proposal(input);
    match::PreviewCurve curve = preview_curve(shown, input.organ, options.estimator, size);
    match::FitResult result = fitted(o, input, curve, steps);
    std::vector<std::string> colors;
    if (o.colors)
        colors = fit_colors(result, peaks, input.target, curve, !files.fitted_scene.empty(),
                            [&](double) { return steps.to(1.0); });
    const double seconds = steps.seconds();
    if (!files.report.empty()) {
        match::FitReport report = report_of(o, shown.scene, window, input, result);
        report.offset = reference.offset, report.seconds = seconds, report.notes = found.notes;
        report.colors = colors;
        if (!video.info().warning.empty()) report.notes.push_back(video.info().warning);
        add_pictures(report, video, input.before.value_or(input.start), input.organ, preview_options(shown));
        write_file(files.report, match::report_html(report));
    }
    if (!files.csv.empty()) write_file(files.csv, match::curves_csv(input.target, result));
    write_file(files.output, write_preset(result.tuned.preset));
    if (!files.fitted_scene.empty()) save_scene(fitted_scene(files, reference, result.tuned.scene), files.fitted_scene);
    print(result);
    for (const std::string& line : colors) std::cout << line << '\n';
    std::cout << "curves drawn: " << result.curves << ", evaluations of the core: " << result.evaluations << ", "
              << seconds << " s" << (result.ended_early ? ", ended early: the best so far" : "") << '\n';
}

}  // namespace

void add_fit(CLI::App& app) {
    auto o = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand("fit", "Find the preset that shows as much blood and smoke as a surgery video");
    verb->add_option("SCENE", o->files.scene, "The scene (.scene.json), whose preset it starts from")->required();
    verb->add_option("--reference", o->files.reference, "The video, or numbered images: frame_%04d.png")
        ->option_text("VIDEO")
        ->required();
    verb->add_option("--preset", o->files.preset, "Start from this preset instead of the one that the scene names")
        ->option_text("FILE");
    verb->add_option("--parameters", o->parameters,
                     "What may change, separated by commas; each may have bounds of its own, KEY=LOW..HIGH")
        ->option_text("KEY,...")
        ->capture_default_str();
    add_match_options(*verb, o->match, "scene", "fitted");
    verb->add_flag("--colors", o->colors,
                   "Then match the colours of blood and smoke, and with --fitted-scene the exposure");
    verb->add_option("--seed", o->seed, "Of the chance in the search and in the intervals")
        ->option_text("NUMBER")
        ->capture_default_str();
    verb->add_option("--budget", o->budget, "Ends after so many seconds, with the best so far")
        ->option_text("S")
        ->check(finite_number())
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    verb->add_option("--fitted-scene", o->files.fitted_scene,
                     "First move the scene's events to when smoke and blood of the reference begin, with tools added "
                     "or silenced as it needs, and write that scene, with preset and reference, to this file")
        ->option_text("FILE.scene.json");
    verb->add_option("--csv", o->files.csv, "Write the curves of reference, before and after to this file")
        ->option_text("FILE");
    verb->add_option("--report", o->files.report,
                     "Write the result with curves, intervals and pictures as one file for a browser (.html)")
        ->option_text("FILE");
    verb->add_option("-o,--output", o->files.output, "The fitted preset (.json)")->option_text("FILE")->required();
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
    verb->callback([o] {
        o->match.reference = o->files.reference;
        run(*o);
    });
}

}  // namespace lapfx::commands
