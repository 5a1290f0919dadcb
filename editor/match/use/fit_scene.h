// A scene fitted to a measured video, from beginning to end: its proposal, the search with its drawn curves, colours,
// and the report of it.
//
//     match::SceneFit fit{.start = {scene, preset}, .organ = organ, .keys = {"bleeding.speed"},
//                         .reference = measured.frames, .to = scene.duration};
//     const match::FittedScene found = match::fit_scene(fit, curve, {.progress = progress});
//     const match::FitReport report{.of = {.scene = "a.json"}, .found = found};
//     if (!found.result->after.empty()) write_file("report.html", report_html(report));
//
// The thread that asks `curve` for its pictures; the same input gives the same result, unless `progress` ends it.
#pragma once

#include <atomic>
#include <functional>
#include <vector>

#include "lapfx/progress.h"
#include "match/fit/scene_fit.h"
#include "match/report/report_pictures.h"
#include "match/scene/preview_curve.h"

namespace lapfx::match {

/// What it aims at.
std::vector<TargetPoint> target_of(const SceneFit& fit);

/// Where a fit begins; with the lines of the proposal in any case. Nothing is drawn; under two seconds, any thread.
/// Throws as free_parameters() and propose().
FittedScene propose_scene(const SceneFit& fit);

struct FitCalls {
    Progress progress = {};  ///< shares 0..1 that never go back; false ends it with the best so far
    /// The nearest curve so far, each time that there is a nearer one.
    std::function<void(const std::vector<FrameAmounts>& best)> best = {};
};

/// `curve`: draws in the shape of the reference. Without curves in the result where it ended before the first was
/// drawn. Throws as propose_scene() and fit().
FittedScene fit_scene(const SceneFit& fit, PreviewCurve& curve, const FitCalls& calls = {});

/// Fills the report's moments, as add_pictures() of report_pictures.h does, with what `curve` draws.
bool add_pictures(FitReport& report, VideoReader& reference, double aspect, PreviewCurve& curve,
                  const Progress& progress = {}, const std::atomic<bool>* stop = nullptr);

}  // namespace lapfx::match
