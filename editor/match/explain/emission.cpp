#include "match/explain/emission.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace lapfx::match {

namespace {

constexpr std::size_t most_steps = 240;
constexpr double least_step = 0.1;                          // s
constexpr double least_ventilation = 0.004, factor = 1.25;  // 1/s: the values that are tried
constexpr int tried = 28;                                   // up to 1.7 / s
constexpr int iterations = 300;
constexpr double smooth_over = 0.3;  // s
constexpr double sparseness = 0.02;  // what an emission that is not needed costs beside misfit in standard errors
// As much more misfit than the best may be chance.
constexpr double as_good = 1.1, slack = 0.02;
constexpr int halvings = 4;
constexpr double falls_by = 4.0;  // standard errors

/// Haze at the points as a linear function of the steps' emission.
class Response {
  public:
    Response(std::span<const HazePoint> points, double start, double step, std::size_t steps, double ventilation)
        : points_(points), start_(start), step_(step), steps_(steps), loss_(ventilation) {
        kept_ = std::exp(-loss_ * step);
        made_ = integral(step);
    }

    /// Densities at the points, in standard errors.
    void apply(const std::vector<double>& emission, std::vector<double>& densities) const {
        densities.resize(points_.size());
        std::size_t i = 0;
        double before = 0.0;
        for (std::size_t k = 0; k < steps_; ++k) {
            for (; i < points_.size() && place(i) <= k; ++i) {
                const double passed = within(i);
                densities[i] = (before * std::exp(-loss_ * passed) + emission[k] * integral(passed)) / points_[i].error;
            }
            before = before * kept_ + emission[k] * made_;
        }
    }
    /// The adjoint of apply().
    void back(const std::vector<double>& misfit, std::vector<double>& gradient) const {
        gradient.assign(steps_, 0.0);
        std::size_t i = points_.size();
        double after = 0.0;  // of the density at the end of the step
        for (std::size_t k = steps_; k-- > 0;) {
            double before = after * kept_;
            gradient[k] = after * made_;
            for (; i > 0 && place(i - 1) >= k; --i) {
                const double passed = within(i - 1), value = misfit[i - 1] / points_[i - 1].error;
                gradient[k] += value * integral(passed);
                before += value * std::exp(-loss_ * passed);
            }
            after = before;
        }
    }

  private:
    std::size_t place(std::size_t i) const {
        const double steps = (points_[i].time - start_) / step_;
        return std::min(static_cast<std::size_t>(std::max(steps, 0.0)), steps_ - 1);
    }
    double within(std::size_t i) const {
        return std::max(points_[i].time - start_ - static_cast<double>(place(i)) * step_, 0.0);
    }
    double integral(double passed) const { return loss_ > 1e-9 ? -std::expm1(-loss_ * passed) / loss_ : passed; }

    std::span<const HazePoint> points_;
    double start_, step_;
    std::size_t steps_;
    double loss_, kept_ = 0.0, made_ = 0.0;
};

/// What is known beforehand: how far neighbouring steps differ, how much there is, and where there may be any.
struct Prior {
    double smooth = 0.0, sparse = 0.0;
    std::vector<bool> open = {};  ///< of each step; empty: all are
    bool may(std::size_t step) const { return open.empty() || open[step]; }
};

void add_smoothness(const std::vector<double>& emission, const Prior& prior, std::vector<double>& gradient) {
    const double weight = prior.smooth;
    for (std::size_t k = 0; k + 1 < emission.size(); ++k) {
        if (!prior.may(k) || !prior.may(k + 1)) continue;
        const double differ = weight * (emission[k + 1] - emission[k]);
        gradient[k] -= differ;
        gradient[k + 1] += differ;
    }
}

struct Solved {
    std::vector<double> emission;
    double misfit = 0.0;  // sum of squares
};

/// Accelerated projected gradient (Beck and Teboulle, "A fast iterative shrinkage-thresholding algorithm", 2009).
Solved solve(const Response& response, std::span<const HazePoint> points, std::size_t steps, const Prior& prior,
             std::vector<double> start) {
    std::vector<double> densities, gradient, emission = std::move(start), ahead, before;
    emission.resize(steps, 0.0);
    const auto slope_at = [&](const std::vector<double>& at, bool linear) {
        response.apply(at, densities);
        if (!linear)
            for (std::size_t i = 0; i < points.size(); ++i) densities[i] -= points[i].density / points[i].error;
        response.back(densities, gradient);
        add_smoothness(at, prior, gradient);
    };
    double steepest = 0.0;
    std::vector<double> direction(steps, 1.0);
    for (int i = 0; i < 12; ++i) {
        slope_at(direction, true);
        steepest = std::sqrt(std::inner_product(gradient.begin(), gradient.end(), gradient.begin(), 0.0));
        for (std::size_t k = 0; k < steps; ++k) direction[k] = gradient[k] / steepest;
    }
    const double stride = 1.0 / (1.05 * steepest);
    ahead = emission;
    double speed = 1.0;
    for (int i = 0; i < iterations; ++i) {
        slope_at(ahead, false);
        before = emission;
        for (std::size_t k = 0; k < steps; ++k)
            emission[k] = prior.may(k) ? std::max(ahead[k] - stride * (gradient[k] + prior.sparse), 0.0) : 0.0;
        const double next = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * speed * speed));
        for (std::size_t k = 0; k < steps; ++k)
            ahead[k] = emission[k] + (speed - 1.0) / next * (emission[k] - before[k]);
        speed = next;
    }
    response.apply(emission, densities);
    Solved solved{std::move(emission)};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double off = densities[i] - points[i].density / points[i].error;
        solved.misfit += off * off;
    }
    return solved;
}

Prior prior_of(std::span<const HazePoint> points, double step) {
    const double length = points.back().time - points.front().time;
    double peak = 1e-3, known = 0.0;
    for (const HazePoint& p : points) {
        peak = std::max(peak, p.density);
        known += 1.0 / (p.error * p.error) / length;
    }
    // Haze that is known to one standard error with that many points a second tells emission over `smooth_over`.
    return {.smooth = known * std::pow(smooth_over, 4) / step, .sparse = sparseness * std::min(length, 1.0) / peak};
}

/// Whether some later haze is less than an earlier one by more than chance.
bool falls(std::span<const HazePoint> points) {
    double most = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        // Means of three, so that one wrong frame is no fall.
        const std::size_t from = i > 0 ? i - 1 : i, to = std::min(i + 2, points.size());
        double mean = 0.0;
        for (std::size_t k = from; k < to; ++k) mean += points[k].density;
        mean /= static_cast<double>(to - from);
        if (most - mean > falls_by * points[i].error) return true;
        most = std::max(most, mean);
    }
    return false;
}

}  // namespace

double EmissionFound::density(double time) const {
    double value = 0.0;
    for (std::size_t k = 0; k < emission.size(); ++k) {
        const double passed = std::min(time - start - static_cast<double>(k) * step, step);
        if (passed <= 0.0) break;
        const double left = std::exp(-ventilation * passed);
        value = value * left + emission[k] * (ventilation > 1e-9 ? (1.0 - left) / ventilation : passed);
    }
    const double after = time - start - static_cast<double>(emission.size()) * step;
    return after > 0.0 ? value * std::exp(-ventilation * after) : value;
}

EmissionFound emission_of(std::span<const HazePoint> points, double usual) {
    EmissionFound found;
    found.ventilation = usual;
    if (points.size() < 2 || points.back().time <= points.front().time) return found;
    const double length = points.back().time - points.front().time;
    found.step = std::max(least_step, length / static_cast<double>(most_steps));
    const auto steps = static_cast<std::size_t>(std::ceil(length / found.step)) + 1;
    found.start = points.front().time - found.step;  // the first haze came in an earlier step
    found.falls = falls(points);
    const Prior prior = prior_of(points, found.step);
    const auto solve_with = [&](double ventilation, std::vector<double> start) {
        return solve(Response(points, found.start, found.step, steps, ventilation), points, steps, prior,
                     std::move(start));
    };
    Solved best;
    if (!found.falls) {
        best = solve_with(usual, {});
    } else {
        std::vector<Solved> all;
        double least = std::numeric_limits<double>::infinity(), ventilation = least_ventilation;
        for (int i = 0; i < tried; ++i, ventilation *= factor) {
            all.push_back(solve_with(ventilation, all.empty() ? std::vector<double>() : all.back().emission));
            least = std::min(least, all.back().misfit);
        }
        const double enough = as_good * least + slack * static_cast<double>(points.size());
        std::size_t first = 0;
        while (all[first].misfit > enough) ++first;
        ventilation = least_ventilation * std::pow(factor, static_cast<double>(first));
        best = std::move(all[first]);
        double below = first > 0 ? ventilation / factor : 0.0;
        for (int i = 0; i < halvings; ++i) {
            const double between = 0.5 * (below + ventilation);
            Solved solved = solve_with(between, best.emission);
            if (solved.misfit <= enough)
                ventilation = between, best = std::move(solved);
            else
                below = between;
        }
        found.ventilation = ventilation;
    }
    found.emission = std::move(best.emission);
    found.error = std::sqrt(best.misfit / static_cast<double>(points.size()));
    return found;
}

EmissionFound emission_within(std::span<const HazePoint> points, const EmissionFound& found,
                              std::span<const Burst> bursts) {
    if (found.emission.empty()) return found;
    Prior prior = prior_of(points, found.step);
    prior.open.assign(found.emission.size(), false);
    for (std::size_t k = 0; k < prior.open.size(); ++k) {
        const double middle = found.start + (static_cast<double>(k) + 0.5) * found.step;
        for (const Burst& burst : bursts)
            if (middle > burst.start && middle < burst.end) prior.open[k] = true;
    }
    EmissionFound within = found;
    Solved solved = solve(Response(points, found.start, found.step, found.emission.size(), found.ventilation), points,
                          found.emission.size(), prior, found.emission);
    within.emission = std::move(solved.emission);
    within.error = std::sqrt(solved.misfit / static_cast<double>(points.size()));
    return within;
}

}  // namespace lapfx::match
