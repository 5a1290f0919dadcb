// Source value of a wound over time, in closed form (paper: "the vertex animation value is incremented
// proportionally to the appropriate bleeding speed ... controlled by an upper threshold"). Pure; any thread.
#pragma once

#include <limits>
#include <vector>

#include "lapfx/bleeding_parameters.h"
#include "lapfx/wound.h"
#include "preset/factor_curve.h"

namespace lapfx::bleeding {

/// Clotted blood draws together by this share of its extent.
inline constexpr double clot_shrink = 0.05;

/// The factor on bleeding over time (lapfx/curves.h), prepared for the pulse of a preset: the flow of a wound is its
/// integral.
class Strength {
  public:
    /// 1 all the time.
    Strength() = default;
    Strength(FactorCurve curve, const BleedingParameters& bleeding);

    bool even() const { return curve_.even(); }
    const FactorCurve& curve() const { return curve_; }
    double at(double time) const noexcept { return curve_.at(time); }
    /// Integral of factor * (1 + pulse_strength * sin(2 pi pulse_rate (s - start))) from `start` to `end`. Never below
    /// 0.
    double flowing(double start, double end) const noexcept;
    /// Integral of factor * (1 - (s - stop) / duration) from `stop` for `elapsed`, at most `duration`.
    double dying(double stop, double elapsed, double duration) const noexcept;

  private:
    /// Integrals of factor * cos(omega s) and factor * sin(omega s) from the first point, up to a constant.
    struct Waves {
        double cosine = 0.0, sine = 0.0;
    };
    Waves waves(double time) const noexcept;

    FactorCurve curve_;
    double omega_ = 0.0, pulse_ = 0.0;  // 0: no pulse
    std::vector<Waves> waves_;          // at each point, less the antiderivative of the piece that begins there
};

/// mm that blood would have travelled by `time` if nothing bounded it: grows with speed * strength from the wound's
/// start, pulsing if arterial, times the scene's `strength`, which must be of this `bleeding`; once coagulation begins
/// the growth dies down linearly within coagulation_time. Never shrinks with time. 0 for a wound that never bleeds (one
/// that is closed before it opens), and for one whose numbers are not finite.
double flow(const Wound& wound, const BleedingParameters& bleeding, double time,
            const Strength& strength = {}) noexcept;

/// s_w(t), mm: how far the blood has travelled: the flow up to max_extent.
double source_value(const Wound& wound, const BleedingParameters& bleeding, double time,
                    const Strength& strength = {}) noexcept;

/// How far the blood of a wound has clotted, from 0 (fresh) to 1: it rises from the start of coagulation until 3 s
/// after the flow has ended.
double clot_of(const Wound& wound, const BleedingParameters& bleeding, double time) noexcept;

inline constexpr double never_cleared = -std::numeric_limits<double>::infinity();

/// Whether the wound bleeds at `time`: blood flows from it and reaches new places. `cleared` is the latest time at
/// which blood of this wound was removed (suction, irrigation), s; it then flows there again, up to max_extent. A wound
/// whose blood has reached max_extent everywhere does not bleed: the paper's upper threshold means the end of the
/// bleeding. A clotting wound bleeds until its flow has ended. States, amounts and changes of values all follow from
/// this function.
bool bleeds(const Wound& wound, const BleedingParameters& bleeding, double time, const Strength& strength = {},
            double cleared = never_cleared) noexcept;

/// Like bleeds() for open wounds, except when the scene's factor is 0: such a wound waits and has not reached its end.
WoundState state_of(const Wound& wound, const BleedingParameters& bleeding, double time, const Strength& strength = {},
                    double cleared = never_cleared) noexcept;

}  // namespace lapfx::bleeding
