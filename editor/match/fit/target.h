// What a fit aims at: the measured amounts of the reference at the times at which the scene is drawn and measured.
//
//     Target target = target_of(measured.frames, {.offset = 0.5, .from = 0, .to = 10});
//
// Pure functions, any thread.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "match/frame/frame_amounts.h"

namespace lapfx::match {

/// Of one time of the scene. What is not measurable is missing.
struct TargetPoint {
    double time = 0.0;  ///< s of the scene
    std::optional<Amount> blood = {}, veil = {}, plume = {};
    /// How much blood may be missed behind smoke, a standard error beside course_error(): the more, the thicker the
    /// smoke and the less of the baseline's texture is there.
    double hidden_blood = 0.0;
};
/// Hidden blood is alike for so many s: a course of it tells as much as one moment of each of them would. It and its
/// amount were fitted to the 24 films of `lapfx bench fit --seed 1`: a root mean square of a tenth of the veil where a
/// quarter of the texture is missing, correlated by 0.8, 0.6, 0.3 and 0.1 after 1, 5, 7 and 9 s.
inline constexpr double hidden_blood_lasts = 10.0;

struct TargetOptions {
    double offset = 0.0;           ///< s; reference time = scene time + offset
    double from = 0.0, to = 12.0;  ///< s of the scene
    double step = 0.2;             ///< s between times, longer where there would be more than `most`
    std::size_t most = 60;         ///< times
};

/// Each is the mean of the frames that are not farther than half a step, and 0.25 s. Times at which the reference has
/// no frame are left out; fewer than two are none at all.
std::vector<TargetPoint> target_of(std::span<const FrameAmounts> reference, const TargetOptions& options);

/// Times of the scene from `from` to `to` at which it is held against the reference: those of target_of(), but no
/// farther apart than what lies between can be told from (longest_gap). Empty where they share no two moments.
std::vector<double> compared_times(std::span<const FrameAmounts> reference, double offset, double from, double to);

/// Errors within one video. What the intervals hold beyond these errors is shared by all of its frames (the scale of
/// smoke's light, how the baseline lies), and changes no course: that is `scale_error`, a share of the amount.
struct CourseError {
    /// Standard error of the amount, over about a second: none + share * amount, at most `most`; less where its
    /// interval is narrower, but not below `least`.
    double least, none, share, most;
    double scale_error;
};
/// Veil: known veils over moving clips came back with a root mean square error of 0.024 to 0.066 that lasts up to a
/// second; blood and scales: `lapfx bench measure`, views of its classes "still".
inline constexpr CourseError blood_course{0.002, 0.002, 0.1, 0.006, 0.15}, veil_course{0.01, 0.03, 0.0, 0.03, 0.12};
/// What stands out of a veil: where nothing smokes it is told as 0 to 0.01 in real frames whose tissue moves.
inline constexpr CourseError plume_course{0.002, 0.005, 0.2, 0.02, 0.25};
/// Standard error of a measured amount beside the others of its video.
double course_error(const Amount& amount, const CourseError& course);

/// Whether blood is seen: its interval stays above 0 for a second, times at which it is not measurable apart. What is
/// taken for blood by mistake seldom does. Where it is not seen, all that is measured of it may be noise, and a fit has
/// nothing to aim at.
bool shows_blood(std::span<const TargetPoint> target);

/// Root mean square difference to what a scene shows at the same times; nothing where they share no measurable one.
std::optional<double> misfit(std::span<const TargetPoint> target, std::span<const FrameAmounts> shown,
                             std::optional<Amount> TargetPoint::*amount);

}  // namespace lapfx::match
