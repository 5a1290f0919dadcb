#include "match/use/fit_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "match/fit/proposal.h"

namespace lapfx::match {

namespace {

// Of the progress: the amounts, where the colours are matched, too, and where they are only compared.
constexpr double amounts_beside_matching = 0.7, amounts_beside_comparing = 0.9;

FittedScene begun(const SceneFit& fit) {
    return {
        .fit = fit, .tuned = fit.start, .parameters = free_parameters(fit.start, fit.keys), .target = target_of(fit)};
}

FitInput input_of(const SceneFit& fit, const FittedScene& found) {
    return {.start = fit.start,
            .parameters = found.parameters,
            .target = found.target,
            .organ = fit.organ,
            .aspect = fit.aspect,
            .weights = fit.weights,
            .seed = fit.seed,
            .rounds = fit.rounds};
}

/// Shares of all that is done, of which the amounts are the first part.
class FitShares {
  public:
    FitShares(ColorsOfFit colors, const FitCalls& calls) : calls_(calls) {
        if (colors == ColorsOfFit::match) amounts_part_ = amounts_beside_matching;
        if (colors == ColorsOfFit::compare) amounts_part_ = amounts_beside_comparing;
    }

    /// Between two steps of fit().
    bool stepped(const FitProgress& progress) {
        share_ = amounts_part_ * progress.share, next_ = amounts_part_ * progress.next;
        if (progress.best != nullptr && std::exchange(curves_, progress.curves) != progress.curves && calls_.best)
            calls_.best(*progress.best);
        return drawing(0.0);
    }
    /// `share`: 0..1 of the curve that is being drawn.
    bool drawing(double share) { return reached(share_ + share * (next_ - share_)); }
    /// `share`: 0..1 of matching the colours, or comparing them.
    bool coloring(double share) { return reached(std::lerp(amounts_part_, 1.0, share)); }

  private:
    /// A picture that is drawn once more does not take it back.
    bool reached(double share) {
        most_ = std::max(most_, share);
        return !calls_.progress || calls_.progress(most_);
    }

    const FitCalls& calls_;
    double amounts_part_ = 1.0, share_ = 0.0, next_ = 0.0, most_ = 0.0;
    int curves_ = 0;  // drawn when the nearest one was told
};

}  // namespace

std::vector<TargetPoint> target_of(const SceneFit& fit) {
    return target_of(fit.reference, {.offset = fit.offset, .from = fit.from, .to = fit.to, .step = fit.step});
}

FittedScene propose_scene(const SceneFit& fit) {
    FittedScene found = begun(fit);
    FitInput input = input_of(fit, found);
    found.lines = texts_of(begin_with_proposal(input, fit.tools));
    found.tuned = input.proposed.value_or(input.start);
    return found;
}

FittedScene fit_scene(const SceneFit& fit, PreviewCurve& curve, const FitCalls& calls) {
    FittedScene found = begun(fit);
    FitInput input = input_of(fit, found);
    const std::vector<ProposalLine> lines = begin_with_proposal(input, fit.tools);
    found.lines = texts_of(fit.tools ? lines : without_moves(lines));
    FitShares shares(fit.colors, calls);
    const auto drawing = [&shares](double share) { return shares.drawing(share); };
    input.draw = [&](const document::Content& tuned, std::span<const double> times) {
        return curve.measure(tuned.scene, tuned.preset, times, {.progress = drawing});
    };
    input.progress = [&shares](const FitProgress& progress) { return shares.stepped(progress); };
    FitColors colors({.reference = fit.reference_colors,
                      .target = found.target,
                      .keys = fit.color_keys,
                      .amidst = [&shares](double) { return shares.drawing(0.0); },
                      .finish = [&shares](double share) { return shares.coloring(share); }},
                     curve);
    if (fit.colors == ColorsOfFit::match)
        input.match_colors = [&colors](const document::Content& tuned) { return colors.amidst(tuned); };
    FitResult& result = found.result.emplace(match::fit(input));
    if (result.proposal_left) {
        found.lines = texts_of(without_moves(lines));
        found.lines.insert(found.lines.begin(), scene_was_nearer(fit.start.scene, input.start.scene).text);
    }
    if (fit.colors == ColorsOfFit::match && !result.after.empty())
        found.colors = colors.finish(result);
    else if (fit.colors != ColorsOfFit::leave && !result.ended_early)
        colors.compare(result, fit.start);
    found.tuned = result.tuned;
    return found;
}

bool add_pictures(FitReport& report, VideoReader& reference, double aspect, PreviewCurve& curve,
                  const Progress& progress, const std::atomic<bool>* stop) {
    const auto draw = [&curve](const document::Content& tuned, double time, glm::ivec2 size) {
        return curve.picture(tuned.scene, tuned.preset, time, size);
    };
    return add_pictures(report, reference, aspect, DrawPicture(draw), progress, stop);
}

}  // namespace lapfx::match
