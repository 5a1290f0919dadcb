// What a fit of a scene goes by, and what came of it: fit_scene() (match/use/fit_scene.h) makes the one of the other,
// and a report tells both.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "document/content.h"
#include "match/fit/fit.h"
#include "match/fit/fit_colors.h"

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

struct FittedScene {
    SceneFit fit = {};  ///< what it was of
    document::Content tuned = {};
    std::vector<std::string> lines = {};         ///< of the proposal, for people; none where the tools have to stay
    std::vector<std::string> colors = {};        ///< how near they are, and which were changed, for people
    std::vector<FreeParameter> parameters = {};  ///< without those of tools that the proposal has added
    std::vector<TargetPoint> target = {};
    std::optional<FitResult> result = {};  ///< none: a proposal alone
};

}  // namespace lapfx::match
