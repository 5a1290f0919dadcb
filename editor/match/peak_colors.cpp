#include "match/peak_colors.h"

#include "match/episode.h"

namespace lapfx::match {

void PeakColors::add(const Image& frame, const Estimator* estimator, const FrameAmounts& amounts) {
    if (estimator == nullptr || !amounts.measurable() || amounts.time < from_ || amounts.time > to_) return;
    const bool more_blood = measurable(amounts, Curve::blood) && amounts.blood.value > most_blood_;
    const bool more_veil = measurable(amounts, Curve::veil) && amounts.veil.value > most_veil_;
    if (!more_blood && !more_veil && any_) return;
    const MeasuredColors colors = colors_of(frame, *estimator);
    if (more_blood) most_blood_ = amounts.blood.value, found_.blood = colors.blood;
    if (more_veil) most_veil_ = amounts.veil.value, found_.smoke = colors.smoke;
    if (!any_) found_.tissue = colors.tissue;
    any_ = true;
}

}  // namespace lapfx::match
