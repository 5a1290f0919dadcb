#include "bench/measure/figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lapfx::bench {

namespace {

constexpr double covered = 0.9;    // share of true amounts that intervals are meant to hold
constexpr double mostly = 0.95;    // share of the pictures without an amount
constexpr double rounding = 1e-9;  // of a true amount against the end of an interval

struct Named {
    std::string_view figure, text;
};
constexpr Named short_names[] = {{"mean_absolute_error", "MAE"},
                                 {"bias", "bias"},
                                 {"correlation", "r"},
                                 {"dice", "Dice"},
                                 {"error_over_zero", "of zero's"},
                                 {"raw_error_over_zero", "raw of zero's"},
                                 {"false_area", "false area"},
                                 {"false_area_95", "its 95 %"},
                                 {"told", "told"},
                                 {"interval_coverage", "intervals"},
                                 {"coverage", "coverage"}};

/// An interval is cut off at 0 and 1: its longer side has the half width.
double half_width(const match::Amount& amount) {
    return std::max({amount.high - amount.value, amount.value - amount.low, rounding});
}

double error_of(const Reading& reading) {
    return std::abs(reading.measured.value - reading.truth);
}

std::optional<double> correlation_of(std::span<const Reading> readings) {
    const double n = static_cast<double>(readings.size());
    double x = 0, y = 0, xx = 0, yy = 0, xy = 0;
    for (const Reading& r : readings) x += r.truth / n, y += r.measured.value / n;
    for (const Reading& r : readings) {
        const double a = r.truth - x, b = r.measured.value - y;
        xx += a * a, yy += b * b, xy += a * b;
    }
    if (xx < 1e-12 || yy < 1e-12) return {};
    return xy / std::sqrt(xx * yy);
}

/// The mean of what `of` gives; nothing when it never gives anything.
template <class Of>
void add_mean(Figures& figures, const char* name, std::span<const Reading> readings, const Of& of) {
    double sum = 0.0, count = 0.0;
    for (const Reading& r : readings)
        if (const std::optional<double> value = of(r)) sum += *value, count += 1.0;
    if (count > 0.0) figures[name] = sum / count;
}

/// The score of this rank, 1 the least; ranks between two are those of the larger.
double at_rank(std::vector<double> scores, double rank) {
    const std::size_t index = std::min(static_cast<std::size_t>(std::ceil(rank)), scores.size()) - 1;
    std::nth_element(scores.begin(), scores.begin() + static_cast<std::ptrdiff_t>(index), scores.end());
    return scores[index];
}

}  // namespace

Figures figures_of(std::span<const Reading> readings) {
    using Value = std::optional<double>;
    Figures figures{{"count", static_cast<double>(readings.size())}};
    add_mean(figures, "mean_absolute_error", readings, [](const Reading& r) { return Value(error_of(r)); });
    add_mean(figures, "bias", readings, [](const Reading& r) { return Value(r.measured.value - r.truth); });
    add_mean(figures, "zero_error", readings, [](const Reading& r) { return Value(r.truth); });
    add_mean(figures, "interval_width", readings,
             [](const Reading& r) { return Value(r.measured.high - r.measured.low); });
    add_mean(figures, "interval_coverage", readings, [](const Reading& r) {
        return Value(r.truth >= r.measured.low - rounding && r.truth <= r.measured.high + rounding ? 1.0 : 0.0);
    });
    add_mean(figures, "dice", readings, [](const Reading& r) { return r.dice; });
    add_mean(figures, "false_area", readings,
             [](const Reading& r) { return r.truth <= next_to_nothing ? Value(r.measured.value) : Value(); });
    std::vector<double> false_areas;
    for (const Reading& r : readings)
        if (r.truth <= next_to_nothing) false_areas.push_back(r.measured.value);
    if (const auto count = static_cast<double>(false_areas.size()); count > 0.0)
        figures["false_area_95"] = at_rank(std::move(false_areas), mostly * count);
    if (const Value correlation = correlation_of(readings)) figures["correlation"] = *correlation;
    if (!readings.empty() && figures["zero_error"] > 0.0)
        figures["error_over_zero"] = figures["mean_absolute_error"] / figures["zero_error"];
    return figures;
}

bool meets(const Figures& figures, const Bound& bound) {
    const auto found = figures.find(std::string(bound.figure));
    if (found == figures.end()) return false;
    return bound.at_least ? found->second >= bound.value : std::abs(found->second) <= bound.value;
}

std::string text_of(const Bound& bound) {
    return text_of(bound, bound.at_least ? ">=" : "<=");
}

std::string text_of(const Bound& bound, const char* sign) {
    std::string name(bound.figure);
    for (const Named& row : short_names)
        if (row.figure == bound.figure) name = row.text;
    char number[40];
    std::snprintf(number, sizeof number, " %s %.3g", sign, bound.value);
    return name + number;
}

std::vector<LeftOut> leave_one_out(const std::map<std::string, std::vector<Reading>>& groups) {
    std::vector<LeftOut> all;
    if (groups.size() < 2) return all;
    for (const auto& [name, readings] : groups) {
        std::vector<double> scores;
        for (const auto& [other, others] : groups)
            for (const Reading& r : others)
                if (other != name) scores.push_back(error_of(r) / half_width(r.measured));
        const double rank = covered * static_cast<double>(scores.size() + 1);
        LeftOut left{.group = name, .count = readings.size(), .factor = at_rank(std::move(scores), rank)};
        for (const Reading& r : readings)
            left.coverage += error_of(r) <= left.factor * half_width(r.measured) + rounding ? 1.0 : 0.0;
        left.coverage /= static_cast<double>(readings.size());
        all.push_back(left);
    }
    return all;
}

}  // namespace lapfx::bench
