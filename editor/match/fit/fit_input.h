// What a fit is asked for, and what it tells while it goes on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

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
    double share = 0.0;                               ///< 0..1, of the curves that are drawn at most; it falls
                                                      ///< when another fit begins, of the scene as it was
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

/// Throws Error (bad_input) where nothing is free, or the target has nothing to fit to.
void require_something(const FitInput& input);

/// Whether the proposal changed events or their emission. `input` has one.
bool moves_tools(const FitInput& input);

/// The same, of the scene as it was. `input` has a proposal.
FitInput without_proposal(const FitInput& input);

}  // namespace lapfx::match
