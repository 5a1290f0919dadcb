// Emission over time as events of a tool and a factor: the half of emission.h that is about the core's own words.
#include <algorithm>
#include <cmath>
#include <optional>

#include "match/explain/emission.h"

namespace lapfx::match {

namespace {

constexpr double edge = 0.5;          // of the height near by: there a burst begins and ends
constexpr double end_within = 1.0;    // s
constexpr double on = 0.15;           // of the strong emission: above, the tool is on
constexpr double strong_share = 0.9;  // of the steps in which there is any are weaker than the strong emission
constexpr double least_gap = 0.4, least_burst = 0.15;  // s
constexpr double least_part = 0.03;                    // of all that is emitted
constexpr double even_within = 0.12;                   // of the mean: what varies less is even
constexpr double curve_step = 0.5;                     // s between points of the curve, at least
constexpr std::size_t most_points = 24;
constexpr double most_factor = 4.0;  // as much as the row of curves.emission allows

constexpr double offset_error = 0.03, offset_step = 0.015;  // E
constexpr double burst_cost = 4.0;    // of a burst more, beside misfit in standard errors: an offset costs less
constexpr int offsets_tried = 4;      // to either side
constexpr double clear_error = 0.01;  // E, of a clear moment
constexpr double error_lasts = 1.0;   // s

/// Root mean square of the points, in standard errors.
double error_without(std::span<const HazePoint> points) {
    double sum = 0.0;
    for (const HazePoint& p : points) sum += p.density * p.density / (p.error * p.error);
    return std::sqrt(sum / static_cast<double>(points.size()));
}

double strong_of(const std::vector<double>& emission) {
    std::vector<double> any;
    const double most = emission.empty() ? 0.0 : *std::max_element(emission.begin(), emission.end());
    for (const double e : emission)
        if (e > 0.02 * most) any.push_back(e);
    if (any.empty()) return 0.0;
    const auto place = any.begin() + static_cast<std::ptrdiff_t>(strong_share * static_cast<double>(any.size() - 1));
    std::nth_element(any.begin(), place, any.end());
    return *place;
}

/// Steps in which the tool is on. Found emission is smooth: a burst begins and ends at half of its own height.
struct Run {
    std::size_t first, last;
};

std::vector<Run> runs_of(const EmissionFound& found) {
    const std::vector<double>& e = found.emission;
    const double threshold = on * strong_of(e);
    std::vector<Run> runs;
    if (threshold <= 0.0) return runs;
    for (std::size_t k = 0; k < e.size(); ++k) {
        if (e[k] < threshold) continue;
        if (!runs.empty() && static_cast<double>(k - runs.back().last - 1) * found.step <= least_gap)
            runs.back().last = k;
        else
            runs.push_back({k, k});
    }
    // The height near an end, where it counts.
    const auto near = static_cast<std::size_t>(std::ceil(end_within / found.step));
    const auto half_of = [&](std::size_t from, std::size_t to) {
        return edge * strong_of(std::vector<double>(e.begin() + static_cast<std::ptrdiff_t>(from),
                                                    e.begin() + static_cast<std::ptrdiff_t>(to) + 1));
    };
    for (Run& run : runs) {
        const double rises = half_of(run.first, std::min(run.first + near, run.last));
        const double falls = half_of(run.last - std::min(near, run.last - run.first), run.last);
        while (run.first < run.last && e[run.first] < rises) ++run.first;
        while (run.last > run.first && e[run.last] < falls) --run.last;
    }
    return runs;
}

std::vector<Burst> bursts_of(const EmissionFound& found) {
    std::vector<Burst> bursts;
    for (const Run& run : runs_of(found))
        bursts.push_back({found.start + static_cast<double>(run.first) * found.step,
                          found.start + static_cast<double>(run.last + 1) * found.step, 0.0});
    return bursts;
}

/// Emitted between two times.
double emitted(const EmissionFound& found, double from, double to) {
    double sum = 0.0;
    for (std::size_t k = 0; k < found.emission.size(); ++k) {
        const double start = found.start + static_cast<double>(k) * found.step;
        sum += found.emission[k] * std::max(std::min(to, start + found.step) - std::max(from, start), 0.0);
    }
    return sum;
}

/// The factor within the bursts, each in parts of equal length; between bursts it does not matter. Where one would be
/// larger than allowed, the accumulation is raised so that it is not.
std::vector<CurvePoint> take_curve(const EmissionFound& found, SmokeFound& smoke) {
    double length = 0.0;
    for (const Burst& burst : smoke.bursts) length += burst.end - burst.start;
    const double part = std::max(curve_step, length / static_cast<double>(most_points));
    std::vector<CurvePoint> points;
    double off = 0.0, weight = 0.0, most = 0.0;
    for (const Burst& burst : smoke.bursts) {
        const auto parts = std::max(static_cast<int>(std::floor((burst.end - burst.start) / part)), 1);
        const double width = (burst.end - burst.start) / parts;
        for (int i = 0; i < parts; ++i) {
            const double from = burst.start + i * width;
            const double value = emitted(found, from, from + width) / width / smoke.accumulation;
            points.push_back({from + 0.5 * width, value});
            most = std::max(most, value);
            off += width * (value - 1.0) * (value - 1.0), weight += width;
        }
    }
    if (std::sqrt(off / weight) < even_within) points.clear();
    if (most <= most_factor || points.empty()) return points;
    smoke.accumulation *= most / most_factor;
    for (CurvePoint& point : points) point.value *= most_factor / most;
    return points;
}

}  // namespace

SmokeFound smoke_of(std::span<const HazePoint> points, double usual) {
    const EmissionFound smooth = emission_of(points, usual);
    SmokeFound smoke;
    smoke.ventilation = smooth.ventilation;
    smoke.falls = smooth.falls;
    const double end = smooth.start + static_cast<double>(smooth.emission.size()) * smooth.step;
    const double all = emitted(smooth, smooth.start, end);
    for (const Burst& burst : bursts_of(smooth)) {
        const double made = emitted(smooth, burst.start - least_gap, burst.end + least_gap);
        if (burst.end - burst.start >= least_burst && made >= least_part * all) smoke.bursts.push_back(burst);
    }
    const EmissionFound found = emission_within(points, smooth, smoke.bursts);
    smoke.error = found.error;
    double sum = 0.0, length = 0.0;
    for (Burst& burst : smoke.bursts) {
        const double made = emitted(found, burst.start, burst.end);
        burst.emission = made / (burst.end - burst.start);
        sum += made, length += burst.end - burst.start;
    }
    if (sum <= 0.0) {
        smoke.bursts.clear();
        return smoke;
    }
    smoke.accumulation = sum / length;
    smoke.emission = take_curve(found, smoke);
    return smoke;
}

SmokeFound smoke_above_offset(std::span<const HazePoint> points, double usual, std::optional<double> clear_at) {
    if (points.empty()) return {};
    const double length = points.back().time - points.front().time;
    // Errors of neighbouring points go together: as many as there are seconds count.
    const double count = std::min(static_cast<double>(points.size()), std::max(length / error_lasts, 1.0));
    std::optional<SmokeFound> best;
    double least = 0.0;
    for (int i = -offsets_tried; i <= offsets_tried; ++i) {
        const double offset = i * offset_step;
        std::vector<HazePoint> above(points.begin(), points.end());
        for (HazePoint& point : above) point.density -= offset;
        if (clear_at && *clear_at < above.front().time) above.insert(above.begin(), {*clear_at, 0.0, clear_error});
        SmokeFound found = smoke_of(above, usual);
        if (found.bursts.empty()) found.error = error_without(above);
        const double cost = count * found.error * found.error + offset * offset / (offset_error * offset_error) +
                            burst_cost * static_cast<double>(found.bursts.size());
        if (best && cost >= least) continue;
        least = cost;
        found.offset = offset;
        best = std::move(found);
    }
    return *best;
}

}  // namespace lapfx::match
