#include "commands/fit_run.h"
#include "commands/say.h"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>
#include <sstream>
#include <utility>

#include "commands/options.h"
#include "commands/progress.h"
#include "lapfx/authoring/documents.h"
#include "lapfx/authoring/file.h"
#include "lapfx/context.h"
#include "match/report/curves_file.h"
#include "match/use/fit_scene.h"

namespace lapfx::commands {

namespace {

constexpr int progress_steps = 100;
constexpr double reference_part = 0.3;  // measuring the reference takes this share of the progress

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

match::ReportOf names_of(const FitOptions& o, const Scene& scene) {
    const auto name = [](const std::filesystem::path& file) { return file.filename().string(); };
    return {.scene = name(o.files.scene),
            .reference = name(o.files.reference),
            .preset = name(o.files.preset.empty() ? scene.preset : o.files.preset),
            .fitted = name(o.files.output),
            .fitted_scene = name(o.files.fitted_scene)};
}

match::SceneFit fit_of(const FitOptions& o, const ShownScene& shown) {
    match::SceneFit fit{.start = {shown.scene, shown.presets.front()},
                        .keys = keys_of(o.parameters),
                        .tools = !o.files.fitted_scene.empty(),
                        .seed = o.seed,
                        .colors = o.colors ? match::ColorsOfFit::match : match::ColorsOfFit::leave};
    for (const match::FreeParameter& p : match::free_parameters(fit.start, fit.keys))
        if (p.of_scene && !fit.tools)
            throw wrong_option("--parameters", p.key + ": is the scene's, which is written with --fitted-scene only");
    if (!fit.tools) std::erase_if(fit.color_keys, [](const auto& key) { return match::is_color_of_scene(key); });
    return fit;
}

/// `part`: of the video, whose colours are wanted.
match::MeasuredVideo measured(const FitOptions& o, VideoReader& video, const match::MeasureOptions& options,
                              const match::VideoPart& part, Steps& steps) {
    bool in_time = true;
    match::VideoMeasuring how{.options = options};
    if (o.colors) how.colors_of = part;
    try {
        return measured_video(video, o.files.reference, std::move(how), [&](double share) {
            in_time = steps.to(reference_part * share);
            return in_time;
        });
    } catch (const Error&) {
        if (in_time) throw;
        throw steps.over("the reference was measured");
    }
}

match::FittedScene fitted(const FitOptions& o, const match::SceneFit& fit, match::PreviewCurve& curve, Steps& steps) {
    const auto reached = [&steps](double share) { return steps.to(std::lerp(reference_part, 1.0, share)); };
    try {
        match::FittedScene found = match::fit_scene(fit, curve, {.progress = reached});
        if (found.result->after.empty()) throw steps.over("the scene was drawn");
        return found;
    } catch (const Error& error) {
        throw error.failure() == Failure::bad_input ? at_file(o.files.scene, error) : error;
    }
}

}  // namespace

std::string usual_parameters() {
    std::string all;
    for (const std::string_view key : match::usual_parameters) all.append(all.empty() ? "" : ",").append(key);
    return all;
}

void add_fit_options(Verb& verb, FitOptions& options, const std::string& of) {
    verb.option("--preset", "FILE.json", "Start from this preset instead of the one that " + of + " names",
                &options.files.preset);
    verb.option("--parameters", "KEY,...",
                "What may change, separated by commas; each may have bounds of its own, KEY=LOW..HIGH",
                &options.parameters, {.shows_default = true});
    add_match_options(verb, options.match, "scene", "fitted");
    verb.flag("--colors",
              "Match the colours of blood and smoke, too, and with --fitted-scene exposure and colour of the organ",
              &options.colors);
    verb.option("--seed", "NUMBER", "Of the chance in the search and in the intervals", &options.seed,
                {.shows_default = true, .number = Number::whole});
    verb.option("--budget", "S",
                "Ends after so many seconds with the best so far, or with a fault where the scene was not drawn "
                "once until then",
                &options.budget, {.shows_default = true, .number = Number::above_0});
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
    (void)fit_of(options, *shown);
}

FitRun run_fit(const FitOptions& given) {
    FitOptions o = given;
    o.match.reference = o.files.reference;
    check_names(o.files);
    const FitFiles& files = o.files;
    const ShownScene shown =
        open_shown(files.scene, files.preset.empty() ? std::vector<std::string>() : std::vector{files.preset}, {});
    check_files(files, shown);
    match::SceneFit fit = fit_of(o, shown);
    const Window window = window_of(o.match.window, shown.scene.duration, "scene");
    VideoReader video = opened_video(files.reference);
    const SceneReference reference = reference_of(o.match, shown.scene);
    (void)common_time(o.match.reference, video, o.files.scene, window, reference.offset);
    if (shown.scene.events.empty() && files.fitted_scene.empty())
        say(o.files.scene + ": /events is empty, so nothing smokes or bleeds; with --fitted-scene tools are added");
    Steps steps(o.budget);
    const match::MeasureOptions options = measure_options(o.match, reference, video.info().size, files.scene);
    match::MeasuredVideo of_reference =
        measured(o, video, options, {window.from + reference.offset, window.to + reference.offset}, steps);
    FitRun run;
    run.measured = std::move(of_reference.found);
    fit.reference = run.measured.frames, fit.reference_colors = of_reference.colors;
    fit.offset = reference.offset, fit.from = window.from, fit.to = window.to;
    if (const std::vector<match::TargetPoint> target = match::target_of(fit); !target.empty())
        note_cover(files.reference, {target.front().time, target.back().time}, window, "fitted");
    const Context context = Context::create(Backend::automatic);
    fit.organ = prepare_organ(shown.scene, fit.start.preset.vessels);
    const match::PreviewCurve::Options drawn =
        match::PreviewCurve::options_for(video.info().size, reference.aspect, options.estimator);
    fit.aspect = static_cast<double>(drawn.size.x) / drawn.size.y;
    match::PreviewCurve curve = preview_curve(shown, fit.organ, drawn);
    curve.count_plate_by(match::painted_blood(run.measured));
    match::FittedScene found = fitted(o, fit, curve, steps);
    if (o.colors && files.fitted_scene.empty())
        found.colors.emplace_back(
            "camera.exposure and organ.color: stay, the scene is written with --fitted-scene only");
    match::ReportOf of = names_of(o, shown.scene);
    of.seconds = steps.seconds(), of.notes = run.measured.notes;
    match::FitReport& report = run.report;
    report = {.of = std::move(of), .found = std::move(found)};
    const match::FitResult& result = *report.found.result;
    if (!video.info().warning.empty()) report.of.notes.push_back(video.info().warning);
    if (!files.report.empty()) {
        match::add_pictures(report, video, reference.aspect, curve, [&steps](double) {
            (void)steps.to(1.0);  // throws where it was interrupted
            return true;          // the budget does not end this: what was found is to be shown
        });
        write_file(files.report, match::report_html(report));
    }
    if (!files.csv.empty()) write_file(files.csv, match::curves_csv(report.found.target, result));
    write_file(files.output, write_preset(result.tuned.preset));
    if (!files.fitted_scene.empty()) save_scene(fitted_scene(files, reference, result.tuned.scene), files.fitted_scene);
    return run;
}

}  // namespace lapfx::commands
