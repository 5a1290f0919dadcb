#include "ui/widgets/param_value.h"

#include <algorithm>
#include <cmath>

namespace lapfx::ui {

namespace {

constexpr double fine_part = 0.1;
constexpr double whole_step = 0.01;  // steps have this part of the range where they follow the scale

ValueRange range_of(const ParamOptions& o) {
    return {o.minimum, o.maximum, o.scale, o.smallest};
}

/// Whether steps follow the scale: equal steps are useless on a scale that covers decades.
bool steps_follow_scale(const ParamOptions& o) {
    return !o.integer && o.scale != ValueScale::linear && !(o.step > 0);
}

double power_below(double magnitude) {
    return std::pow(10.0, std::floor(std::log10(magnitude)));
}

}  // namespace

ParamOptions percent(ParamOptions percents) {
    percents.display = 100;
    percents.unit = "%";
    return percents;
}

ParamOptions seconds(ParamOptions options) {
    options.unit = "s";
    return options;
}

ParamOptions sound(ParamOptions o) {
    if (!std::isfinite(o.minimum) || !std::isfinite(o.maximum)) o.minimum = 0, o.maximum = 1;
    if (o.minimum > o.maximum) std::swap(o.minimum, o.maximum);
    constexpr double endless = std::numeric_limits<double>::infinity();
    if (std::isnan(o.hard_minimum)) o.hard_minimum = -endless;
    if (std::isnan(o.hard_maximum)) o.hard_maximum = endless;
    if (o.hard_minimum > o.hard_maximum) std::swap(o.hard_minimum, o.hard_maximum);
    return o;
}

ParamLimits limits_of(const ParamOptions& o, double from) {
    ParamLimits limits{std::max(o.minimum, o.hard_minimum), std::min(o.maximum, o.hard_maximum)};
    if (std::isfinite(from)) limits = {std::min(limits.low, from), std::max(limits.high, from)};
    return {limits.low, std::max(limits.low, limits.high)};
}

double step_of(const ParamOptions& o, double value) {
    if (o.integer) return std::max(1.0, std::round(o.step));
    if (o.step > 0) return o.step;
    const double range = o.maximum - o.minimum;
    if (steps_follow_scale(o) && std::abs(value) > 0) return power_below(std::abs(value));
    return range > 0 ? roundest(range / 200, range / 50) : 0.01;
}

double stepped(const ParamOptions& o, double value, double count, bool fine) {
    const double part = fine ? fine_part : 1;
    if (steps_follow_scale(o)) {
        const ValueRange range = range_of(o);
        const double place = range.place_of(value) + count * part * whole_step, near = part * whole_step / 5;
        return roundest(range.value_at(place - near), range.value_at(place + near));
    }
    const double step = o.integer ? std::max(1.0, std::round(step_of(o, value) * part)) : step_of(o, value) * part;
    const double next = value + count * step;
    return roundest(next - step * 1e-9, next + step * 1e-9);  // 0.1 + 0.2 is 0.3
}

double dragged(const ParamOptions& o, double& raw, double pixels, double way, Mods mods, const ParamLimits& limits) {
    if (!(o.maximum > o.minimum)) return raw;
    const ValueRange range = range_of(o);
    const double part = has(mods, Mods::shift) ? fine_part : 1, pixel = part / std::max(1.0, way);
    raw = std::clamp(range.value_at(range.place_of(raw) + pixels * pixel), limits.low, limits.high);
    if (raw <= limits.low || raw >= limits.high) return raw;  // the ends need not be round
    if (has(mods, Mods::command)) {
        const double step = o.integer ? std::max(1.0, step_of(o, raw) * part) : step_of(o, raw) * part;
        return std::clamp(snap(raw, step), limits.low, limits.high);
    }
    if (o.integer) return std::clamp(std::round(raw), limits.low, limits.high);
    const double place = range.place_of(raw), half = pixel / 2;
    return std::clamp(roundest(range.value_at(place - half), range.value_at(place + half)), limits.low, limits.high);
}

bool is_standard(const ParamOptions& o, double value) {
    if (!o.standard || value == *o.standard) return true;
    const double tolerance = o.single ? 1e-6 : 1e-12;
    const double range = std::isfinite(o.maximum - o.minimum) ? std::abs(o.maximum - o.minimum) : 0;
    return std::abs(value - *o.standard) <= tolerance * std::max(std::abs(*o.standard), std::min(range, 1.0) * 1e-3);
}

double cleaned(const ParamOptions& o, double value) {
    const double noise = o.single ? 0x1p-25 : o.display != 1 ? 0x1p-51 : 0;
    if (noise == 0 || !std::isfinite(value)) return value;
    return roundest(value - std::abs(value) * noise, value + std::abs(value) * noise);
}

int decimals_for(const ParamOptions& o, double value) {
    if (o.decimals >= 0) return o.decimals;
    if (o.integer) return 0;
    const double magnitude = std::abs(value);
    if (steps_follow_scale(o) && magnitude > 0 && std::isfinite(magnitude))
        return std::clamp(2 - static_cast<int>(std::floor(std::log10(magnitude))), 0, 9);
    int decimals = decimals_of(step_of(o, value));
    constexpr double powers[] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
    double digits = magnitude * powers[decimals];
    for (int more = 0; more < 2 && decimals < 9 && std::abs(digits - std::round(digits)) > 1e-3; ++more)
        ++decimals, digits *= 10;
    return decimals;
}

std::string_view format_param(std::span<char> buffer, const ParamOptions& o, double value) {
    return format_number(buffer, value, decimals_for(o, value));
}

std::string_view format_whole(std::span<char> buffer, const ParamOptions& o, double value) {
    return format_exact(buffer, cleaned(o, value));
}

}  // namespace lapfx::ui
