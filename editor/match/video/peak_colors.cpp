#include "match/video/peak_colors.h"

#include <algorithm>
#include <cmath>

#include "match/video/episode.h"

namespace lapfx::match {

namespace {

/// Of what is seen through smoke, little is blood's light: it has next to no green and blue, and the smoke has.
double clear_blood(const FrameAmounts& amounts) {
    const double clear = std::max(1.0 - amounts.veil.value / dense_veil, 0.0);
    return amounts.blood.value * clear * clear;
}

}  // namespace

void PeakColors::add(const Image& frame, const Estimator* estimator, const FrameAmounts& amounts) {
    if (estimator == nullptr || !amounts.measurable() || !takes(amounts.time)) return;
    const double blood = clear_blood(amounts);
    const bool more_blood = measurable(amounts, Curve::blood) && (!any_blood_ || blood > most_blood_);
    const bool more_veil = measurable(amounts, Curve::veil) && (!any_veil_ || amounts.veil.value > found_.veil.value);
    const bool has_blood = measurable(amounts, Curve::blood) && blood > 0.0;
    if (!has_blood && !more_blood && !more_veil && any_) return;
    const MeasuredColors colors = colors_of(frame, *estimator);
    if (more_blood) any_blood_ = true, most_blood_ = blood, blood_at_ = amounts.time, found_.blood = amounts.blood;
    if (has_blood && colors.blood) add_blood(blood * *colors.blood, blood);
    if (more_veil) {
        any_veil_ = true, found_.veil = amounts.veil, veil_at_ = amounts.time;
        found_.colors.smoke = colors.smoke, found_.colors.tinted = colors.tinted;
    }
    if (!any_) found_.colors.tissue = colors.tissue, first_at_ = amounts.time;
    any_ = true;
}

/// One frame may have taken for blood what another has not.
void PeakColors::add_blood(const glm::dvec3& light, double weight) {
    blood_light_ += light, blood_weight_ += weight;
    found_.colors.blood = blood_light_ / blood_weight_;
}

void PeakColors::add(const PeakColors& part) {
    const ColorsAtPeak& other = part.found_;
    const bool takes_blood = part.any_blood_ && takes(part.blood_at_);
    if (takes_blood && part.blood_weight_ > 0.0) add_blood(part.blood_light_, part.blood_weight_);
    if (takes_blood && (!any_blood_ || part.most_blood_ > most_blood_)) {
        any_blood_ = true, most_blood_ = part.most_blood_, blood_at_ = part.blood_at_;
        found_.blood = other.blood;
    }
    if (part.any_veil_ && takes(part.veil_at_) && (!any_veil_ || other.veil.value > found_.veil.value)) {
        any_veil_ = true, veil_at_ = part.veil_at_, found_.veil = other.veil;
        found_.colors.smoke = other.colors.smoke, found_.colors.tinted = other.colors.tinted;
    }
    if (any_ || !part.any_ || !takes(part.first_at_)) return;
    any_ = true, first_at_ = part.first_at_;
    found_.colors.tissue = other.colors.tissue;
}

void ColorsOverTime::add(const Image& frame, const Estimator* estimator, const FrameAmounts& amounts) {
    parts_[std::llround(std::floor(amounts.time / step))].add(frame, estimator, amounts);
}

ColorsAtPeak ColorsOverTime::at_peak(double from, double to) const {
    PeakColors all(from, to);
    for (const auto& [number, part] : parts_) all.add(part);
    return all.at_peak();
}

}  // namespace lapfx::match
