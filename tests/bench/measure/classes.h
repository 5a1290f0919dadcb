// The classes of pictures that `lapfx bench measure` tells apart, and the bounds of each: one row each.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "bench/measure/figures.h"
#include "bench/report.h"

namespace lapfx::bench {

/// A picture whose amounts are known, and what was measured in it.
struct MeasuredPicture {
    int view = 0;  ///< pictures of one view have the same baseline
    bool real = false, moves = false, shifted = false;
    bool labelled = false;  ///< a person said where its blood is; its veil is not known
    int by_strokes = 0;     ///< its blood is told by strokes over so many frames (by_strokes.h); 0: by the baseline
    std::map<std::string, std::string> labels;
    double true_blood = 0.0, true_veil = 0.0;
    std::optional<double> dice;  ///< of blood; none where next to nothing is there
    double hazeness = 0.0;       ///< without a baseline: match::hazeness_of
    match::FrameAmounts measured;
};

enum class Asked {
    amount,  ///< how far it is from the true one
    order,   ///< whether more of it reads as more: no level is claimed
    told     ///< whether it is said not to be measurable
};

struct PictureClass {
    std::string_view key;   ///< in JSON: "veil_still"
    std::string_view name;  ///< in the table
    Asked asked = Asked::amount;
    bool (*holds)(const MeasuredPicture&);
    /// Also where the picture is told not to be measurable.
    Reading (*reading)(const MeasuredPicture&);
    /// Whether the picture is told to be measurable.
    bool (*measurable)(const MeasuredPicture&);
    std::span<const Bound> bounds = {};  ///< none: the figures are for information
    /// Share of the pictures that has to be measured at least: those that are refused have no error.
    double least_measured = 0.9;
};
std::span<const PictureClass> picture_classes();

/// Count, not_measurable, and what figures_of() and the class say: of an order the correlation alone, of what is to be
/// told the share that was. Of amounts also raw_mean_absolute_error and raw_zero_error: of all pictures, those that are
/// told not to be measurable, too.
Figures figures_of(const PictureClass& of, std::span<const MeasuredPicture> pictures);
/// Whether a class with bounds keeps them, and enough of its pictures were measured.
bool meets(const PictureClass& of, const Figures& figures);

/// Labels of which one value at a time is left out.
struct LabelRow {
    std::string_view label;
    bool real;
};
inline constexpr LabelRow left_out_labels[] = {
    {"organ", false}, {"light", false}, {"camera", false}, {"operation", true}};
inline constexpr Bound interval_bounds[] = {{"coverage", 0.85, true}, {"coverage", 0.95}};
/// Adds a row and a line of each class, of renders or of real frames, and of the intervals.
void add_classes(BenchReport& report, std::span<const MeasuredPicture> pictures, bool real);

}  // namespace lapfx::bench
