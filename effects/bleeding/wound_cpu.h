// Source value of a wound over time, in closed form (paper: "the vertex animation value is incremented
// proportionally to the appropriate bleeding speed ... controlled by an upper threshold"). Pure; any thread.
#pragma once

#include "lapfx/preset.h"
#include "lapfx/wound.h"

namespace lapfx::bleeding {

/// s_w(t), mm: how far the blood has travelled. Grows with speed * strength from the wound's start, pulsing
/// if arterial; once coagulation begins the growth dies down linearly within coagulation_time; never beyond
/// max_extent.
double source_value(const Wound& wound, const BleedingParameters& bleeding, double time) noexcept;

/// Whether the source value still rises at `time`.
bool grows(const Wound& wound, const BleedingParameters& bleeding, double time) noexcept;

}  // namespace lapfx::bleeding
