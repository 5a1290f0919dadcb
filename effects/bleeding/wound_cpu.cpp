#include "bleeding/wound_cpu.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lapfx::bleeding {

namespace {

/// Integral of 1 + strength * sin(2 pi rate s) from 0 to `elapsed`: equal to `elapsed` on average, so that
/// pulse does not change the amount.
double pulsed_time(double elapsed, const BleedingParameters& b) {
    if (b.pulse_rate <= 0.0 || b.pulse_strength <= 0.0) return elapsed;
    const double omega = 2.0 * std::numbers::pi * b.pulse_rate;
    return elapsed + b.pulse_strength / omega * (1.0 - std::cos(omega * elapsed));
}

/// Integral of 1 - s / duration from 0 to `elapsed`: a growth that dies down.
double dying_time(double elapsed, double duration) {
    if (duration <= 0.0) return 0.0;
    const double t = std::min(elapsed, duration);
    return t - t * t / (2.0 * duration);
}

}  // namespace

double flow(const Wound& wound, const BleedingParameters& bleeding, double time) noexcept {
    if (!(time > wound.start) || !(wound.stop > wound.start) || !std::isfinite(wound.start)) return 0.0;
    const double flowing = pulsed_time(std::min(time, wound.stop) - wound.start, bleeding);
    const double dying = dying_time(std::max(0.0, time - wound.stop), bleeding.coagulation_time);
    const double travelled = bleeding.speed * wound.strength * (flowing + dying);
    return std::isfinite(travelled) ? std::max(travelled, 0.0) : 0.0;
}

double source_value(const Wound& wound, const BleedingParameters& bleeding, double time) noexcept {
    return std::min(flow(wound, bleeding, time), bleeding.max_extent);
}

double clot_of(const Wound& wound, const BleedingParameters& bleeding, double time) noexcept {
    constexpr double setting_time = 3.0;  // s
    const double end = wound.stop + bleeding.coagulation_time + setting_time;
    if (!(time > wound.stop)) return 0.0;
    return time >= end ? 1.0 : glm::smoothstep(0.0, 1.0, (time - wound.stop) / (end - wound.stop));
}

WoundState state_of(const Wound& wound, const BleedingParameters& bleeding, double time) noexcept {
    if (!(time > wound.start)) return WoundState::waiting;
    if (time >= wound.stop + bleeding.coagulation_time || !(wound.stop > wound.start)) return WoundState::closed;
    if (time >= wound.stop) return WoundState::clotting;
    return grows(wound, bleeding, time) ? WoundState::bleeding : WoundState::spent;
}

bool grows(const Wound& wound, const BleedingParameters& bleeding, double time) noexcept {
    return time > wound.start && time < wound.stop + bleeding.coagulation_time && wound.stop > wound.start &&
           bleeding.speed * wound.strength > 0.0 && source_value(wound, bleeding, time) < bleeding.max_extent;
}

}  // namespace lapfx::bleeding
