#include "commands/matched_videos.h"
#include "commands/say.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>
#include <utility>

#include "app/measure/measuring.h"
#include "commands/file_kind.h"
#include "commands/measured_part.h"
#include "commands/options.h"
#include "commands/session.h"
#include "match/use/measure_video.h"

namespace lapfx::commands {

void add_match_options(Verb& verb, MatchOptions& options, const std::string& of, const std::string& done) {
    verb.option("--offset", "S",
                "Reference time = " + of + " time + S, s; default: the scene's, where this is its reference, else 0",
                &options.offset, {.number = Number::finite});
    verb.option("--window", "FROM,TO", "The part of the " + of + " that is " + done + ", s; default: all of it",
                &options.window);
    verb.option("--baseline", "S", "Time of a clear frame of the reference, s, as for lapfx measure", &options.baseline,
                {.number = Number::finite});
    verb.option("--view", "x,y,r",
                "The round view of the reference, as for lapfx measure. Left out, it is looked for, and what is dark "
                "at the rim of every frame is no part of it",
                &options.view);
}

Window window_of(const std::string& text, double duration, const std::string& whole) {
    if (text.empty()) return {0.0, duration};
    Window window{};
    std::istringstream in(text);
    char comma = 0, more = 0;
    if (!(in >> window.from >> comma >> window.to) || comma != ',' || in >> more || !std::isfinite(window.from) ||
        !std::isfinite(window.to))
        throw wrong_option("--window", "\"" + text + "\" is not FROM,TO in seconds, such as 2,8");
    if (window.from >= window.to)
        throw wrong_option("--window", "\"" + text + "\" does not end after it begins: FROM,TO, such as 2,8");
    if (window.from < 0.0 || window.to > duration)
        throw wrong_option(
            "--window", "\"" + text + "\" is not a part of the " + whole + ", 0 to " + match::seconds_text(duration));
    return window;
}

SceneReference reference_of(const MatchOptions& options, const Scene& scene) {
    SceneReference reference;
    if (!scene.reference.file.empty() && will_be_same_file(scene.folder / scene.reference.file, options.reference))
        reference = scene.reference;
    if (options.offset) reference.offset = *options.offset;
    return reference;
}

match::MeasureOptions measure_options(const MatchOptions& options, const SceneReference& reference, glm::ivec2 size,
                                      const std::string& scene) {
    match::MeasureOptions made = match::measure_options(reference.measure);
    if (made.strokes) made.strokes->file = scene;
    if (options.baseline) made.baseline = options.baseline;  // also 0, which a scene has for none
    if (!options.view.empty()) made.estimator.round_view = round_view_of(options.view, size);
    return made;
}

VideoReader opened_video(const std::string& file) {
    if (file.empty())
        throw Error(Failure::bad_input, Fault{.file = "", .place = "", .reason = "the name of a video is empty"});
    VideoReader video(file);
    if (!video.info().warning.empty()) say(file + ": " + video.info().warning);
    return video;
}

Error at_file(const std::string& file, const Error& error) {
    std::vector<Fault> faults = error.faults();
    for (Fault& fault : faults)
        if (fault.file.empty()) fault.file = file;
    return {error.failure(), std::move(faults)};
}

match::MeasuredVideo measured_video(VideoReader& video, const std::string& file, match::VideoMeasuring how,
                                    const lapfx::Progress& progress) {
    try {
        match::MeasuredVideo measured = match::measure_video(video, std::move(how), progress);
        for (const std::string& line : measured.found.notes) say(file + ": " + line);
        return measured;
    } catch (const Error& error) {
        std::vector<Fault> faults = error.faults();
        for (Fault& fault : faults)
            if (fault.place == "baseline") fault.place = "--baseline";
        throw at_file(file, Error(error.failure(), std::move(faults)));
    }
}

void note_cover(const std::string& file, const Window& covered, const Window& window, const std::string& done) {
    constexpr double much = 0.5;  // s
    if (covered.from <= window.from + much && covered.to >= window.to - much) return;
    say(file + ": covers only " + match::seconds_text(covered.from) + " to " + match::seconds_text(covered.to) +
        "; the rest is not " + done);
}

Window common_time(const std::string& file, const VideoReader& reference, const std::string& shown,
                   const Window& window, double offset) {
    const double duration = reference.info().duration;
    const Window common{std::max(window.from, -offset), std::min(window.to, duration - offset)};
    if (common.from < common.to) return common;
    throw Error(
        Failure::bad_input,
        Fault{.file = file,
              .place = "",
              .reason = "has no time in common with " + shown + ": " + match::seconds_text(window.from) + " to " +
                        match::seconds_text(window.to) + " of that are " + match::seconds_text(window.from + offset) +
                        " to " + match::seconds_text(window.to + offset) + " of this, which ends at " +
                        match::seconds_text(duration)});
}

PreviewOptions preview_options(const ShownScene& shown) {
    return {.clip_folders = clip_folders(), .wait_for_clips = true, .clip_cache = shown.clips};
}

match::PreviewCurve preview_curve(const ShownScene& shown, std::shared_ptr<const PreparedOrgan> organ,
                                  const match::PreviewCurve::Options& options) {
    return {std::move(organ), preview_options(shown), options};
}

}  // namespace lapfx::commands
