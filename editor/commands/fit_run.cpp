#include "commands/fit_run.h"
#include "commands/say.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <sstream>

#include "commands/options.h"
#include "commands/progress.h"
#include "lapfx/authoring/documents.h"
#include "lapfx/authoring/file.h"
#include "lapfx/context.h"
#include "match/fit/curves_file.h"
#include "match/fit/fit_colors.h"
#include "match/fit/proposal.h"
#include "match/fit/report_pictures.h"

namespace lapfx::commands {

namespace {

constexpr int progress_steps = 100;
constexpr double reference_part = 0.3;  // of the progress: measuring the reference

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
        share_ = share;
        progress_.to(share);
        return seconds() < budget_;
    }
    bool goes_on() { return to(share_); }
    double seconds() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }
    Error over(const std::string& when) const {
        std::ostringstream reason;
        reason << budget_ << " s ended before " << when << "; nothing is written";
        return {Failure::runtime, Fault{.file = "", .place = "--budget", .reason = reason.str()}};
    }

  private:
    Clock::time_point began_ = Clock::now();
    double budget_, share_ = 0.0;
    Progress progress_;
};

/// The figures of the fit; those of measuring, and pictures, are missing yet.
match::FitReport report_of(const FitOptions& o, const Scene& scene, const Window& window, const match::FitInput& input,
                           const match::FitResult& result) {
    const auto name = [](const std::filesystem::path& file) { return file.filename().string(); };
    return {.scene = name(o.files.scene),
            .reference = name(o.files.reference),
            .preset = name(o.files.preset.empty() ? scene.preset : o.files.preset),
            .fitted = name(o.files.output),
            .fitted_scene = name(o.files.fitted_scene),
            .from = window.from,
            .to = window.to,
            .seed = o.seed,
            .target = input.target,
            .result = result};
}

match::FitInput input_of(const FitOptions& o, const ShownScene& shown) {
    match::FitInput input{.start = {shown.scene, shown.presets.front()}, .seed = o.seed};
    input.parameters = match::free_parameters(input.start, keys_of(o.parameters));
    for (const match::FreeParameter& p : input.parameters)
        if (p.of_scene && o.files.fitted_scene.empty())
            throw wrong_option("--parameters", p.key + ": is the scene's, which is written with --fitted-scene only");
    return input;
}

match::Measurement measured(const FitOptions& o, VideoReader& video, const match::MeasureOptions& options,
                            Steps& steps) {
    bool in_time = true;
    try {
        return measured_video(video, o.files.reference, options, [&](double share) {
            in_time = steps.to(reference_part * share);
            return in_time;
        });
    } catch (const Error&) {
        if (in_time) throw;
        throw steps.over("the reference was measured");
    }
}

match::FitResult fitted(const FitOptions& o, match::FitInput& input, match::PreviewCurve& curve, Steps& steps) {
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

match::ColorFit color_fit(const FitOptions& o, const match::PeakColors& peaks,
                          std::span<const match::TargetPoint> target, Steps& steps) {
    match::ColorFit input{.reference = peaks.at_peak(),
                          .target = target,
                          .amidst = [&steps](double) { return steps.goes_on(); },
                          .finish = [&steps](double) { return steps.to(1.0); }};
    if (o.files.fitted_scene.empty())
        std::erase_if(input.keys, [](const std::string& key) { return match::is_color_of_scene(key); });
    return input;
}

/// Not ended by the budget: what was found is to be shown.
void add_pictures(match::FitReport& report, VideoReader& video, double aspect, const match::Tuned& before,
                  match::PreviewCurve& curve, Steps& steps) {
    match::add_pictures(
        report, video, aspect, before,
        [&curve](const match::Tuned& tuned, double time, glm::ivec2 size) {
            return curve.picture(tuned.scene, tuned.preset, time, size);
        },
        [&steps](double) {
            (void)steps.to(1.0);  // throws where it was interrupted
            return true;
        });
}

}  // namespace

std::string usual_parameters() {
    std::string all;
    for (const std::string_view key : match::usual_parameters) all.append(all.empty() ? "" : ",").append(key);
    return all;
}

void add_fit_options(CLI::App& verb, FitOptions& options, const std::string& of) {
    verb.add_option("--preset", options.files.preset, "Start from this preset instead of the one that " + of + " names")
        ->option_text("FILE.json");
    verb.add_option("--parameters", options.parameters,
                    "What may change, separated by commas; each may have bounds of its own, KEY=LOW..HIGH")
        ->option_text("KEY,...")
        ->capture_default_str();
    add_match_options(verb, options.match, "scene", "fitted");
    verb.add_flag(
        "--colors", options.colors,
        "Match the colours of blood and smoke, too, and with --fitted-scene exposure and colour of the organ");
    verb.add_option("--seed", options.seed, "Of the chance in the search and in the intervals")
        ->option_text("NUMBER")
        ->check(whole_number())
        ->capture_default_str();
    verb.add_option("--budget", options.budget,
                    "Ends after so many seconds with the best so far, or with a fault where the scene was not drawn "
                    "once until then")
        ->option_text("S")
        ->check(number_above_0())
        ->capture_default_str();
}

void check_options(const FitOptions& options) {
    const FitFiles& files = options.files;
    std::optional<ShownScene> shown;
    try {
        shown.emplace(
            open_shown(files.scene, files.preset.empty() ? std::vector<std::string>() : std::vector{files.preset}, {}));
    } catch (const Error&) {
        return;
    }
    (void)input_of(options, *shown);
}

FitRun run_fit(const FitOptions& given) {
    FitOptions o = given;
    o.match.reference = o.files.reference;
    check_names(o.files);
    const FitFiles& files = o.files;
    const ShownScene shown =
        open_shown(files.scene, files.preset.empty() ? std::vector<std::string>() : std::vector{files.preset}, {});
    check_files(files, shown);
    match::FitInput input = input_of(o, shown);
    const Window window = window_of(o.match.window, shown.scene.duration, "scene");
    VideoReader video = opened_video(files.reference);
    const SceneReference reference = reference_of(o.match, shown.scene);
    (void)common_time(o.match.reference, video, o.files.scene, window, reference.offset);
    if (shown.scene.events.empty() && files.fitted_scene.empty())
        say(o.files.scene + ": /events is empty, so nothing smokes or bleeds; with --fitted-scene tools are added");
    Steps steps(o.budget);
    match::MeasureOptions options = measure_options(o.match, reference, video.info().size);
    match::PeakColors peaks(window.from + reference.offset, window.to + reference.offset);
    if (o.colors)
        options.measured = [&peaks](Image& frame, const match::Estimator* estimator, const match::FrameAmounts& found) {
            peaks.add(frame, estimator, found);
        };
    FitRun run;
    run.measured = measured(o, video, options, steps);
    input.target =
        match::target_of(run.measured.frames, {.offset = reference.offset, .from = window.from, .to = window.to});
    if (!input.target.empty())
        note_cover(files.reference, {input.target.front().time, input.target.back().time}, window, "fitted");
    const Context context = Context::create(Backend::automatic);
    input.organ = prepare_organ(shown.scene, input.start.preset.vessels);
    const glm::ivec2 size = match::preview_size(video.info().size, reference.aspect);
    input.aspect = static_cast<double>(size.x) / size.y;
    const bool tools = !files.fitted_scene.empty();
    std::vector<std::string> proposed = match::begin_with_proposal(input, tools);
    if (tools) run.proposed = std::move(proposed);
    match::PreviewCurve curve = preview_curve(shown, input.organ, options.estimator, size);
    match::FitColors color_matching(color_fit(o, peaks, input.target, steps), curve);
    if (o.colors) input.match_colors = [&](const match::Tuned& tuned) { return color_matching.amidst(tuned); };
    match::FitResult result = fitted(o, input, curve, steps);
    if (result.proposal_left) run.proposed = {match::scene_was_nearer(shown.scene)};
    std::vector<std::string> colors;
    if (o.colors) colors = color_matching.finish(result);
    if (o.colors && files.fitted_scene.empty())
        colors.emplace_back("camera.exposure and organ.color: stay, the scene is written with --fitted-scene only");
    run.report = report_of(o, shown.scene, window, input, result);
    match::FitReport& report = run.report;
    report.colors = std::move(colors);
    report.offset = reference.offset, report.seconds = steps.seconds(), report.notes = run.measured.notes;
    if (!video.info().warning.empty()) report.notes.push_back(video.info().warning);
    if (!files.report.empty()) {
        add_pictures(report, video, reference.aspect, input.before.value_or(input.start), curve, steps);
        write_file(files.report, match::report_html(report));
    }
    if (!files.csv.empty()) write_file(files.csv, match::curves_csv(input.target, result));
    write_file(files.output, write_preset(result.tuned.preset));
    if (!files.fitted_scene.empty()) save_scene(fitted_scene(files, reference, result.tuned.scene), files.fitted_scene);
    return run;
}

}  // namespace lapfx::commands
