#include "match/peak_colors.h"

#include "match/episode.h"

namespace lapfx::match {

void PeakColors::add(const Image& frame, const Estimator* estimator, const FrameAmounts& amounts) {
    if (estimator == nullptr || !amounts.measurable() || amounts.time < from_ || amounts.time > to_) return;
    const bool more_blood =
        measurable(amounts, Curve::blood) && (!any_blood_ || amounts.blood.value > found_.blood.value);
    const bool more_veil = measurable(amounts, Curve::veil) && (!any_veil_ || amounts.veil.value > found_.veil.value);
    if (!more_blood && !more_veil && any_) return;
    const MeasuredColors colors = colors_of(frame, *estimator);
    if (more_blood) any_blood_ = true, found_.blood = amounts.blood, found_.colors.blood = colors.blood;
    if (more_veil) {
        any_veil_ = true, found_.veil = amounts.veil;
        found_.colors.smoke = colors.smoke, found_.colors.tinted = colors.tinted;
    }
    if (!any_) found_.colors.tissue = colors.tissue;
    any_ = true;
}

}  // namespace lapfx::match
