// A scene held against a measured video: drawn, measured as the video was, and compared in amounts and colours.
//
//     const std::vector<double> times = match::compared_times(reference.found.frames, offset, from, to);
//     const auto done = match::compare_scene({scene, preset, times, reference.found.frames, offset}, curve, progress);
//     if (done) say(in_words(done->compared.amounts));  // else `progress` stopped it
//
// Any thread, as the curve allows.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lapfx/progress.h"
#include "match/compare/likeness_figures.h"
#include "match/scene/preview_curve.h"

namespace lapfx::match {

/// What is compared. All must outlive compare_scene().
struct SceneToCompare {
    const Scene& scene;
    const Preset& preset;
    std::span<const double> times;            ///< s of the scene at which it is drawn: compared_times()
    std::span<const FrameAmounts> reference;  ///< as measured, times of the video
    double offset = 0.0;                      ///< s; reference time = scene time + offset
    const MeasuredColors* colors = nullptr;   ///< the reference's; null: colours are not compared
};

struct ComparedScene {
    std::vector<FrameAmounts> frames;  ///< of the scene, at the times
    Compared compared;                 ///< the scene is the preview; without colours where they are not compared
};

/// `curve`: draws in the shape of the reference. Nothing when `progress`, of shares 0..1, or the render thread stopped
/// it. Throws as PreviewCurve::measure().
std::optional<ComparedScene> compare_scene(const SceneToCompare& what, PreviewCurve& curve,
                                           const Progress& progress = {});

}  // namespace lapfx::match
