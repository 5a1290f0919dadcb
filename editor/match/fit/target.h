// What a fit aims at: the measured amounts of the reference at the times at which the scene is drawn and measured.
//
//     Target target = target_of(measured.frames, {.offset = 0.5, .from = 0, .to = 10});
//
// Pure functions, any thread.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "match/estimator.h"

namespace lapfx::match {

/// Of the baseline's texture behind a veil.
inline constexpr double usual_likeness = 0.75;

/// Of one time of the scene. What is not measurable is missing.
struct TargetPoint {
    double time = 0.0;  ///< s of the scene
    std::optional<Amount> blood, veil;
    double likeness = usual_likeness;  ///< FrameAmounts::likeness
};

struct TargetOptions {
    double offset = 0.0;           ///< s; reference time = scene time + offset
    double from = 0.0, to = 12.0;  ///< s of the scene
    double step = 0.2;             ///< s between times, longer where there would be more than `most`
    std::size_t most = 60;         ///< times
};

/// Each is the mean of the frames that are not farther than half a step, and 0.25 s. Times at which the reference has
/// no frame are left out; fewer than two are none at all.
std::vector<TargetPoint> target_of(std::span<const FrameAmounts> reference, const TargetOptions& options);

/// Errors within one video. What the intervals hold beyond these errors is shared by all of its frames (the scale of
/// smoke's light, how the baseline lies), and changes no course: that is `scale_error`, a share of the amount.
struct CourseError {
    /// Standard error of the amount, over about a second: none + share * amount, at most `most`; less where its
    /// interval is narrower, but not below `least`.
    double least, none, share, most;
    double scale_error;
    /// Where smoke hides tissue, an amount may be missed for `hidden_lasts` s, by a share `hidden` of what half of its
    /// interval is above `clear`, at usual_likeness. A search goes by the errors above alone, or it would lose what it
    /// sees dimly; how certain its result is goes by both.
    double clear, hidden, hidden_lasts;
};
/// Veil: known veils over moving clips came back with a root mean square error of 0.024 to 0.066 that lasts up to a
/// second; blood and scales: `lapfx bench measure`, views of its classes "still". What hidden blood is off by was
/// fitted to the 24 films of `lapfx bench fit`: a root mean square of 0.02 to 0.055 for half intervals of 0.065 to
/// 0.18, three quarters of it still there 3 s later.
inline constexpr CourseError blood_course{.least = 0.002,
                                          .none = 0.002,
                                          .share = 0.1,
                                          .most = 0.006,
                                          .scale_error = 0.15,
                                          .clear = 0.012,
                                          .hidden = 0.3,
                                          .hidden_lasts = 3.0},
    veil_course{.least = 0.01,
                .none = 0.03,
                .share = 0.0,
                .most = 0.03,
                .scale_error = 0.12,
                .clear = 0.0,
                .hidden = 0.0,
                .hidden_lasts = 1.0};
/// Standard error of a measured amount beside the others of its video.
double course_error(const Amount& amount, const CourseError& course);
/// How much of it may be missed for seconds: the more, the less of the baseline's texture is seen.
double hidden_error(const Amount& amount, double likeness, const CourseError& course);

/// Root mean square difference to what a scene shows at the same times; nothing where they share no measurable one.
std::optional<double> misfit(std::span<const TargetPoint> target, std::span<const FrameAmounts> shown,
                             std::optional<Amount> TargetPoint::*amount);

}  // namespace lapfx::match
