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

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "match/compare/color_likeness.h"
#include "match/fit/fit_input.h"

namespace lapfx::match {

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
    bool proposal_left = false;       ///< the curves are nearer without it: the fit began with `before`
    bool ended_early = false;         ///< cancelled, or out of budget
    int curves = 0, evaluations = 0;  ///< drawn; of the core
};

/// Throws what `draw` throws, and Error (bad_input): fewer than two times, no parameter, or a reference that shows
/// neither amount.
FitResult fit(const FitInput& input);

}  // namespace lapfx::match
