// A scene fitted to a measured video, from beginning to end: its proposal, the search with its drawn curves, colours,
// and the report of it.
//
//     match::SceneFit fit{.start = {scene, preset}, .organ = organ, .keys = {"bleeding.speed"},
//                         .reference = measured.frames, .to = scene.duration};
//     const match::FittedScene found = match::fit_scene(fit, curve, {.progress = progress});
//     if (!found.result->after.empty()) write_file("report.html", report_html(report_of(found, {.scene = "a.json"})));
//
// The thread that asks `curve` for its pictures; the same input gives the same result, unless `progress` ends it.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "document/content.h"
#include "lapfx/progress.h"
#include "match/fit/fit.h"
#include "match/fit/fit_colors.h"
#include "match/report/report_pictures.h"
#include "match/scene/preview_curve.h"

namespace lapfx::match {

/// What becomes of colours: nothing, they are compared with the reference's before and after, or matched with them.
enum class ColorsOfFit : std::uint8_t { leave, compare, match };

/// All that a fit goes by.
struct SceneFit {
    document::Content start = {};
    std::shared_ptr<const PreparedOrgan> organ = {};  ///< the scene's
    std::vector<std::string> keys = {};               ///< of the parameters that are free: free_parameters()
    std::vector<FrameAmounts> reference = {};         ///< as measured
    double offset = 0.0;                              ///< s; reference time = scene time + offset
    double from = 0.0, to = 0.0;                      ///< s of the scene
    double step = TargetOptions{}.step;               ///< s between the times that are drawn
    bool tools = true;                                ///< the proposal may move, add and silence them
    double aspect = 1.25;                             ///< of the drawn pictures, width over height
    Weights weights = {};
    std::uint32_t seed = 1;
    int rounds = FitInput{}.rounds;
    ColorsOfFit colors = ColorsOfFit::leave;
    ColorsAtPeak reference_colors = {};  ///< unless they are left
    std::vector<std::string> color_keys = {match::color_keys().begin(), match::color_keys().end()};  ///< that are free
};

/// What it aims at.
std::vector<TargetPoint> target_of(const SceneFit& fit);

struct FittedScene {
    document::Content start = {}, tuned = {};
    std::shared_ptr<const PreparedOrgan> organ = {};
    double offset = 0.0, from = 0.0, to = 0.0;  ///< as of SceneFit
    std::uint32_t seed = 1;
    std::vector<std::string> lines = {};         ///< of the proposal, for people; none where the tools have to stay
    std::vector<std::string> colors = {};        ///< how near they are, and which were changed, for people
    std::vector<FreeParameter> parameters = {};  ///< without those of tools that the proposal has added
    std::vector<TargetPoint> target = {};
    std::optional<FitResult> result = {};  ///< none: a proposal alone
};

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

/// What a report says besides what was found, as FitReport has it.
struct ReportOf {
    std::string scene = {}, reference = {}, preset = {}, fitted = {}, fitted_scene = {};
    double seconds = 0.0;
    std::vector<std::string> notes = {};
};
/// Without pictures. `found`: with a result.
FitReport report_of(const FittedScene& found, const ReportOf& of);
/// Fills the report's moments, as add_pictures() of report_pictures.h does, with what `curve` draws.
bool add_pictures(FitReport& report, VideoReader& reference, double aspect, const document::Content& before,
                  PreviewCurve& curve, const Progress& progress = {}, const std::atomic<bool>* stop = nullptr);

}  // namespace lapfx::match
