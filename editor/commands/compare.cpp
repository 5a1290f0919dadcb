// lapfx compare: how close the blood and smoke of a scene, or of a video, are to those of a surgery video.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "commands/at_most.h"
#include "commands/command.h"
#include "commands/file_kind.h"
#include "commands/matched_videos.h"
#include "commands/options.h"
#include "commands/progress.h"
#include "lapfx/authoring/file.h"
#include "lapfx/context.h"
#include "match/fit/target.h"
#include "match/use/compare_scene.h"
#include "match/use/measure_video.h"
#include "output/files.h"

namespace lapfx::commands {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int progress_steps = 100;
constexpr double reference_part = 0.5;  // measuring the reference takes this share of the progress
constexpr int format_version = 1;

struct Options {
    std::string shown, preset, json;  ///< `shown`: the scene or video that is held against the reference
    std::vector<std::string> settings, at_most;
    MatchOptions match;
};

struct ComparedFiles {
    match::Compared compared;
    double offset = 0.0;  ///< s
    Window window = {};   ///< s of the scene or video that is held against the reference
    bool of_scene = false;
};

Error refused(const std::string& file, const std::string& reason) {
    return {Failure::bad_input, Fault{.file = file, .place = "", .reason = reason}};
}

void check_json(const Options& o) {
    if (!o.json.empty() && fs::path(o.json).extension() != ".json")
        throw wrong_option("--json", "\"" + o.json + "\" does not end in .json");
    check_output("--json", o.json);
}

bool any_measurable(std::span<const match::FrameAmounts> frames, const Window& times) {
    return std::ranges::any_of(frames, [&times](const match::FrameAmounts& frame) {
        return frame.time >= times.from && frame.time <= times.to && frame.measurable();
    });
}

void require_measurable(std::span<const match::FrameAmounts> frames, const Window& times, const std::string& file) {
    if (any_measurable(frames, times)) return;
    throw refused(file, "has no frame that is measurable between " + match::seconds_text(times.from) + " and " +
                            match::seconds_text(times.to) + ", where it is compared");
}

/// `times`: s of the video, where it is compared.
match::MeasuredVideo measured(VideoReader& video, const std::string& file, const match::MeasureOptions& options,
                              const Window& times, const lapfx::Progress& progress) {
    match::MeasuredVideo measured = measured_video(
        video, file, {.options = options, .colors_of = match::VideoPart{times.from, times.to}}, progress);
    require_measurable(measured.found.frames, times, file);
    return measured;
}

/// The scene, held against the reference.
match::ComparedScene draw(const Options& o, const match::SceneToCompare& what, match::PreviewCurve& curve,
                          Progress& progress) {
    const auto reached = [&progress](double share) {
        progress.to(reference_part + (1.0 - reference_part) * share);
        return true;
    };
    try {
        match::ComparedScene drawn = *match::compare_scene(what, curve, reached);  // never stopped by `reached`
        require_measurable(drawn.frames, {what.times.front(), what.times.back()}, o.shown);
        return drawn;
    } catch (const Error& error) {
        throw at_file(o.shown, error);
    }
}

ComparedFiles compare_scene(const Options& o) {
    const std::vector<std::string> chosen = o.preset.empty() ? std::vector<std::string>() : std::vector{o.preset};
    const ShownScene shown = open_shown(o.shown, chosen, o.settings);
    const Window window = window_of(o.match.window, shown.scene.duration, "scene");
    VideoReader video = opened_video(o.match.reference);
    const SceneReference reference = reference_of(o.match, shown.scene);
    const double offset = reference.offset;
    const Window common = common_time(o.match.reference, video, o.shown, window, offset);
    Progress progress("comparing", progress_steps);
    const match::MeasureOptions options = measure_options(o.match, reference, video.info().size, o.shown);
    const match::MeasuredVideo of_reference = measured(
        video, o.match.reference, options, {common.from + offset, common.to + offset}, [&progress](double share) {
            progress.to(reference_part * share);
            return true;
        });
    const std::vector<double> times = match::compared_times(of_reference.found.frames, offset, window.from, window.to);
    if (times.empty()) throw refused(o.match.reference, "has fewer than two moments in common with " + o.shown);
    note_cover(o.match.reference, {times.front(), times.back()}, window, "compared");
    const Context context = Context::create(Backend::automatic);
    match::PreviewCurve curve =
        preview_curve(shown, prepare_organ(shown.scene, shown.presets.front().vessels),
                      match::PreviewCurve::options_for(video.info().size, reference.aspect, options.estimator));
    curve.count_plate_by(match::painted_blood(of_reference.found));
    const match::ComparedScene drawn = draw(o,
                                            {.scene = shown.scene,
                                             .preset = shown.presets.front(),
                                             .times = times,
                                             .reference = of_reference.found.frames,
                                             .offset = offset,
                                             .colors = &of_reference.colors.colors},
                                            curve, progress);
    return {.compared = drawn.compared, .offset = offset, .window = window, .of_scene = true};
}

ComparedFiles compare_video(const Options& o) {
    for (const auto& [option, given] : {std::pair{"--preset", !o.preset.empty()}, {"--set", !o.settings.empty()}})
        if (given) throw wrong_option(option, "is of a scene, and " + o.shown + " is a video");
    VideoReader video = opened_video(o.shown), reference = opened_video(o.match.reference);
    const Window window = window_of(o.match.window, video.info().duration, "video");
    const double offset = o.match.offset.value_or(0.0);
    const Window common = common_time(o.match.reference, reference, o.shown, window, offset);
    Progress progress("comparing", progress_steps);
    const match::MeasureOptions options = measure_options(o.match, {}, reference.info().size, "");
    const bool same = is_same_file(o.shown, o.match.reference);  // then the baseline is of both
    const match::MeasuredVideo of_reference = measured(
        reference, o.match.reference, options, {common.from + offset, common.to + offset}, [&progress](double share) {
            progress.to(reference_part * share);
            return true;
        });
    match::MeasuredVideo of_video =
        measured(video, o.shown, same ? options : match::MeasureOptions{}, common, [&progress](double share) {
            progress.to(reference_part + (1.0 - reference_part) * share);
            return true;
        });
    std::vector<match::FrameAmounts>& frames = of_video.found.frames;
    std::erase_if(frames, [&window](const auto& f) { return f.time < window.from || f.time > window.to; });
    note_cover(o.match.reference, common, window, "compared");
    const match::Likeness likeness = match::likeness_of(frames, of_reference.found.frames, offset);
    if (!likeness.overlap) throw refused(o.match.reference, "has fewer than two moments in common with " + o.shown);
    return {.compared = {.amounts = likeness,
                         .colors = match::likeness_of(of_video.colors.colors, of_reference.colors.colors)},
            .offset = offset,
            .window = window};
}

void print(const match::Compared& compared) {
    std::cout << in_words(compared.amounts) << '\n';
    std::cout.precision(3);
    for (const match::Figure& figure : match::figures()) {
        std::cout << figure.name << ": ";
        if (const std::optional<double> value = figure.of(compared))
            std::cout << *value << (figure.unit.empty() ? "" : " ") << figure.unit << '\n';
        else
            std::cout << "not measurable\n";
    }
}

Json number_or_null(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

std::string json_of(const Options& o, const ComparedFiles& found, std::span<const Limit> limits) {
    Json json;
    json["format"] = "lapfx.comparison";
    json["version"] = format_version;
    json[found.of_scene ? "scene" : "video"] = o.shown;
    if (!o.preset.empty()) json["preset"] = o.preset;
    if (!o.settings.empty()) json["set"] = o.settings;
    json["reference"] = o.match.reference;
    json["offset"] = found.offset;
    json["window"] = {found.window.from, found.window.to};
    json["words"] = in_words(found.compared.amounts);
    Json& figures = json["figures"] = Json::object();
    for (const match::Figure& figure : match::figures())
        figures[figure.name] = number_or_null(figure.of(found.compared));
    Json& at_most = json["at_most"] = Json::object();
    for (const Limit& limit : limits)
        at_most[limit.figure->name] = {{"limit", limit.value},
                                       {"value", number_or_null(limit.figure->of(found.compared))},
                                       {"holds", limit.holds(found.compared)}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

ComparedFiles compare(const Options& o) {
    switch (kind_of_file(o.shown)) {
        case FileKind::document:
            return compare_scene(o);
        case FileKind::organ:
            throw refused(o.shown, "is a mesh, neither a scene nor a video");
        case FileKind::image:
            throw refused(o.shown, "is a picture, neither a scene nor a video");
        case FileKind::video:
            break;
    }
    return compare_video(o);
}

void run(const Options& o) {
    check_json(o);
    const std::vector<Limit> limits = limits_of(o.at_most);
    const ComparedFiles found = compare(o);
    if (!o.json.empty()) write_file(o.json, json_of(o, found, limits));
    print(found.compared);
    if (std::vector<Fault> faults = faults_of(limits, found.compared); !faults.empty())
        throw Error(Failure::runtime, std::move(faults));
}

/// One line for each figure.
std::string figure_list() {
    std::size_t longest = 0;
    for (const match::Figure& figure : match::figures()) longest = std::max(longest, figure.name.size());
    std::string list;
    for (const match::Figure& figure : match::figures())
        list += "  " + figure.name + std::string(longest + 2 - figure.name.size(), ' ') + std::string(figure.help) +
                (figure.unit.empty() ? "" : ", " + std::string(figure.unit)) + "\n";
    return list;
}

}  // namespace

Verb compare_verb() {
    const auto o = std::make_shared<Options>();
    Verb verb{.name = "compare",
              .help = "Tell how close a scene's blood and smoke are to a surgery video's",
              .run = [o] { run(*o); }};
    verb.argument("SCENE|VIDEO", "The scene (.scene.json), or a video of it, or numbered images", &o->shown,
                  {.required = true});
    verb.argument("REFERENCE", "The video, or numbered images: frame_%04d.png", &o->match.reference,
                  {.required = true});
    verb.option("--at-most", "NAME=VALUE",
                "Fail (exit code 1) where that figure is farther, such as veil_rms=0.05; may be repeated", &o->at_most,
                {.one_each = true});
    verb.option("--preset", "FILE.json", "Of a scene: this preset instead of the one that it names", &o->preset);
    verb.option("--set", "KEY=VALUE", "Of a scene: change one parameter, such as bleeding.speed=8; may be repeated",
                &o->settings, {.one_each = true});
    add_match_options(verb, o->match, "scene or video", "compared");
    verb.option("--json", "FILE", "Write all that was found to this file, too", &o->json);
    verb.footer =
        "Both are measured by the same estimator (see lapfx measure); a scene is drawn off-screen for it,\n"
        "every 0.2 s, or where it is long at 60 times, but at least every 0.5 s. It prints one line in words,\n"
        "then each figure. The preview is the scene or the first video. Differences are preview - reference,\n"
        "and amounts shares of the view, 0 to 1. Of a figure with a sign --at-most limits the size; of a\n"
        "ratio the larger of it and 1 / it, so that 1 is alike. A figure that is not measurable fails\n"
        "its limit. What does not differ beyond the error of measuring is said to match; where that error is\n"
        "more than 10 % of the view and than half of the higher peak, or more than the higher peak where that\n"
        "is more than 2 % of the view, nothing is known: cannot tell. But where the mean difference is more\n"
        "than the larger error of the two, it says which has more, though not by how much.\n\n"
        "The figures:\n" +
        figure_list() +
        "\n"
        "Examples:\n"
        "  lapfx compare samples/lagb.scene.json samples/reference/operation.mp4 --window 0,3 --json near.json\n"
        "  lapfx compare samples/lagb.scene.json samples/reference/operation.mp4 --window 0,3 --at-most veil_rms=0.2";
    return verb;
}

}  // namespace lapfx::commands
