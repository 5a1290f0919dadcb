// The colours of a measured video: of blood in the frame that has most of it, of smoke in the one with the most veil,
// and of the tissue of the baseline.
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

class PeakColors {
  public:
    /// Of frames at these times of the video, s, both included.
    PeakColors(double from, double to) : from_(from), to_(to) {}

    /// What MeasureOptions::measured gives, in any order. A frame that does not have an amount is none of its peak.
    void add(const Image& frame, const Estimator* estimator, const FrameAmounts& amounts);
    /// The tissue is the baseline's as laid over the first measurable frame.
    const MeasuredColors& found() const { return found_; }

  private:
    double from_, to_;
    double most_blood_ = -1.0, most_veil_ = -1.0;  // less than any amount
    bool any_ = false;
    MeasuredColors found_;
};

}  // namespace lapfx::match
