// How well the reference tells each fitted parameter: an interval, and whether it tells it at all.
//
// Blocks of at least a second are drawn again and again, each as often as chance wills (block bootstrap; errors of
// neighbouring frames go together), and the fit is corrected for each such reference by one linear step; where the
// errors of measuring a video allow more than that, they count; and those of its scales, which no course shows, are
// added. So the intervals are to hold 90 %. Pure, any thread.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "match/fit/objective.h"
#include "match/fit/search.h"

namespace lapfx::match {

struct Certainty {
    double low = 0.0, high = 0.0;  ///< coordinates: 5 % and 95 %
    double error = 0.0;            ///< standard error, coordinates; but with Errors::of_course with that of the scales
    bool determined = false;       ///< it is known to within a factor of about two
    int alike = -1;                ///< another parameter that does the same to the curves; -1: none
};

/// Which errors of the amounts count; each with those before it.
enum class Errors {
    of_course,  ///< those a search goes by; that of the scales counts in the interval alone
    with_scales,
    with_hidden  ///< with the blood that smoke may hide (TargetPoint::hidden_blood)
};

/// Of each parameter at `coordinates`, where the fit ended. `seed`: of the chance.
std::vector<Certainty> certainty_of(const Objective& objective, const Linearised& linear,
                                    std::span<const double> coordinates, Errors errors, std::uint32_t seed);

}  // namespace lapfx::match
