// One amount over the scene's time as SVG, for the report of a fit: the reference with its interval as a band, the
// scene before and after.
//
//     html += amount_plot(target, result, amount_names[0], 0.0, 6.0);
//
// Its looks are classes of the report's style (report_style.h). Lines differ in dashes and width, not by colour alone.
// Pure function, any thread; nothing throws.
#pragma once

#include <span>
#include <string>

#include "match/fit/fit.h"
#include "match/frame/frame_amounts.h"

namespace lapfx::match {

/// How an amount is named in a report.
struct AmountName {
    Curve curve;
    const char* key;   ///< of ids and classes: "blood"
    const char* name;  ///< "Blood"
    const char* axis;  ///< what its axis says: "Share of the view, %"
    std::optional<Amount> TargetPoint::*aim;
    Amount FrameAmounts::*shown;
    std::optional<double> FitResult::*before;  ///< root mean square differences
    std::optional<double> FitResult::*after;
};
inline constexpr AmountName amount_names[] = {
    {Curve::blood, "blood", "Blood", "Share of the view, %", &TargetPoint::blood, &FrameAmounts::blood,
     &FitResult::blood_before, &FitResult::blood_after},
    {Curve::veil, "veil", "Veil", "Mean over the view, %", &TargetPoint::veil, &FrameAmounts::veil,
     &FitResult::veil_before, &FitResult::veil_after},
};

/// Where a plot stands.
struct PlotPlace {
    std::string id = {};       ///< before its ids, which are once in a page: "item-3-"
    std::string of = "scene";  ///< whose time it is: "scene", "video"
    bool compared = true;      ///< else there is the reference alone
};

/// The element <svg>, with title and description for who does not see it. `from`, `to`: s, the axis. What
/// is not measurable is shaded, and no line goes across it.
std::string amount_plot(std::span<const TargetPoint> target, const FitResult& result, const AmountName& amount,
                        double from, double to, const PlotPlace& place = {});

}  // namespace lapfx::match
