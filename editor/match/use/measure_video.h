// A video, measured for whoever uses it: amounts of its frames over time, and its colours.
//
//     const match::MeasuredVideo of = match::measure_video(
//         video, {.options = match::measure_options(scene.reference.measure), .colors_of = {{0.0, 8.0}}}, progress);
//     plot(of.found.frames), show(of.colors.colors);
//
// Any thread.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>

#include "lapfx/authoring/video.h"
#include "lapfx/progress.h"
#include "lapfx/scene.h"
#include "match/video/measure.h"
#include "match/video/peak_colors.h"

namespace lapfx::match {

/// The strokes of a scene.
BloodStrokes painted_strokes(const ReferenceMeasure& measure);
/// Whether one of them marks blood: then it is looked for by them.
bool paints_blood(const ReferenceMeasure& measure);
/// Those by which blood is looked for; nothing where none of them marks blood.
std::optional<BloodStrokes> learned_strokes(const ReferenceMeasure& measure);
/// How a scene says that its reference is measured.
MeasureOptions measure_options(const ReferenceMeasure& measure);

/// s of a video, both included.
struct VideoPart {
    double from = 0.0, to = 0.0;
};

struct VideoMeasuring {
    MeasureOptions options = {};
    std::optional<VideoPart> colors_of = {};  ///< whose colours are wanted; none: they cost nothing
    bool colors_over_time = false;            ///< of any part, asked for afterwards
};

struct MeasuredVideo {
    Measurement found;
    ColorsAtPeak colors = {};                                     ///< of VideoMeasuring::colors_of
    std::shared_ptr<const ColorsOverTime> colors_over_time = {};  ///< null where they were not wanted
};

/// Throws as measure().
MeasuredVideo measure_video(VideoReader& video, VideoMeasuring how, const Progress& progress = {});
/// Opens the file for it alone; `stop` ends that early. Throws as VideoReader and measure().
MeasuredVideo measure_video(const std::filesystem::path& file, VideoMeasuring how, const Progress& progress = {},
                            const std::atomic<bool>* stop = nullptr);

}  // namespace lapfx::match
