#include "smoke/haze_cpu.h"

#include <algorithm>
#include <cmath>

namespace lapfx::smoke {

double haze_density(std::span<const Emission> emissions, const HazeParameters& haze, double time) noexcept {
    double density = 0.0;
    for (const Emission& e : emissions) {
        if (time <= e.start || e.end <= e.start) continue;
        const double emitted = std::min(time, e.end) - e.start;  // s of emission so far
        const double since = time - std::min(time, e.end);       // s of ventilation after it
        const double v = haze.ventilation;
        // integral of exp(-v (time - s)) ds; expm1 keeps it exact as v goes to 0, where it is the plain sum
        const double integral = v > 1e-9 ? std::exp(-v * since) * -std::expm1(-v * emitted) / v : emitted;
        density += haze.accumulation * e.power * integral;
    }
    return density;
}

}  // namespace lapfx::smoke
