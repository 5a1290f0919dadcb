// Measures a whole video: amounts over time, their episodes, and what should be known about them.
//
//     lapfx::VideoReader video("operation.mp4");
//     match::Measurement found = match::measure(video, {.baseline = 2.5}, progress);   // throws lapfx::Error
//     write(csv_of(found));
//
// Each shot is measured against a clear frame of its own (shots.h). Any thread. Reads the video first
// in coarse steps (shots, baselines, light of the smoke, burnt-in text; every frame where a shot ends), then frame by
// frame.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lapfx/authoring/video.h"
#include "lapfx/progress.h"
#include "match/frame/estimator.h"
#include "match/video/episode.h"
#include "match/video/painted_video.h"
#include "match/video/shots.h"

namespace lapfx::match {

/// Given each frame once it was measured, with the layers of the estimator, or null where no baseline serves.
/// What it throws ends measuring.
using FrameMeasured = std::function<void(const Image& frame, const Estimator* estimator, const FrameAmounts& amounts)>;

struct MeasureOptions {
    EstimatorOptions estimator = {};
    std::optional<double> baseline = {};  ///< s, for the shots that show its tissue; none: all are found (find_shots)
    double from = 0.0;                    ///< s, the first that is measured
    std::optional<double> to = {};        ///< s, the last; none: to the end
    int every = 1;                        ///< measures every n-th frame
    /// Of blood, by which it is looked for then; none: what is new since the baseline is.
    std::optional<BloodStrokes> strokes = {};
    FrameMeasured measured = {};
};

struct Measurement {
    std::vector<FrameAmounts> frames;  ///< ascending times
    std::vector<Shot> shots;           ///< in their order
    std::optional<double> baseline;    ///< s: the one that was given, else that of the longest shot that has one
    bool suggested = false;            ///< the baseline was found, not given
    std::shared_ptr<const Survey> survey = std::make_shared<const Survey>();  ///< of that baseline; never null
    std::optional<PaintedVideo> painted = {};  ///< by whose strokes blood is all that is in view
    Episode blood, veil;                       ///< without figures where most frames do not have the amount
    bool course_only = false;        ///< no level is known: the veil's episode has times only (FrameAmounts::course)
    std::vector<std::string> notes;  ///< what a reader of the figures should know, one line each
};

/// By which blood is all that is in view; null: it is what is new.
std::shared_ptr<const PaintedBlood> painted_blood(const Measurement& measurement);

/// The time of the baseline of the longest shot; where each of its frames is hazy, of its earliest that is nearly as
/// clear as the clearest all the same.
/// Throws Error: bad_input where no tissue is in view, runtime when `progress` stopped it.
double suggest_baseline(VideoReader& video, double from, double to, const Progress& progress = {});

inline constexpr int surveyed_frames = 10;
/// Lets the estimator survey so many frames, evenly spread, between two times (s). Throws Error (runtime) when
/// `progress` stopped it.
void survey(VideoReader& video, Estimator& estimator, double from, double to, const Progress& progress = {});

/// The mean dark channel of a picture's view, 0..1 (SeenFrame::haze).
double hazeness_of(const Image& image);

/// Throws Error: bad_input for a baseline or a part outside the video, a baseline that the file cannot give, or a video
/// without a measurable frame, and for strokes as learn_blood(); runtime when `progress` stopped it.
Measurement measure(VideoReader& video, const MeasureOptions& options, const Progress& progress = {});

/// Why an amount has no peak and mean: "not measurable", or in how few frames it is.
std::string without_episode(const Measurement& measurement, Curve curve);

/// One row a frame: "time,blood,blood_low,blood_high,veil,veil_low,veil_high,flags,light,light_low,light_high,gain,
/// gain_low,gain_high". What is not measurable is empty, and the flags, words with one space between them, say why.
std::string csv_of(const Measurement& measurement);
/// The same with shots and their baselines, light, episodes, notes, and of each frame its plume, how well it is seen
/// and its course; where a person's strokes told the blood, also "blood_by_strokes": of which file, and that it is
/// absolute.
std::string json_of(const Measurement& measurement);
/// Blood and veil over time with their intervals and episodes, 1280x720. A course is drawn without a scale.
Image plot_of(const Measurement& measurement);
/// Reads what csv_of wrote, also without the columns after the flags: light is 0 and gain 1 then. `name` stands in
/// messages. Amounts that are not measurable are 0, their gains 1. Throws Error (bad_input) for missing or foreign
/// columns and values, naming the line.
std::vector<FrameAmounts> read_amounts(std::string_view csv, const std::string& name);

}  // namespace lapfx::match
