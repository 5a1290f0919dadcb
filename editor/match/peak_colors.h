// The colours of a measured video: of blood in the frame that has most of it behind little smoke, of smoke in the one
// with the most veil, and of the tissue of the baseline.
//
//     match::PeakColors colors(2.0, 8.0);
//     options.measured = [&colors](Image& frame, const Estimator* estimator, const FrameAmounts& amounts) {
//         colors.add(frame, estimator, amounts);
//     };
//     match::measure(video, options);
//     const match::ColorLikeness likeness = likeness_of(colors.found(), others.found());
//
// Keeps the means alone, no picture. One thread at a time.
#pragma once

#include "match/color_likeness.h"

namespace lapfx::match {

/// With the amounts of the frames that blood and smoke were taken from: how far their colours can be told.
struct ColorsAtPeak {
    MeasuredColors colors = {};
    Amount blood = {}, veil = {};  ///< there; 0: it is not measurable
};

class PeakColors {
  public:
    /// Of frames at these times of the video, s, both included.
    PeakColors(double from, double to) : from_(from), to_(to) {}

    /// What MeasureOptions::measured gives, in any order. A frame that does not have an amount is none of its peak.
    void add(const Image& frame, const Estimator* estimator, const FrameAmounts& amounts);
    /// The tissue is the baseline's as laid over the first measurable frame.
    const MeasuredColors& found() const { return found_.colors; }
    const ColorsAtPeak& at_peak() const { return found_; }

  private:
    double from_, to_;
    bool any_ = false, any_blood_ = false, any_veil_ = false;
    double most_blood_ = 0.0;
    ColorsAtPeak found_;
};

}  // namespace lapfx::match
