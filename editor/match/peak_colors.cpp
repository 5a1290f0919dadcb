#include "match/peak_colors.h"

#include <algorithm>

#include "match/episode.h"

namespace lapfx::match {

namespace {

/// Of what is seen through smoke, little is blood's light: it has next to no green and blue, and the smoke has.
double clear_blood(const FrameAmounts& amounts) {
    const double clear = std::max(1.0 - amounts.veil.value / dense_veil, 0.0);
    return amounts.blood.value * clear * clear;
}

}  // namespace

void PeakColors::add(const Image& frame, const Estimator* estimator, const FrameAmounts& amounts) {
    if (estimator == nullptr || !amounts.measurable() || amounts.time < from_ || amounts.time > to_) return;
    const double blood = clear_blood(amounts);
    const bool more_blood = measurable(amounts, Curve::blood) && (!any_blood_ || blood > most_blood_);
    const bool more_veil = measurable(amounts, Curve::veil) && (!any_veil_ || amounts.veil.value > found_.veil.value);
    if (!more_blood && !more_veil && any_) return;
    const MeasuredColors colors = colors_of(frame, *estimator);
    if (more_blood) {
        any_blood_ = true, most_blood_ = blood;
        found_.blood = amounts.blood, found_.colors.blood = colors.blood;
    }
    if (more_veil) {
        any_veil_ = true, found_.veil = amounts.veil;
        found_.colors.smoke = colors.smoke, found_.colors.tinted = colors.tinted;
    }
    if (!any_) found_.colors.tissue = colors.tissue;
    any_ = true;
}

}  // namespace lapfx::match
