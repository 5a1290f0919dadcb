#include "match/fit/undetermined.h"

#include <algorithm>
#include <optional>
#include <sstream>

namespace lapfx::match {

namespace {

constexpr double telling_decay = 4.0;  // s of clearing that tell how fast it clears
constexpr double clears_by = 0.15;     // of the peak, below it: clearing has begun
constexpr double still_grows = 0.9;    // of the peak: blood at the end that is above it still grows

constexpr double least_told = 0.25;  // of the moments: with blood in fewer it is not known how it spreads

constexpr double beyond = 1.5;  // standard errors, of the most and of the least

Course course_of(std::span<const TargetPoint> target, std::optional<Amount> TargetPoint::*amount) {
    const CourseError& errors = amount == &TargetPoint::blood  ? blood_course
                                : amount == &TargetPoint::veil ? veil_course
                                                               : plume_course;
    Course course;
    double most_above = 0.0, least_above = 1.0;  // lower end of the amount at its most, upper end at its least
    for (const TargetPoint& aim : target) {
        const std::optional<Amount>& at = aim.*amount;
        if (!at) continue;
        if (!course.any || at->value > course.peak) course.peak = at->value, course.peak_at = aim.time;
        course.last = at->value, course.last_at = aim.time;
        course.any = true;
        const double error = beyond * course_error(*at, errors);
        course.shown = course.shown || at->low > 0.0;
        most_above = std::max(most_above, at->value - error), least_above = std::min(least_above, at->value + error);
    }
    course.changes = course.any && most_above > least_above;
    return course;
}

/// Of the smoke at the tool's tip, which stands out of the veil.
bool is_of_plume(const std::string& key) {
    return key.starts_with("smoke.plume.");
}

std::ptrdiff_t moments_with_blood(std::span<const TargetPoint> target) {
    return std::count_if(target.begin(), target.end(), [](const TargetPoint& aim) { return aim.blood.has_value(); });
}

/// Whether a curve says anything, and if not, why.
std::string without_course(const Course& course, const std::string& amount) {
    if (!course.any) return amount + " of the reference is not measurable";
    if (!course.changes && course.shown)
        return "the " + amount + " of the reference does not change beyond the error of measuring";
    if (!course.changes) return "the reference shows no " + amount + " beyond the error of measuring";
    return {};
}

/// Dense smoke hides blood. Empty where there is none; else how often, to be said after something.
std::string hidden_by_smoke(std::span<const TargetPoint> target) {
    const auto hidden = std::count_if(target.begin(), target.end(), [](const TargetPoint& aim) {
        return aim.veil && aim.veil->value > dense_veil && !aim.blood;
    });
    if (hidden == 0) return {};
    return "; smoke hides it in " + std::to_string(100 * hidden / std::ssize(target)) + " % of the moments";
}

/// The same as without_course() of blood.
std::string without_blood(const Courses& courses, std::span<const TargetPoint> target) {
    const bool unseen = courses.blood.any && !courses.blood_is_seen;
    const std::string why = unseen ? "no bleeding is seen, left as it is" : without_course(courses.blood, "blood");
    return why.empty() ? why : why + hidden_by_smoke(target);
}

}  // namespace

bool too_rare(const std::string& key, std::span<const TargetPoint> target) {
    return key.starts_with("bleeding.") &&
           static_cast<double>(moments_with_blood(target)) < least_told * static_cast<double>(target.size());
}

Courses courses_of(std::span<const TargetPoint> target) {
    return {.blood = course_of(target, &TargetPoint::blood),
            .veil = course_of(target, &TargetPoint::veil),
            .plume = course_of(target, &TargetPoint::plume),
            .blood_is_seen = shows_blood(target)};
}

bool shows_anything_of(const std::string& key, const Courses& courses) {
    if (key.starts_with("bleeding.")) return courses.blood_is_seen && courses.blood.changes;
    if (is_of_plume(key) && courses.plume.changes) return true;
    if (key.starts_with("smoke.")) return courses.veil.changes;
    return true;
}

std::string why_undetermined(std::size_t parameter, const std::vector<FreeParameter>& parameters,
                             const std::vector<Certainty>& certainties, std::span<const TargetPoint> target,
                             const Courses& courses, const Weights& weights) {
    const std::string& key = parameters[parameter].key;
    const Course &blood = courses.blood, &veil = courses.veil;
    if (key.starts_with("bleeding.")) {
        if (weights.blood == 0.0) return "blood does not count, its weight is 0";
        if (blood.any && too_rare(key, target))
            return "blood of the reference is measurable in " + std::to_string(moments_with_blood(target)) + " of " +
                   std::to_string(target.size()) + " moments only" + hidden_by_smoke(target);
        if (const std::string why = without_blood(courses, target); !why.empty()) return why;
        if (key == "bleeding.max_extent" && blood.last > still_grows * blood.peak)
            return "blood still spreads when the video ends; a video of its standstill would tell it";
    }
    if (key.starts_with("smoke.")) {
        if (weights.veil == 0.0) return "the veil does not count, its weight is 0";
        const bool by_plume = is_of_plume(key) && courses.plume.changes;
        if (const std::string why = without_course(veil, "veil"); !by_plume && !why.empty()) return why;
        if (key == "smoke.haze.ventilation" &&
            (veil.last > (1.0 - clears_by) * veil.peak || veil.last_at - veil.peak_at < telling_decay))
            return "the video ends while it still smokes or soon after; 4 s of clearing would tell it";
    }
    if (const int other = certainties[parameter].alike; other >= 0)
        return "it does the same to the curves as " + parameters[static_cast<std::size_t>(other)].key +
               "; hold one of both";
    return "the curves hardly depend on it";
}

std::string where_nearest(const FreeParameter& parameter, double low, double high, bool at_bound) {
    std::ostringstream text;
    text.precision(3);
    text << "it is where the curves are nearest" << (at_bound ? ", at its bound" : "") << "; " << low << " to " << high
         << (parameter.row->unit.empty() ? "" : " ") << parameter.row->unit << " is possible";
    return text.str();
}

}  // namespace lapfx::match
