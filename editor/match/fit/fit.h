// Finds the values of chosen parameters with which a scene shows as much blood and veil over time as a reference.
//
//     FitResult found = fit({.start = {scene, preset}, .parameters = ..., .target = ..., .organ = organ, .draw =
//     draw}); save_preset(found.tuned.preset);
//
// It searches over curves that are told without drawing (carried.h), draws the scene where that ended, measures it as
// the reference was measured, learns from the difference and searches again: a few drawn curves in all, of which the
// nearest is the result. Parameters that the reference does not tell keep their value, and it is said why; but where
// the curves rule that value out, or tell another but for what smoke may hide or too few moments show (undetermined.h),
// it is where they are nearest, and so it is where putting values back would make the curves that much farther, one of
// many that fit as well. Where a proposal moved tools, the scene as it was is searched, too, over told curves: the fit
// goes on with the nearer of the two. Where what it ends with is drawn farther than the scene as it was (as the
// objective tells it, without what is known beforehand), that scene is fitted instead.
//
// The thread of `draw`; the same input gives the same result, unless the budget ends it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "match/compare/color_likeness.h"
#include "match/fit/free_parameter.h"
#include "match/fit/objective.h"
#include "match/fit/target.h"

namespace lapfx {
class PreparedOrgan;
}

namespace lapfx::match {

/// Draws a scene at these times, s, and measures it; as many frames as times. Nothing: it was cancelled.
using DrawCurve = std::function<std::optional<std::vector<FrameAmounts>>(const document::Content& tuned,
                                                                         std::span<const double> times)>;

/// How far a fit has come.
struct FitProgress {
    double share = 0.0;                               ///< 0..1, of the curves that are drawn at most
    int curves = 0;                                   ///< drawn so far; `best` changes with it only
    double next = 0.0;                                ///< 0..1, share once the next curve is drawn
    const std::vector<FrameAmounts>* best = nullptr;  ///< the nearest curve so far; null: none was drawn yet
};

struct FitInput {
    document::Content start;  ///< where the search begins
    std::optional<document::Content> before =
        {};  ///< without the proposal; what is not determined keeps its value; none: start
    std::optional<document::Content> proposed =
        {};  ///< another place that the first search tries: a proposal without its tools
    std::vector<FreeParameter> parameters = {};  ///< at least one
    std::size_t of_proposal = 0;                 ///< so many of the last parameters exist beside its tools only
    std::vector<TargetPoint> target = {};        ///< at least two
    std::shared_ptr<const PreparedOrgan> organ = {};
    DrawCurve draw = {};
    /// Asked once the first search has brought the amounts near: the colours of what it gives are taken, and the search
    /// goes on with them (fit_colors.h). Nothing: it was ended.
    std::function<std::optional<document::Content>(const document::Content& tuned)> match_colors = {};
    double aspect = 1.25;  ///< of the drawn pictures, width over height
    Weights weights = {};
    std::uint32_t seed = 1;
    int rounds = 5;  ///< curves of the search at most; besides: the first, one for each parameter unknown to the core,
                     ///< two for colours, and up to three once it is known what keeps its value
    /// Called between steps; false ends the fit with what is the best so far.
    std::function<bool(const FitProgress&)> progress = {};
};

struct FittedParameter {
    FreeParameter parameter;
    double before = 0.0, after = 0.0;
    double low = 0.0, high = 0.0;  ///< 90 % interval; that what is held is right is not taken for certain
    /// Known to within a factor of about two, beside what is held. Else it has kept its value, the fit ended early, or
    /// it is where the curves are nearest, which does not make it known.
    bool determined = false;
    bool at_bound = false;  ///< the curves would take it farther
    std::string why = {};   ///< why it is not determined, and what would tell it; else empty
};

struct FitResult {
    document::Content tuned;
    std::vector<FittedParameter> parameters = {};       ///< as FitInput's; none where it ended before the search
    std::vector<FrameAmounts> before = {}, after = {};  ///< as drawn and measured, at the target's times
    std::optional<double> blood_before = {}, blood_after = {};  ///< root mean square differences
    std::optional<double> veil_before = {}, veil_after = {};
    ColorLikeness colors_before = {}, colors_after = {};  ///< Delta E 2000; measured by FitColors, else missing
    bool proposal_left = false;       ///< with the tools of `before` the curves are nearer: it began with those
    bool ended_early = false;         ///< cancelled, or out of budget
    int curves = 0, evaluations = 0;  ///< drawn; of the core
};

/// Throws what `draw` throws, and Error (bad_input): fewer than two times, no parameter, or a reference that shows
/// neither amount.
FitResult fit(const FitInput& input);

}  // namespace lapfx::match
