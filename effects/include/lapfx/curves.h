// Factors over time: how cautery power, bleeding and smoke change in the course of a scene, so that a preview can
// follow a surgery video in which nothing is even.
//
//     lapfx::Curves curves;
//     curves.bleeding_strength = {{.time = 2.0, .value = 0.0}, {.time = 4.0, .value = 1.5}};  // 0, from 2 s rising
//     effects.set_curves(curves);
//
// A curve is straight between two points and constant before the first and after the last one. Without points it is 1.
// Plain data.
#pragma once

#include <span>
#include <vector>

#include "lapfx/api.h"

namespace lapfx {

struct CurvePoint {
    double time = 0.0;   ///< s
    double value = 1.0;  ///< a factor, 0 and more

    friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

/// Points in ascending order of time. A point that is not finite, below 0, or not after the one before is left out.
struct Curves {
    /// Factor on the power of a hot contact at that moment; heat and smoke follow. 0..1, because power has a maximum.
    std::vector<CurvePoint> cautery_power;
    /// Factor on the rate at which the blood of open wounds spreads: at 0 it stands still, and it never goes back.
    /// Pulse and clotting keep their times.
    std::vector<CurvePoint> bleeding_strength;
    /// Factor on the smoke that heat makes: the density of the plume and the emission into the haze.
    std::vector<CurvePoint> emission;

    friend bool operator==(const Curves&, const Curves&) = default;
};

/// The factor at `time`. `points` follow the rules of Curves.
LAPFX_API double curve_at(std::span<const CurvePoint> points, double time) noexcept;

}  // namespace lapfx
