// Source value of a wound over time, in closed form (paper: "the vertex animation value is incremented
// proportionally to the appropriate bleeding speed ... controlled by an upper threshold"). Pure; any thread.
#pragma once

#include "lapfx/preset.h"
#include "lapfx/wound.h"

namespace lapfx::bleeding {

/// Clotted blood draws together by this share of its extent.
inline constexpr double clot_shrink = 0.05;

/// mm that blood would have travelled by `time` if nothing bounded it: grows with speed * strength from the wound's start,
/// pulsing if arterial; once coagulation begins the growth dies down linearly within coagulation_time. Never shrinks with
/// time. 0 for a wound that never bleeds, and for one whose numbers are not finite.
double flow(const Wound& wound, const BleedingParameters& bleeding, double time) noexcept;

/// s_w(t), mm: how far the blood has travelled: the flow up to max_extent.
double source_value(const Wound& wound, const BleedingParameters& bleeding, double time) noexcept;

/// How far the blood of a wound has clotted, 0 fresh .. 1: rises from the moment that coagulation begins, and goes on for
/// 3 s after the flow has ended.
double clot_of(const Wound& wound, const BleedingParameters& bleeding, double time) noexcept;

WoundState state_of(const Wound& wound, const BleedingParameters& bleeding, double time) noexcept;

/// Whether the source value still rises at `time`.
bool grows(const Wound& wound, const BleedingParameters& bleeding, double time) noexcept;

}  // namespace lapfx::bleeding
