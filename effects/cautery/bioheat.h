// Heat under the tool by Pennes' bio-heat equation, in steps at the multiples of `step` s. The state at a step depends
// only on the contacts before it; going back in time starts from the nearest snapshot. Work is proportional to the
// heated region, not to the organ. Formulas: effects/cautery/parameters.cpp. One thread at a time.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "cautery/diffusion.h"
#include "cautery/track.h"
#include "cautery/wound_list.h"

namespace lapfx::cautery {

class Bioheat {
  public:
    static constexpr double step = 0.01;  ///< s
    static constexpr double forgotten =
        60.0;  ///< s after the last heating at which tissue has the body's temperature again

    /// Keeps references to the surface and to strength_at.
    Bioheat(const Surface& surface, const StrengthAt& strength_at, SealedAt sealed_at);

    /// Starts again with these parameters.
    void reset(const CauteryParameters& parameters);
    /// The track's contacts, or the clips, have changed at and after `time`.
    void changed_from(double time);
    /// Goes to the state at `time`: that of the first step at or after it.
    void seek(const Track& track, double time);

    /// Degrees Celsius at `place`, at the time of the last seek.
    double temperature(const SurfacePoint& place) const;
    /// Per point: the highest rise, degrees above the body, not bounded, and 0..1 divided by heat.
    double peak(std::uint32_t point) const;
    double divided(std::uint32_t point) const { return divided_[point]; }
    /// Points whose marks have changed since the last call; valid until the next seek.
    const std::vector<std::uint32_t>& changed() const { return changed_; }
    void take_changed();
    /// All points that have, or had, marks.
    const std::vector<std::uint32_t>& touched() const { return touched_; }

    const WoundList& wounds() const { return wounds_; }
    void seal_wounds() { wounds_.seal(); }  ///< call it after a change of the clips
    /// Points in play now.
    std::size_t active() const { return heat_.field().points.size(); }

  private:
    struct Mark {
        std::uint32_t point;
        float peak, divided;
    };
    static constexpr std::int64_t most_undone = 32;  // a power of two

    /// What a tip may yet divide.
    struct Pending {
        std::uint32_t place, stay;
    };
    struct Snapshot {
        std::int64_t step = 0;
        Diffusion::Field field;
        std::vector<Mark> marks;
        std::vector<Pending> pending;
    };
    struct Running {
        std::uint32_t stay;
        glm::dvec3 tip;
    };

    void forget_marks();
    void set_mark(std::uint32_t point, float peak, float divided);
    void restore(const Snapshot& snapshot);
    void go_back(std::int64_t to);
    Snapshot& recent(std::int64_t at) { return recent_[static_cast<std::size_t>(at & (most_undone - 1))]; }
    void keep_snapshot();
    void advance(const Track& track);
    bool cold_at(const Track& track, double time) const;
    void find_running(const Track& track, double from, double to);
    void heat_under(const Stay& stay, const glm::dvec3& tip, double from, double to);
    void divide(const Track& track, double from);
    void open_cold(const Stay& stay, const Track& track, double from, double to);
    void close_wounds(const Track& track, double from);
    void record_peaks();

    const Surface& surface_;
    const StrengthAt& strength_at_;
    CauteryParameters parameters_;
    Diffusion heat_;
    std::vector<float> peak_, divided_;   // per point
    std::vector<std::uint32_t> touched_;  // points where one of them is not 0, or was
    std::vector<Pending> pending_;
    std::int64_t step_ = 0;
    bool started_ = false;                                              // step_ means something
    std::int64_t furthest_ = std::numeric_limits<std::int64_t>::min();  // step up to which the wounds are known
    double at_ = 0.0;                                                   // s, of the last seek

    std::vector<Snapshot> snapshots_;  // the index is the step
    std::int64_t interval_ = 64;       // steps between snapshots
    // The states before each of the last steps, for live use, where the newest contact still changes. They keep only
    // the marks that the step has changed.
    std::vector<Snapshot> recent_;  // a ring, by step
    std::int64_t can_undo_ = 0;     // so many steps

    WoundList wounds_;
    std::vector<Division> opened_;
    std::vector<Running> running_;
    std::vector<std::uint32_t> near_, changed_;
    std::vector<char> is_touched_, is_changed_;  // per point
};

}  // namespace lapfx::cautery
