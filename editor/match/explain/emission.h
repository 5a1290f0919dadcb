// The smoke that explains a measured haze, without search. Haze is linear in what is emitted (effects/smoke/haze.h):
//
//   dE/dt = emission(t) - ventilation * E,   E = 0 at first,   emission >= 0
//
// so emission over time is found by deconvolution: least squares over small steps of time, none of them negative, held
// smooth and small as far as the haze says nothing. The ventilation is the least that still explains how the haze
// falls: more of it always explains as much, with more smoke.
//
//     const SmokeFound smoke = smoke_of(points, preset.smoke.haze.ventilation);
//     preset.smoke.haze.accumulation = smoke.accumulation;   // and so on: events, a curve of the scene
//
// Pure functions, any thread.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lapfx/curves.h"

namespace lapfx::match {

/// A measured haze at one time.
struct HazePoint {
    double time = 0.0;     ///< s, ascending
    double density = 0.0;  ///< E, optical thickness at the focus distance
    double error = 0.05;   ///< its standard error, above 0
};

struct EmissionFound {
    double start = 0.0, step = 0.0;  ///< s: the i-th value is that of start + i * step up to a step later
    std::vector<double> emission;    ///< 1/s, what is added to E; accumulation * factor * power of the core
    double ventilation = 0.0;        ///< 1/s
    bool falls = false;              ///< the haze falls, so that it tells the ventilation; else it is the one given
    double error = 0.0;              ///< root mean square of what is left, in standard errors of the points

    /// E at `time`, closed form.
    double density(double time) const;
};

/// `usual`: the ventilation that is taken when the haze never falls, 1/s. Two points at least (else nothing is found).
EmissionFound emission_of(std::span<const HazePoint> points, double usual);

/// Smoke comes from `start` to `end`, s.
struct Burst {
    double start = 0.0, end = 0.0;
    double emission = 0.0;  ///< mean, 1/s
};

/// The same when smoke comes only during the bursts, whose ends it does not smooth away.
EmissionFound emission_within(std::span<const HazePoint> points, const EmissionFound& found,
                              std::span<const Burst> bursts);

/// The same as the core takes it.
struct SmokeFound {
    double accumulation = 0.0;         ///< haze.accumulation, 1/s: the mean emission of the bursts, or more
    double ventilation = 0.0;          ///< haze.ventilation, 1/s
    std::vector<Burst> bursts;         ///< events of full power
    std::vector<CurvePoint> emission;  ///< curves.emission, 0..4, that explains the rest; empty: the bursts are even
    bool falls = false;                ///< as in EmissionFound
    double error = 0.0;                ///< as in EmissionFound, of the emission within the bursts
    double offset = 0.0;               ///< E that is there all the time and is no smoke: of the baseline
};

/// No bursts when nothing is emitted. `usual` as in emission_of().
SmokeFound smoke_of(std::span<const HazePoint> points, double usual);

/// A baseline may be a little hazy, or clearer than the clip: the haze has an offset, 0 +- 0.03, that is found along.
/// `clear_at`: a time before all points at which there is no smoke, s.
SmokeFound smoke_above_offset(std::span<const HazePoint> points, double usual, std::optional<double> clear_at = {});

}  // namespace lapfx::match
