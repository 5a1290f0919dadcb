// Shared by verbs that hold a scene against a surgery video: the options that say how, measuring the video, and drawing
// the scene so that it is measured alike.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "commands/command_line.h"
#include "commands/shown_scene.h"
#include "lapfx/authoring/video.h"
#include "lapfx/error.h"
#include "match/scene/preview_curve.h"
#include "match/use/measure_video.h"

namespace lapfx::commands {

struct MatchOptions {
    std::string reference, window;
    std::string view;                        ///< x,y,r
    std::optional<double> offset, baseline;  ///< s
};
/// --offset, --window, --baseline and --view. `of`: what has the time that the offset is from, "scene"; `done`: what is
/// done to the window, "fitted".
void add_match_options(Verb& verb, MatchOptions& options, const std::string& of, const std::string& done);

/// s, of the scene or of the video that is held against the reference.
struct Window {
    double from, to;
};
/// The part of a window of `shown` that the reference, `file`, has, too. Throws Error (bad_input) where there is none.
Window common_time(const std::string& file, const VideoReader& reference, const std::string& shown,
                   const Window& window, double offset);
/// "2,8"; all of `duration` where `text` is empty. `whole`: what it is a part of, "scene". Throws Error (bad_input).
Window window_of(const std::string& text, double duration, const std::string& whole);

/// What the scene says of its own reference holds for that video only; the options come first.
SceneReference reference_of(const MatchOptions& options, const Scene& scene);
/// How that reference is measured; `size`: of its pictures; `scene`: the file that says so, for messages. Throws Error
/// (bad_input).
match::MeasureOptions measure_options(const MatchOptions& options, const SceneReference& reference, glm::ivec2 size,
                                      const std::string& scene);

/// Opens it and prints what is unusual about it. Throws Error (bad_input) that names it.
VideoReader opened_video(const std::string& file);

/// The same error; faults that name no file get `file`.
Error at_file(const std::string& file, const Error& error);

/// Measures a whole video: what lies outside a window helps to find its baseline. Prints what should be known about the
/// figures. Throws Error that names the file. `progress`: shares 0..1.
match::MeasuredVideo measured_video(VideoReader& video, const std::string& file, match::VideoMeasuring how,
                                    const lapfx::Progress& progress);

/// Tells where much of the window lacks. `done`: "fitted".
void note_cover(const std::string& file, const Window& covered, const Window& window, const std::string& done);

/// How a scene is drawn to be held against a video: with all of its smoke.
PreviewOptions preview_options(const ShownScene& shown);
/// Draws a scene to be measured as its reference is. A context must be current, and stay so.
match::PreviewCurve preview_curve(const ShownScene& shown, std::shared_ptr<const PreparedOrgan> organ,
                                  const match::PreviewCurve::Options& options);

}  // namespace lapfx::commands
