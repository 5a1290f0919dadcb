#include "match/fit/fit_colors.h"

#include <algorithm>
#include <utility>

namespace lapfx::match {

namespace {

/// What is measured changes a little with the colours. False: it was ended.
bool draw_again(FitResult& result, std::span<const TargetPoint> target, PreviewCurve& curve, const Progress& progress) {
    std::vector<double> times;
    for (const TargetPoint& aim : target) times.push_back(aim.time);
    std::optional<std::vector<FrameAmounts>> frames =
        curve.measure(result.tuned.scene, result.tuned.preset, times, {.progress = progress});
    if (!frames) return false;
    result.after = std::move(*frames);
    result.blood_after = misfit(target, result.after, &TargetPoint::blood);
    result.veil_after = misfit(target, result.after, &TargetPoint::veil);
    ++result.curves;
    return true;
}

}  // namespace

std::vector<std::string> fit_colors(FitResult& result, const ColorFit& input, PreviewCurve& curve) {
    ColorMatchInput matched{.start = result.tuned, .reference = input.reference, .keys = input.keys};
    const double most_drawn = matched.rounds + 2.0;  // and what it starts from, and what was found
    double drawn = -1.0, reached = 0.0;
    const Progress part = [&](double share) {
        reached = std::max(reached, std::min((drawn + share) / most_drawn, 1.0));
        return !input.progress || input.progress(reached);
    };
    matched.draw = [&](const Tuned& tuned) {
        ++drawn;
        return drawn_colors(curve, tuned, input.target, part);
    };
    const ColorMatch found = match_colors(matched);
    if (found.drawn == 0) return {"colours: the fit ended before the scene was drawn for them; they stay"};
    result.tuned = found.tuned;
    std::vector<std::string> lines = likeness_lines(found);
    lines.insert(lines.end(), found.lines.begin(), found.lines.end());
    drawn = most_drawn - 1.0;
    if (!draw_again(result, input.target, curve, part))
        lines.emplace_back("the curves are those before the colours were matched: the fit ended early");
    if (found.ended_early) lines.emplace_back("colours: the fit ended before they were as near as they can be");
    return lines;
}

}  // namespace lapfx::match
