// The colours of blood, smoke and organ, and the exposure, with which a scene looks as a video does: the scene is drawn
// and measured as the video was, and what differs is corrected, a few times.
//
//     const ColorMatch found = match_colors({.start = {scene, preset}, .reference = peaks.at_peak(), .draw = draw});
//     for (const std::string& line : found.lines) std::cout << line << '\n';
//     document.take(found.tuned);
//
// What a video tells, and what it does not:
// - Exposure and the organ's colour follow the tissue's mean light: an organ's texture is not the tissue of the video,
//   and in what is measured of smoke the tint of the tissue behind it has a part. The organ's colour keeps how light it
//   is, the exposure does the rest.
// - The lamp keeps its colour. White highlights would tell it, but in clips of one operation, with one camera, what is
//   bright and not cut off has 0.62 to 0.92 as much green as red, and 0.59 to 0.98 as much blue (18 clips of cholec80,
//   linear light): that is more about the tissue beneath than about the lamp. Its intensity does what exposure does.
// - Blood: thin and deep colour are changed by one factor for each channel of their light, which keeps the gradient.
// - Smoke: likewise colours of haze and plume, which measuring does not tell apart. Of a video whose dark places do not
//   tell the tint (smoke_tint.h), only how bright it is.
//
// The thread of `draw`; the same input gives the same result.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lapfx/progress.h"
#include "match/compare/color_likeness.h"
#include "match/fit/free_parameter.h"
#include "match/fit/target.h"
#include "match/scene/preview_curve.h"
#include "match/video/peak_colors.h"

namespace lapfx::match {

/// All that may be free: camera.exposure and organ.color of the scene, the latter with the exposure only, and the
/// colours of blood, haze and plume of the preset.
std::span<const std::string> color_keys();
/// Of color_keys(): else it is the preset's.
bool is_color_of_scene(std::string_view key);

/// Those of color_keys() that differ.
std::vector<std::string> different_colors(const document::Content& a, const document::Content& b);
/// Takes the values of these keys over; other keys are ignored.
void take_colors(document::Content& into, const document::Content& from, std::span<const std::string> keys);

/// Draws a scene and measures it; nothing: it was cancelled.
using DrawColors = std::function<std::optional<ColorsAtPeak>(const document::Content& tuned)>;

struct ColorMatchInput {
    document::Content start;
    ColorsAtPeak reference = {};                                                 ///< measured in the video
    std::vector<std::string> keys = {color_keys().begin(), color_keys().end()};  ///< that are free; others are ignored
    DrawColors draw = {};
    int rounds = 6;                            ///< times that it is corrected at most; each is drawn
    const struct ColorMatch* begun = nullptr;  ///< an earlier match, from whose start changes are told; null: from this
};

struct ColorMatch {
    document::Content start;                                    ///< before any colour was changed
    document::Content tuned;                                    ///< was drawn; no farther from the video than the start
    ColorLikeness before = {}, after = {};                      ///< Delta E 2000
    std::optional<double> light_before = {}, light_after = {};  ///< tissue's mean light, that of the video is 1
    std::vector<std::string> lines = {};  ///< for people: what was proposed, and why something was not
    int drawn = 0;
    bool ended_early = false;  ///< `draw` was cancelled: the best so far
};

/// Throws what `draw` throws, and Error (bad_input) where a value of `start` that is free is not allowed.
ColorMatch match_colors(const ColorMatchInput& input);

/// One line for each of tissue, blood and smoke: "blood: Delta E 12.1 before, 1.3 after".
std::vector<std::string> likeness_lines(const ColorMatch& match);

/// A scene's colours, measured at some of the target's times. Nothing when `progress` stopped it. Throws as
/// PreviewCurve::measure().
std::optional<ColorsAtPeak> drawn_colors(PreviewCurve& curve, const document::Content& tuned,
                                         std::span<const TargetPoint> target, const Progress& progress = {});

}  // namespace lapfx::match
