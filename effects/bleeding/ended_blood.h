// The blood of wounds whose flow has ended and that have clotted, of all of them as one layer: where suction comes back
// to old blood, a place costs the same however many wounds have bled there.
//
// Such a wound adds nothing after a clearing, so the clearing only caps what lies there, and the largest value of many
// capped wounds is the largest value, capped. Clearings from before the end of the latest of these wounds are in the
// values; those from since() on are looked up. Whoever adds a wound has to see to it that no sweep that began before
// since() is still running or comes later. One thread at a time.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "bleeding/clearing.h"

namespace lapfx::bleeding {

class EndedBlood {
  public:
    static constexpr double never = -std::numeric_limits<double>::infinity();  // s

    EndedBlood(std::size_t points, float dry) : values_(points, dry), dry_(dry) {}

    /// Dry at all points from now on.
    void reset(float dry) {
        dry_ = dry;
        std::fill(values_.begin(), values_.end(), dry);
        since_ = never;
    }
    /// The same where only `touched` points are not dry.
    void reset(std::span<const std::uint32_t> touched) noexcept {
        for (const std::uint32_t point : touched) values_[point] = dry_;
        since_ = never;
    }

    /// s; no wound of these has flowed from then on.
    double since() const { return since_; }
    /// Before wounds are added that end at `time`: what was cleared until then goes into the values.
    void advance(double time, const Clearing& clearing) noexcept {
        if (!(time > since_)) return;
        if (since_ != never)  // else all is dry
            for (const std::uint32_t point : clearing.finished_places())
                clearing.for_each(point, [&](const Clearing::Cap& cap) {
                    if (cap.time >= since_ && cap.time < time) cover(values_[point], cap.cap);
                });
        since_ = time;
    }
    /// `value`: of one wound, with what was cleared before since().
    void add(std::uint32_t point, float value) noexcept { values_[point] = std::max(values_[point], value); }

    /// mm; dry where there is none.
    float at(std::uint32_t point, const Clearing& clearing) const noexcept {
        float value = values_[point];
        if (value > dry_)
            clearing.for_each(point, [&](const Clearing::Cap& cap) {
                if (cap.time >= since_) cover(value, cap.cap);
            });
        return value;
    }

  private:
    void cover(float& value, float cap) const noexcept { value = std::max(std::min(value, cap), dry_); }

    std::vector<float> values_;  // per point of the surface, mm
    float dry_;
    double since_ = never;
};

}  // namespace lapfx::bleeding
