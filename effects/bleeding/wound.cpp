#include "bleeding/wound.h"

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

/// Slower pulses are ignored where the strength changes: the integrals below lose their digits.
constexpr double slowest_pulse = 1e-3;  // Hz

/// The line through a point of the curve and the next; level before the first and after the last.
struct Line {
    double time, value, slope;

    double at(double t) const { return value + slope * (t - time); }
    /// Antiderivatives of at(s) cos(omega s) and at(s) sin(omega s).
    double cosine(double s, double omega) const {
        return at(s) * std::sin(omega * s) / omega + slope * std::cos(omega * s) / (omega * omega);
    }
    double sine(double s, double omega) const {
        return -at(s) * std::cos(omega * s) / omega + slope * std::sin(omega * s) / (omega * omega);
    }
};
Line line_from(std::span<const CurvePoint> points, std::size_t i) {
    const CurvePoint& p = points[i];
    if (i + 1 == points.size()) return {p.time, p.value, 0.0};
    return {p.time, p.value, (points[i + 1].value - p.value) / (points[i + 1].time - p.time)};
}

/// Whether there is a flow, and a place within the extent that it has not reached since `cleared`.
bool within_extent(const Wound& wound, const BleedingParameters& bleeding, double time, const Strength& strength,
                   double cleared) {
    if (!(time > wound.start && time < wound.stop + bleeding.coagulation_time && wound.stop >= wound.start))
        return false;
    if (time >= wound.sealed) return false;
    if (!(bleeding.speed * wound.strength > 0.0)) return false;
    return flow(wound, bleeding, time, strength) - flow(wound, bleeding, cleared, strength) < bleeding.max_extent;
}

}  // namespace

Strength::Strength(FactorCurve curve, const BleedingParameters& bleeding) : curve_(std::move(curve)) {
    if (curve_.even() || !(bleeding.pulse_rate >= slowest_pulse) || !(bleeding.pulse_strength > 0.0)) return;
    omega_ = 2.0 * std::numbers::pi * bleeding.pulse_rate;
    pulse_ = bleeding.pulse_strength;
    const std::span<const CurvePoint> points = curve_.points();
    Waves sum;  // up to the point
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Line line = line_from(points, i);
        const double from = points[i].time;
        waves_.push_back({sum.cosine - line.cosine(from, omega_), sum.sine - line.sine(from, omega_)});
        if (i + 1 == points.size()) break;
        sum.cosine = waves_[i].cosine + line.cosine(points[i + 1].time, omega_);
        sum.sine = waves_[i].sine + line.sine(points[i + 1].time, omega_);
    }
}

Strength::Waves Strength::waves(double time) const noexcept {
    const std::span<const CurvePoint> points = curve_.points();
    if (time < points.front().time) {
        const Line level{points.front().time, points.front().value, 0.0};
        return {level.cosine(time, omega_) - level.cosine(level.time, omega_),
                level.sine(time, omega_) - level.sine(level.time, omega_)};
    }
    const auto next = std::upper_bound(points.begin(), points.end(), time,
                                       [](double t, const CurvePoint& point) { return t < point.time; });
    const auto i = static_cast<std::size_t>(next - points.begin()) - 1;
    const Line line = line_from(points, i);
    return {waves_[i].cosine + line.cosine(time, omega_), waves_[i].sine + line.sine(time, omega_)};
}

double Strength::flowing(double start, double end) const noexcept {
    double all = curve_.integral(start, end);
    if (pulse_ > 0.0) {
        const Waves from = waves(start), to = waves(end);
        all += pulse_ * (std::cos(omega_ * start) * (to.sine - from.sine) -
                         std::sin(omega_ * start) * (to.cosine - from.cosine));
    }
    return std::max(all, 0.0);
}

double Strength::dying(double stop, double elapsed, double duration) const noexcept {
    if (duration <= 0.0 || elapsed <= 0.0) return 0.0;
    const double end = stop + std::min(elapsed, duration);
    double all = 0.0, from = stop;
    // Both factors are linear between two points: Simpson's rule is exact.
    const auto rate = [&](double t) { return curve_.at(t) * (1.0 - (t - stop) / duration); };
    const auto add_up_to = [&](double to) {
        all += (to - from) / 6.0 * (rate(from) + 4.0 * rate(0.5 * (from + to)) + rate(to));
        from = to;
    };
    for (const CurvePoint& point : curve_.between(stop, end)) add_up_to(point.time);
    add_up_to(end);
    return std::max(all, 0.0);
}

double flow(const Wound& wound, const BleedingParameters& bleeding, double time, const Strength& strength) noexcept {
    time = std::min(time, wound.sealed);
    if (!(time > wound.start) || !(wound.stop >= wound.start) || !std::isfinite(wound.start)) return 0.0;
    const double end = std::min(time, wound.stop), after = std::max(0.0, time - wound.stop);
    const double flowing =
        strength.even() ? pulsed_time(end - wound.start, bleeding) : strength.flowing(wound.start, end);
    const double dying = strength.even() ? dying_time(after, bleeding.coagulation_time)
                                         : strength.dying(wound.stop, after, bleeding.coagulation_time);
    const double travelled = bleeding.speed * wound.strength * (flowing + dying);
    return std::isfinite(travelled) ? std::max(travelled, 0.0) : 0.0;
}

double source_value(const Wound& wound, const BleedingParameters& bleeding, double time,
                    const Strength& strength) noexcept {
    return std::min(flow(wound, bleeding, time, strength), bleeding.max_extent);
}

double clot_of(const Wound& wound, const BleedingParameters& bleeding, double time) noexcept {
    constexpr double setting_time = 3.0;  // s
    const double end = wound.stop + bleeding.coagulation_time + setting_time;
    if (!(time > wound.stop)) return 0.0;
    return time >= end ? 1.0 : glm::smoothstep(0.0, 1.0, (time - wound.stop) / (end - wound.stop));
}

bool bleeds(const Wound& wound, const BleedingParameters& bleeding, double time, const Strength& strength,
            double cleared) noexcept {
    return strength.at(time) > 0.0 && within_extent(wound, bleeding, time, strength, cleared);
}

WoundState state_of(const Wound& wound, const BleedingParameters& bleeding, double time, const Strength& strength,
                    double cleared) noexcept {
    if (!(time > wound.start)) return WoundState::waiting;
    if (time >= wound.stop + bleeding.coagulation_time || time >= wound.sealed || !(wound.stop >= wound.start))
        return WoundState::closed;
    if (time >= wound.stop) return WoundState::clotting;
    return within_extent(wound, bleeding, time, strength, cleared) ? WoundState::bleeding : WoundState::spent;
}

}  // namespace lapfx::bleeding
