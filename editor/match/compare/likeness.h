// How close the preview's amounts are to those of the reference, in figures and in one line of words.
//
//     const match::Likeness likeness = match::likeness_of(preview, measurement.frames, scene.reference.offset);
//     std::cout << in_words(likeness) << '\n';   // veil comes 1.2 s too late and is 30 % too thin; blood matches ...
//
// Both curves are measured by the same estimator (estimator.h), and each measured amount has its interval; what is no
// farther apart than both intervals allow is said to match. Only times are compared at which both are measurable, and
// all figures, those of the episodes too, are of these times: the preview is taken at the times of the reference's
// frames, on the line between its own frames near by. Colours: color_likeness.h.
// Pure functions, any thread; nothing throws.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "match/video/episode.h"

namespace lapfx::match {

/// s between two frames of the preview up to which an amount is told between them.
inline constexpr double longest_gap = 0.5;

/// Joint error of measuring, as a share of the view, up to which two amounts that do not differ by more are said to
/// match; of an amount whose peaks are high, that share of the higher one, if it is more. Beyond it nobody can tell.
inline constexpr double most_error = 0.1, most_error_of_peak = 0.5;
/// Share of the view: where the higher peak is more than that, nobody can tell either once the joint error is more than
/// that peak, for then the amount and none at all are alike. Two amounts that are about none do match.
inline constexpr double told_peak = 0.02;

enum class Presence : std::uint8_t {
    shown,         ///< it changes, or mostly is above 0, beyond the error of measuring
    none,          ///< it may be 0 all the time
    unmeasurable,  ///< most frames do not have it: nothing is known
};

/// One amount. Differences are preview - reference, ratios preview / reference. What the curves do not tell is missing.
struct AmountLikeness {
    int frames = 0;        ///< of the reference that are compared
    double seconds = 0.0;  ///< that they stand for: each half way to its neighbours, at most half of longest_gap

    std::optional<double> rms;   ///< root mean square of the difference over time, as the amount 0..1
    std::optional<double> bias;  ///< its mean, -1..1
    /// Root mean square of the difference over the joint error: the root of both squared half widths of intervals, of
    /// each that half which faces the other. Up to 1: within the error of measuring.
    std::optional<double> rms_over_error;
    std::optional<double> peak_over_error;  ///< the same of the two peaks, 0 or more
    std::optional<double> error;            ///< root mean square of the joint error over time, as the amount 0..1
    /// Mean over time of the larger of the two half widths that face each other, as the amount 0..1.
    std::optional<double> larger_error;

    Presence in_preview = Presence::unmeasurable, in_reference = Presence::unmeasurable;
    /// Of the times that are compared, in the scene's time; empty where either has too few frames with the amount.
    Episode preview, reference;

    /// s by which the preview is late (+) or early (-): from the two onsets; where a curve has none, as one that falls
    /// from its start, the shift up to farthest_shift by which the reference, scaled and levelled, leaves least of the
    /// preview unexplained. Nothing where not both change, or where all shifts explain alike.
    std::optional<double> late;
    /// Of the peaks, and of the areas under the curves over the same time, thus of the means; 0.7: 30 % too little.
    /// Nothing where the reference shows none.
    std::optional<double> peak_ratio, area_ratio;
    std::optional<double> rise_difference;   ///< s, +: the preview rises too slowly
    std::optional<double> decay_difference;  ///< s, +: the preview falls too slowly

    /// Shown by one and not by the other, whose error is so large that it is yet measured higher: it cannot be missing.
    bool lost_in_error() const;
    /// Shown by one, not by the other, and more than the error of measuring between.
    bool missing_in_preview() const;
    bool missing_in_reference() const;
    /// Both are measurable, and curve and peak differ by no more than the error of measuring. Of an amount that neither
    /// shows the peak is noise.
    bool within_error() const;
    /// They are, but so large is the error that entirely different pictures, or one with the amount and one without,
    /// would be, too: nothing is known.
    bool cannot_tell() const;
    /// Of what cannot be told: which has more. The joint error takes those of both for independent, but both come from
    /// the same estimator, by the same strokes, and so they are partly the same error, which no difference has. How
    /// much of it is, nobody knows: a mean difference beyond the larger of both is seen, but its size is not known.
    bool seen_apart() const { return cannot_tell() && std::abs(bias.value_or(0.0)) > larger_error.value_or(0.0); }
    bool matches() const { return within_error() && !cannot_tell(); }
};

/// s, how far late is looked for by shifting.
inline constexpr double farthest_shift = 10.0;

struct Likeness {
    std::optional<double> overlap;  ///< s, the time that both curves span, measurable or not; nothing: none
    AmountLikeness blood, veil;
};

/// Frames ascend in time. The preview's time is that of the scene, the reference's is that + `offset`, s.
Likeness likeness_of(std::span<const FrameAmounts> preview, std::span<const FrameAmounts> reference, double offset);

/// One plain line without a full stop: what differs first, then what nobody can tell, what matches last.
std::string in_words(const Likeness& likeness);

}  // namespace lapfx::match
