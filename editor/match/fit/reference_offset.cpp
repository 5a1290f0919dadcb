#include "match/fit/reference_offset.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

#include "match/compare/joined.h"
#include "match/compare/likeness.h"

namespace lapfx::match {

namespace {

constexpr double least_shift = 0.5;  // s: two onsets are not known to less
constexpr double as_late = 0.4;      // s: how far the shifts of blood and veil may be apart that are one
constexpr double nearer = 0.5;       // of the difference before: what a shift leaves that explains it

struct Shifted {
    const char* name;
    std::optional<Amount> TargetPoint::*aim;
    Amount FrameAmounts::*shown;
    AmountLikeness Likeness::*likeness;
};
constexpr Shifted blood_amount{"blood", &TargetPoint::blood, &FrameAmounts::blood, &Likeness::blood};
constexpr Shifted veil_amount{"veil", &TargetPoint::veil, &FrameAmounts::veil, &Likeness::veil};

std::vector<FrameAmounts> frames_with(std::span<const TargetPoint> target, const Shifted& amount) {
    std::vector<FrameAmounts> frames;
    for (const TargetPoint& aim : target) {
        if (!(aim.*amount.aim)) continue;
        FrameAmounts& frame = frames.emplace_back();
        frame.time = aim.time;
        frame.*amount.shown = *(aim.*amount.aim);
    }
    return frames;
}

/// s by which the reference is later than the scene, where that explains most of what they differ by.
std::optional<double> later_by(std::span<const TargetPoint> target, std::span<const FrameAmounts> scene,
                               const Shifted& amount) {
    const std::vector<FrameAmounts> reference = frames_with(target, amount);
    const AmountLikeness as_it_is = likeness_of(scene, reference, 0.0).*amount.likeness;
    if (!as_it_is.late) return {};
    const double later = -*as_it_is.late;
    const AmountLikeness shifted = likeness_of(scene, reference, later).*amount.likeness;
    if (!shifted.rms || *shifted.rms > nearer * *as_it_is.rms) return {};
    return later;
}

std::string shift_text(const std::vector<std::string>& names, double later) {
    char text[160];
    const char* const comes = names.size() == 1 ? "comes" : "come";
    std::snprintf(text, sizeof text, " of the reference %s %.1f s %s than the scene's: an offset that is %.1f s %s ",
                  comes, std::abs(later), later > 0.0 ? "later" : "earlier", std::abs(later),
                  later > 0.0 ? "more" : "less");
    return "reference.offset: " + joined(names) + text + "brings them together instead of moving tools";
}

}  // namespace

std::string told_of_offset(std::span<const TargetPoint> target, const Courses& courses,
                           std::span<const FrameAmounts> scene) {
    std::vector<Shifted> changing;
    std::vector<std::string> shown, names;
    if (courses.blood_is_seen) shown.emplace_back("blood");
    if (courses.veil.shown) shown.emplace_back("veil");
    if (courses.blood_is_seen && courses.blood.changes) changing.push_back(blood_amount);
    if (courses.veil.changes) changing.push_back(veil_amount);
    if (changing.empty() && !courses.plume.changes && !shown.empty())
        return "reference.offset: not determined, " + joined(shown) + " of the reference " +
               (shown.size() == 1 ? "does" : "do") +
               " not change beyond the error of measuring, so any fits as well; hold a frame of the reference and "
               "align it by eye";
    std::vector<double> shifts;
    for (const Shifted& amount : changing) {
        const std::optional<double> later = later_by(target, scene, amount);
        if (!later) return {};
        shifts.push_back(*later), names.emplace_back(amount.name);
    }
    if (shifts.empty()) return {};
    const auto [least, most] = std::ranges::minmax(shifts);
    const double later = 0.5 * (least + most);
    if (most - least > as_late || std::abs(later) < least_shift) return {};
    return shift_text(names, later);
}

}  // namespace lapfx::match
