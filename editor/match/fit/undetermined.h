// Why a reference does not tell a parameter, and what would.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "match/fit/certainty.h"
#include "match/fit/free_parameter.h"
#include "match/fit/target.h"

namespace lapfx::match {

/// One amount of a target over time.
struct Course {
    double peak = 0.0, peak_at = 0.0, last = 0.0, last_at = 0.0;
    bool any = false;      ///< the amount is measurable at all
    bool changes = false;  ///< by more than its error
    bool shown = false;    ///< it is above its error at some time
};
struct Courses {
    Course blood = {}, veil = {}, plume = {};
    bool blood_is_seen = false;  ///< shows_blood()
};
Courses courses_of(std::span<const TargetPoint> target);

/// False for a parameter of blood or of smoke where the target's blood is not seen, or it or the veil does not change
/// beyond its error; of the plume, where what stands out of the veil does not, either.
bool shows_anything_of(const std::string& key, const Courses& courses);

/// True for a parameter of blood where blood is measurable in less than a quarter of the target's moments: what the
/// curves tell of it then is found, but not known.
bool too_rare(const std::string& key, std::span<const TargetPoint> target);

/// Why, of what would be known if smoke hid no blood.
inline constexpr std::string_view behind_smoke =
    "smoke may hide blood while it spreads; a video with less smoke in front of it would tell it";

/// `courses`: those of the target. For people, one sentence without a full stop: "the video ends while it still smokes;
/// 4 s of clearing would tell it".
std::string why_undetermined(std::size_t parameter, const std::vector<FreeParameter>& parameters,
                             const std::vector<Certainty>& certainties, std::span<const TargetPoint> target,
                             const Courses& courses, const Weights& weights = {});

/// What is said beside that of one that does not keep its value: "it is where the curves are nearest; 2 to 14 mm/s is
/// possible". `low` to `high`: its 90 % interval.
std::string where_nearest(const FreeParameter& parameter, double low, double high, bool at_bound);

}  // namespace lapfx::match
