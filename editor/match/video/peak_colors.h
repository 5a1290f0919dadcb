// The colours of a measured video: of blood in all frames that show it, those with most of it behind little smoke
// above all, of smoke in the one with the most veil, and of the tissue of the baseline.
//
//     match::PeakColors colors(2.0, 8.0);
//     options.measured = [&colors](const Image& frame, const Estimator* estimator, const FrameAmounts& amounts) {
//         colors.add(frame, estimator, amounts);
//     };
//     match::measure(video, options);
//     const match::ColorLikeness likeness = likeness_of(colors.found(), others.found());
//
// Keeps the means alone, no picture. One thread at a time.
#pragma once

#include <cstdint>
#include <limits>
#include <map>

#include "match/frame/measured_colors.h"

namespace lapfx::match {

/// With the amounts of the frames that have most clear blood, and veil: how far their colours can be told.
struct ColorsAtPeak {
    MeasuredColors colors = {};
    Amount blood = {}, veil = {};  ///< there; 0: it is not measurable
};

class PeakColors {
  public:
    PeakColors() = default;
    /// Of frames at these times of the video, s, both included.
    PeakColors(double from, double to) : from_(from), to_(to) {}

    /// What MeasureOptions::measured gives, in any order. A frame that does not have an amount is none of its peak.
    void add(const Image& frame, const Estimator* estimator, const FrameAmounts& amounts);
    /// What was found in a later part of the same video: parts ascend in time.
    void add(const PeakColors& part);
    /// The tissue is the baseline's as laid over the first measurable frame.
    const MeasuredColors& found() const { return found_.colors; }
    const ColorsAtPeak& at_peak() const { return found_; }

  private:
    void add_blood(const glm::dvec3& light, double weight);
    bool takes(double time) const { return time >= from_ && time <= to_; }

    double from_ = -std::numeric_limits<double>::infinity(), to_ = std::numeric_limits<double>::infinity();
    bool any_ = false, any_blood_ = false, any_veil_ = false;
    double first_at_ = 0.0, blood_at_ = 0.0, veil_at_ = 0.0;  // s, of the frames that they are of
    double most_blood_ = 0.0;
    glm::dvec3 blood_light_{0.0};  // of the frames, each times its weight
    double blood_weight_ = 0.0;
    ColorsAtPeak found_;
};

/// Those of a whole video, of which any part is asked for afterwards. One thread at a time.
class ColorsOverTime {
  public:
    static constexpr double step = 0.2;  ///< s; of so long a part its peaks alone are kept

    void add(const Image& frame, const Estimator* estimator, const FrameAmounts& amounts);
    /// Of frames at these times of the video, s, both included. At either end those are missed that share a step with
    /// more blood, or veil, beyond that end.
    ColorsAtPeak at_peak(double from, double to) const;

  private:
    std::map<std::int64_t, PeakColors> parts_;
};

}  // namespace lapfx::match
