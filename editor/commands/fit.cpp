// lapfx fit: the values of a preset's parameters with which a scene shows as much blood and smoke as a video.
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>

#include "app/measure/measuring.h"
#include "commands/command.h"
#include "commands/options.h"
#include "commands/progress.h"
#include "commands/session.h"
#include "commands/shown_scene.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/video.h"
#include "lapfx/context.h"
#include "match/fit/curves_file.h"
#include "match/fit/fit.h"
#include "match/fit/preview_curve.h"

namespace lapfx::commands {

namespace {

constexpr int progress_steps = 100;
constexpr double reference_part = 0.3;  // of the progress: measuring the reference

/// What most videos can tell.
constexpr const char* usual_parameters =
    "bleeding.speed,bleeding.max_extent,smoke.haze.accumulation,smoke.haze.ventilation,smoke.plume.density";

struct Options {
    std::string scene, reference, preset, output, csv, window, parameters = usual_parameters;
    std::optional<double> offset, baseline;
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

struct Window {
    double from, to;
};

/// "2,8" s of the scene.
Window window_of(const std::string& text, double duration) {
    if (text.empty()) return {0.0, duration};
    Window window{};
    std::istringstream in(text);
    char comma = 0, more = 0;
    if (!(in >> window.from >> comma >> window.to) || comma != ',' || in >> more || !std::isfinite(window.from) ||
        !std::isfinite(window.to))
        throw wrong_option("--window", "\"" + text + "\" is not FROM,TO in seconds, such as 2,8");
    if (window.from < 0.0 || window.to > duration || window.from >= window.to)
        throw wrong_option("--window", "\"" + text + "\" is not a part of the scene, 0," + std::to_string(duration));
    return window;
}

/// The progress of all that is done, in one bar.
class Steps {
  public:
    explicit Steps(double budget)
        : until_(Clock::now() + std::chrono::milliseconds(static_cast<std::int64_t>(1000.0 * budget))),
          progress_("fitting", progress_steps) {}
    bool to(double share) {
        for (; done_ < static_cast<int>(share * progress_steps); ++done_) progress_.step();
        return Clock::now() < until_;
    }

  private:
    Clock::time_point until_;
    Progress progress_;
    int done_ = 0;
};

bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code none;
    return std::filesystem::equivalent(a, b, none);
}

/// What the scene says of its own reference holds for that video only.
SceneReference reference_of(const Options& o, const Scene& scene) {
    SceneReference reference;
    if (!scene.reference.file.empty() && is_same_file(scene.folder / scene.reference.file, o.reference))
        reference = scene.reference;
    if (o.offset) reference.offset = *o.offset;
    if (o.baseline) reference.measure.baseline = *o.baseline;
    return reference;
}

/// Only what lies in the window is needed, and what comes before it, for the baseline.
match::Measurement measured(const Options& o, VideoReader& video, const SceneReference& reference, Steps& steps) {
    match::MeasureOptions options = app::measure_options(reference.measure);
    try {
        return match::measure(video, options, [&](double share) {
            steps.to(reference_part * share);
            return true;
        });
    } catch (const Error& error) {
        std::vector<Fault> faults = error.faults();
        for (Fault& fault : faults)
            if (fault.file.empty()) fault.file = o.reference;
        throw Error(error.failure(), std::move(faults));
    }
}

std::string times_text(double from, double to) {
    return match::seconds_text(from) + " to " + match::seconds_text(to);
}

void note(const std::string& text) {
    std::cerr << "lapfx: " << text << '\n';
}

void tell_cover(const std::vector<match::TargetPoint>& target, const Window& window, const std::string& reference) {
    constexpr double missing = 0.5;  // s
    if (target.empty()) return;
    if (target.front().time > window.from + missing || target.back().time < window.to - missing)
        note(reference + ": covers only " + times_text(target.front().time, target.back().time) +
             " of the scene; the rest is not fitted");
}

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

void run(const Options& o) {
    const Clock::time_point began = Clock::now();
    if (std::filesystem::path(o.output).extension() != ".json")
        throw wrong_option("--output", "\"" + o.output + "\" does not end in .json");
    check_folder(o.output);
    if (!o.csv.empty()) check_folder(o.csv);
    const std::vector<std::string> chosen = o.preset.empty() ? std::vector<std::string>() : std::vector{o.preset};
    const ShownScene shown = open_shown(o.scene, chosen, {});
    match::FitInput input{.start = {shown.scene, shown.presets.front()}, .seed = o.seed};
    input.parameters = match::free_parameters(input.start, keys_of(o.parameters));
    for (const match::FreeParameter& p : input.parameters)
        if (p.of_scene) throw wrong_option("--parameters", p.key + ": is the scene's; only a preset is written");
    const Window window = window_of(o.window, shown.scene.duration);
    VideoReader video(o.reference);
    if (!video.info().warning.empty()) note(o.reference + ": " + video.info().warning);
    const SceneReference reference = reference_of(o, shown.scene);
    Steps steps(o.budget);
    const match::Measurement found = measured(o, video, reference, steps);
    for (const std::string& line : found.notes) note(o.reference + ": " + line);
    input.target = match::target_of(found.frames, {.offset = reference.offset, .from = window.from, .to = window.to});
    tell_cover(input.target, window, o.reference);
    const Context context = Context::create(Backend::automatic);
    input.organ = prepare_organ(shown.scene, input.start.preset.vessels);
    match::EstimatorOptions estimator = app::measure_options(reference.measure).estimator;
    match::PreviewCurve curve(input.organ,
                              {.clip_folders = clip_folders(), .wait_for_clips = true, .clip_cache = shown.clips},
                              estimator, match::preview_size(glm::dvec2(video.info().size)));
    double share = 0.0;
    input.draw = [&](const match::Tuned& tuned, std::span<const double> times) {
        return curve.measure(tuned.scene, tuned.preset, times, [&](double) { return steps.to(share); });
    };
    input.progress = [&](const match::FitProgress& progress) {
        share = reference_part + (1.0 - reference_part) * progress.share;
        return steps.to(share);
    };
    const match::FitResult result = match::fit(input);
    write_file(o.output, write_preset(result.tuned.preset));
    if (!o.csv.empty()) write_file(o.csv, match::curves_csv(input.target, result));
    print(result);
    std::cout << result.curves << " curves drawn, " << result.evaluations << " evaluations of the core, "
              << std::chrono::duration<double>(Clock::now() - began).count() << " s"
              << (result.ended_early ? ", ended early: the best so far" : "") << '\n';
}

}  // namespace

void add_fit(CLI::App& app) {
    auto o = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand("fit", "Find the preset that shows as much blood and smoke as a surgery video");
    verb->add_option("SCENE", o->scene, "The scene (.scene.json), whose preset it starts from")->required();
    verb->add_option("--reference", o->reference, "The video, or numbered images: frame_%04d.png")->required();
    verb->add_option("--preset", o->preset, "Start from this preset instead of the one that the scene names")
        ->option_text("FILE");
    verb->add_option("--parameters", o->parameters,
                     "What may change, separated by commas; each may have bounds of its own, KEY=LOW..HIGH")
        ->option_text("KEY,...")
        ->capture_default_str();
    verb->add_option("--offset", o->offset,
                     "Reference time = scene time + S, s; default: the scene's, where this is its reference, else 0")
        ->option_text("S")
        ->check(finite_number());
    verb->add_option("--window", o->window, "The part of the scene that is fitted, s; default: all of it")
        ->option_text("FROM,TO");
    verb->add_option("--baseline", o->baseline, "Time of a clear frame of the reference, s, as for lapfx measure")
        ->option_text("S")
        ->check(finite_number());
    verb->add_option("--seed", o->seed, "Of the chance in the search and in the intervals")->capture_default_str();
    verb->add_option("--budget", o->budget, "Ends after so many seconds, with the best so far")
        ->option_text("S")
        ->check(finite_number())
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    verb->add_option("--csv", o->csv, "Write the curves of reference, before and after to this file")
        ->option_text("FILE");
    verb->add_option("-o,--output", o->output, "The fitted preset (.json)")->option_text("FILE")->required();
    verb->footer(
        "The reference is measured (see lapfx measure), the scene is drawn off-screen and measured by the same\n"
        "estimator, and the parameters are changed until blood and veil over time are nearest. For each parameter it\n"
        "prints the value before and after, with an interval that is to hold the true one in nine of ten cases, or "
        "why\n"
        "the video does not tell it; what it does not tell keeps its value.\n\n"
        "Example:\n"
        "  lapfx fit samples/lagb.scene.json --reference samples/reference/operation.mp4 --window 0,6 "
        "-o fitted.json");
    verb->callback([o] { run(*o); });
}

}  // namespace lapfx::commands
