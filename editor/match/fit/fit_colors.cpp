#include "match/fit/fit_colors.h"

#include <algorithm>
#include <utility>

namespace lapfx::match {

/// `progress`: how many were drawn before, and the share of what is being drawn.
ColorMatch FitColors::match(const document::Content& start, std::vector<std::string> keys,
                            const std::function<bool(int drawn, double share)>& progress) {
    ColorMatchInput matched{
        .start = start, .reference = input_.reference, .keys = std::move(keys), .begun = begun_ ? &*begun_ : nullptr};
    int drawn = -1;
    matched.draw = [&](const document::Content& tuned) {
        ++drawn;
        return drawn_colors(*curve_, tuned, input_.target, [&](double share) { return progress(drawn, share); });
    };
    return match_colors(matched);
}

std::optional<document::Content> FitColors::amidst(const document::Content& tuned) {
    std::vector<std::string> keys = input_.keys;
    std::erase_if(keys, [](const std::string& key) { return key.starts_with("bleeding."); });  // once all is found
    begun_.reset();  // of a fit that was dropped
    ColorMatch found =
        match(tuned, std::move(keys), [this](int, double share) { return !input_.amidst || input_.amidst(share); });
    if (found.drawn == 0 || found.ended_early) return {};
    begun_ = std::move(found);
    return begun_->tuned;
}

/// What is measured changes a little with the colours. False: it was ended.
bool FitColors::draw_again(FitResult& result, const Progress& progress) {
    std::vector<double> times;
    for (const TargetPoint& aim : input_.target) times.push_back(aim.time);
    std::optional<std::vector<FrameAmounts>> frames =
        curve_->measure(result.tuned.scene, result.tuned.preset, times, {.progress = progress});
    if (!frames) return false;
    result.after = std::move(*frames);
    result.blood_after = misfit(input_.target, result.after, &TargetPoint::blood);
    result.veil_after = misfit(input_.target, result.after, &TargetPoint::veil);
    ++result.curves;
    return true;
}

/// Of a fit that ended before they could be matched for what it found.
std::vector<std::string> FitColors::ended_lines(const FitResult& result) const {
    if (!begun_ || different_colors(result.tuned, begun_->start).empty())
        return {"colours: the fit ended before the scene was drawn for them; they stay"};
    std::vector<std::string> lines = likeness_lines(*begun_);
    lines.insert(lines.end(), begun_->lines.begin(), begun_->lines.end());
    lines.emplace_back("colours: matched after a first search; the fit ended before they were matched to the end");
    return lines;
}

std::vector<std::string> FitColors::finish(FitResult& result) {
    const double most_drawn = ColorMatchInput{}.rounds + 2.0;  // and what it starts from, and what was found
    double reached = 0.0;
    const auto progress = [&](double drawn, double share) {
        reached = std::max(reached, std::min((drawn + share) / most_drawn, 1.0));
        return !input_.finish || input_.finish(reached);
    };
    const ColorMatch found = match(result.tuned, input_.keys, progress);
    if (found.drawn == 0) return ended_lines(result);
    result.colors_before = found.before, result.colors_after = found.after;
    const bool same = different_colors(result.tuned, found.tuned).empty();
    result.tuned = found.tuned;
    std::vector<std::string> lines = likeness_lines(found);
    lines.insert(lines.end(), found.lines.begin(), found.lines.end());
    if (!same && !draw_again(result, [&](double share) { return progress(most_drawn - 1.0, share); }))
        lines.emplace_back("the curves are those before the colours were matched: the fit ended early");
    if (found.ended_early) lines.emplace_back("colours: the fit ended before they were as near as they can be");
    return lines;
}

void FitColors::compare(FitResult& result, const document::Content& before) {
    const auto likeness = [this](const document::Content& tuned, double from) -> std::optional<ColorLikeness> {
        const std::optional<ColorsAtPeak> seen = drawn_colors(*curve_, tuned, input_.target, [&](double share) {
            return !input_.finish || input_.finish(from + 0.5 * share);
        });
        return seen ? std::optional(likeness_of(seen->colors, input_.reference.colors)) : std::nullopt;
    };
    const std::optional<ColorLikeness> was = likeness(before, 0.0);
    const std::optional<ColorLikeness> is = was ? likeness(result.tuned, 0.5) : std::nullopt;
    if (was && is) result.colors_before = *was, result.colors_after = *is;
}

}  // namespace lapfx::match
