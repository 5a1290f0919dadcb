// Density of the environmental smoke over time, in closed form, so that any time can be asked for in any
// order. Pure functions, any thread.
#pragma once

#include <span>

#include "lapfx/preset.h"

namespace lapfx::smoke {

/// A span of cautery: smoke of `power` (0..1) comes from `start` to `end`, s.
struct Emission {
    double start;
    double end;
    double power;
};

/// E(t), optical thickness at the focus distance: the solution of dE/dt = accumulation * power(t) -
/// ventilation * E with E = 0 before the first emission; emissions add up.
double haze_density(std::span<const Emission> emissions, const HazeParameters& haze, double time) noexcept;

}  // namespace lapfx::smoke
