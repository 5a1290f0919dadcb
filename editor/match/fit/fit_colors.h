// The colours of a fit: --colors of lapfx fit, and Colours of the editor's Fit. What is measured of smoke depends on
// its colour, so they are matched as soon as the amounts are near, and once more at the end.
//
//     FitColors colors({.reference = peaks.at_peak(), .target = target}, curve);
//     input.match_colors = [&](const document::Content& tuned) { return colors.amidst(tuned); };
//     FitResult result = fit(input);
//     const std::vector<std::string> lines = colors.finish(result);
//
// The thread that asks `curve` for its pictures.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lapfx/progress.h"
#include "match/fit/color_match.h"
#include "match/fit/fit.h"

namespace lapfx::match {

struct ColorFit {
    ColorsAtPeak reference = {};  ///< measured in the video
    std::span<const TargetPoint> target = {};
    std::vector<std::string> keys = {color_keys().begin(), color_keys().end()};  ///< that are free
    Progress amidst = {};  ///< called while the fit is under way; false ends it
    Progress finish = {};  ///< of what is drawn at the end, about; false ends it with the best so far
};

class FitColors {
  public:
    FitColors(ColorFit input, PreviewCurve& curve) : input_(std::move(input)), curve_(&curve) {}

    /// For FitInput::match_colors. Throws as PreviewCurve::measure().
    std::optional<document::Content> amidst(const document::Content& tuned);
    /// What was found becomes the result's, with its curves. Lines for people, of the differences and of what was
    /// changed. Throws as PreviewCurve::measure().
    std::vector<std::string> finish(FitResult& result);
    /// Where no colour was to be matched: how far they are from the reference's before and after, since amounts change
    /// them, too. `before`: without the proposal. Missing where it was ended. Throws as PreviewCurve::measure().
    void compare(FitResult& result, const document::Content& before);

  private:
    ColorMatch match(const document::Content& start, std::vector<std::string> keys,
                     const std::function<bool(int drawn, double share)>& progress);
    std::vector<std::string> ended_lines(const FitResult& result) const;
    bool draw_again(FitResult& result, const Progress& progress);

    ColorFit input_;
    PreviewCurve* curve_;
    std::optional<ColorMatch> begun_;
};

}  // namespace lapfx::match
