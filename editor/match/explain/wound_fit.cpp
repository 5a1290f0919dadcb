#include "match/explain/wound_fit.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <opencv2/core.hpp>

#include "match/explain/least_squares.h"

namespace lapfx::match {

namespace {

// Bounds of the unknowns, within those of the preset's rows.
constexpr double least_speed = 0.05, most_speed = 60.0;    // mm/s
constexpr double least_extent = 0.5, most_extent = 200.0;  // mm
/// How far the pace may be from the usual one where the curve says nothing, as a standard error of its logarithm. Where
/// the curve tells it to 5 %, this pulls it by a four-hundredth of the way to the usual one.
constexpr double usual_within = 1.0;
/// For standard errors: how unsure start (s) and logarithms are at most.
constexpr double start_unsure = 100.0, log_unsure = 3.0;
constexpr int most_steps = 40;
constexpr double close_enough = 1e-5;  // of the cost
constexpr double least_room = 0.3;     // between bounds: s, and share of pace and extent
constexpr int starts_tried = 28, speeds_tried = 9;
constexpr std::size_t kept_beginnings = 6;
constexpr double extents_tried[] = {0.7, 0.85, 1.0, 1.2, 1.5};  // times full_extent()
constexpr double widest_speed = 8.0;                            // times the usual one, and part of it
constexpr double numeric_step = 1e-3;
// Blocks to both sides that are averaged, and in which a rise takes place, where starts are guessed from the curve.
constexpr std::size_t smooth_over = 1, rise_within = 4;
constexpr double begun = 0.1;  // share of its area at which a wound is taken to have begun

}  // namespace

BloodCurve::BloodCurve(std::span<const BloodPoint> measured, double error_lasts) {
    for (const BloodPoint& p : measured) {
        const bool counts = std::isfinite(p.time) && std::isfinite(p.blood) && std::isfinite(p.error) && p.error > 0.0;
        if (counts && (points.empty() || p.time > points.back().time)) points.push_back(p);
    }
    if (points.size() < 2) return;
    const double from = points.front().time, length = points.back().time - from;
    const double width = length / static_cast<double>(most_blocks - 1);
    double last = -1.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        // The time that a point stands for.
        const double before = i > 0 ? points[i].time - points[i - 1].time : points[1].time - from;
        const double after = i + 1 < points.size() ? points[i + 1].time - points[i].time : before;
        const double alone = error_lasts > 0.0 ? std::min(0.5 * (before + after) / error_lasts, 1.0) : 1.0;
        independent += alone;
        const double number = std::floor((points[i].time - from) / width), error = points[i].error;
        const double weight = alone / (error * error);
        if (number != last) blocks.emplace_back();
        last = number;
        Block& block = blocks.back();
        block.time += weight * points[i].time, block.blood += weight * points[i].blood, block.weight += weight;
    }
    independent = std::min(independent, static_cast<double>(blocks.size()));
    for (Block& block : blocks) block.time /= block.weight, block.blood /= block.weight;
}

double BloodCurve::most() const {
    double most = 0.0;
    for (const Block& block : blocks) most = std::max(most, block.blood);
    return most;
}

std::vector<double> BloodCurve::smooth() const {
    std::vector<double> means;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const std::size_t from = i > smooth_over ? i - smooth_over : 0,
                          to = std::min(i + smooth_over, blocks.size() - 1);
        double sum = 0.0;
        for (std::size_t k = from; k <= to; ++k) sum += blocks[k].blood;
        means.push_back(sum / static_cast<double>(to - from + 1));
    }
    return means;
}

std::vector<double> BloodCurve::steepest(std::size_t count) const {
    const std::vector<double> blood = smooth();
    std::vector<std::pair<double, std::size_t>> rises;  // within a few blocks
    for (std::size_t i = 0; i + rise_within < blood.size(); ++i)
        rises.emplace_back(blood[i + rise_within] - blood[i], i);
    std::sort(rises.rbegin(), rises.rend());
    std::vector<std::size_t> chosen;
    for (const auto& [rise, at] : rises) {
        const bool apart = std::all_of(chosen.begin(), chosen.end(), [&, here = at](std::size_t other) {
            return std::max(here, other) - std::min(here, other) >= rise_within;
        });
        if (apart && chosen.size() < count) chosen.push_back(at);
    }
    std::sort(chosen.begin(), chosen.end());
    std::vector<double> starts;
    for (const std::size_t i : chosen) starts.push_back(blocks[i].time);
    starts.resize(count, end());
    return starts;
}

std::vector<double> BloodCurve::shares(std::size_t count) const {
    const std::vector<double> blood = smooth();
    const double most = *std::max_element(blood.begin(), blood.end());
    std::vector<double> starts;
    for (std::size_t i = 0; i < count; ++i) {
        const double level = most * (static_cast<double>(i) + begun) / static_cast<double>(count);
        const auto place = std::find_if(blood.begin(), blood.end(), [&](double value) { return value >= level; });
        starts.push_back(blocks[static_cast<std::size_t>(place - blood.begin())].time);
    }
    return starts;
}

double BloodCurve::misfit(std::span<const double> blood) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const double off = blocks[i].blood - blood[i];
        sum += blocks[i].weight * off * off;
    }
    return sum;
}

WoundTables::WoundTables(const BloodCurve& curve, const WoundSearch& search, double usual_speed)
    : curve_(curve), search_(search), usual_speed_(usual_speed) {}

/// Integral of the scene's factor on bleeding.
double WoundTables::flowing(double from, double to) const {
    if (!(to > from)) return 0.0;
    const std::vector<CurvePoint>& factor = search_.scene.curves.bleeding_strength;
    double all = 0.0, last = from;
    const auto add_up_to = [&](double time) {
        all += 0.5 * (curve_at(factor, last) + curve_at(factor, time)) * (time - last);
        last = time;
    };
    for (const CurvePoint& point : factor)
        if (point.time > last && point.time < to) add_up_to(point.time);
    add_up_to(to);
    return all;
}

std::vector<double> WoundTables::raw(const WoundFit& fit) const {
    std::vector<double> blood(curve_.blocks.size(), 0.0);
    for (std::size_t k = 0; k < fit.wounds.size(); ++k) {
        const FittedWound& wound = fit.wounds[k];
        for (std::size_t i = 0; i < blood.size(); ++i) {
            const double flow = flowing(wound.start, curve_.blocks[i].time);
            if (flow <= 0.0) continue;
            const double extent = std::min(sites_[k]->factor * wound.pace * flow, fit.max_extent);
            blood[i] += search_.share_per_mm2 * sites_[k]->growth.area(extent);
        }
    }
    return blood;
}

double WoundTables::travelled(const WoundFit& fit, std::size_t i) const {
    const FittedWound& wound = fit.wounds[i];
    return std::min(sites_[i]->factor * wound.pace * flowing(wound.start, curve_.end()), fit.max_extent);
}

double WoundTables::misfit_of(const WoundFit& fit) const {
    std::vector<double> blood = raw(fit);
    for (std::size_t i = 0; i < correction_.size(); ++i) blood[i] *= correction_[i];
    return curve_.misfit(blood);
}

/// Of each block, then of each wound how far its pace is from the usual one.
void WoundTables::residuals_of(const WoundFit& fit, std::span<double> residuals) const {
    const std::vector<double> blood = raw(fit);
    const std::size_t blocks = blood.size();
    for (std::size_t i = 0; i < blocks; ++i) {
        const double shown = blood[i] * (correction_.empty() ? 1.0 : correction_[i]);
        residuals[i] = std::sqrt(curve_.blocks[i].weight) * (shown - curve_.blocks[i].blood);
    }
    for (std::size_t k = 0; k < fit.wounds.size(); ++k)
        residuals[blocks + k] = std::log(fit.wounds[k].pace / (usual_speed_ * sites_[k]->strength)) / usual_within;
}

double WoundTables::cost(const WoundFit& fit) const {
    std::vector<double> residuals(curve_.blocks.size() + fit.wounds.size());
    residuals_of(fit, residuals);
    double sum = 0.0;
    for (const double residual : residuals) sum += residual * residual;
    return sum;
}

std::vector<double> WoundTables::unknowns_of(const WoundFit& fit) const {
    std::vector<double> x;
    for (const FittedWound& wound : fit.wounds) x.push_back(wound.start);
    if (fit.even)
        x.push_back(std::log(fit.wounds[0].pace / sites_[0]->strength));
    else
        for (const FittedWound& wound : fit.wounds) x.push_back(std::log(wound.pace));
    if (fit.max_extent < unbounded) x.push_back(std::log(fit.max_extent));
    return x;
}

WoundFit WoundTables::fit_of(std::span<const double> x, const WoundFit& like) const {
    WoundFit fit = like;
    const std::size_t n = fit.wounds.size();
    for (std::size_t k = 0; k < n; ++k) {
        fit.wounds[k].start = x[k];
        fit.wounds[k].pace = fit.even ? std::exp(x[n]) * sites_[k]->strength : std::exp(x[n + k]);
    }
    if (fit.max_extent < unbounded) fit.max_extent = std::exp(x[fit.even ? n + 1 : 2 * n]);
    return fit;
}

WoundFit WoundTables::fitted(const WoundFit& from) const {
    const std::size_t n = from.wounds.size(), paces = from.even ? 1 : n;
    std::vector<double> x = unknowns_of(from), low, high;
    for (std::size_t k = 0; k < n; ++k) low.push_back(sites_[k]->delay), high.push_back(curve_.end());
    for (std::size_t k = 0; k < paces; ++k) {
        const double strength = from.even ? 1.0 : sites_[k]->strength;
        low.push_back(std::log(least_speed * strength)), high.push_back(std::log(most_speed * strength));
    }
    if (from.max_extent < unbounded) low.push_back(std::log(least_extent)), high.push_back(std::log(most_extent));
    for (std::size_t i = 0; i < x.size(); ++i) {
        high[i] = std::max(high[i], low[i] + least_room);
        x[i] = std::clamp(x[i], low[i], high[i]);
    }
    LeastSquares problem{.residuals = curve_.blocks.size() + n, .low = low, .high = high};
    problem.evaluate = [&](std::span<const double> at, std::span<double> residuals) {
        residuals_of(fit_of(at, from), residuals);
        return true;
    };
    problem.slope_step = numeric_step, problem.tolerance = close_enough, problem.iterations = most_steps;
    solve(problem, x);
    WoundFit fit = fit_of(x, from);
    fit.misfit = misfit_of(fit);
    return fit;
}

/// `before` and a wound at `start`; the others keep their paces, or all have that of the new one at strength 1.
WoundFit WoundTables::beginning(const WoundFit& before, double start, double speed, bool alike, double extent) const {
    WoundFit fit = before;
    fit.even = false, fit.max_extent = extent;
    const FittedWound added{start, speed};
    const auto place = fit.wounds.insert(std::upper_bound(fit.wounds.begin(), fit.wounds.end(), added, earlier), added);
    const auto number = static_cast<std::size_t>(place - fit.wounds.begin());
    for (std::size_t k = 0; k < fit.wounds.size(); ++k)
        if (alike || k == number) fit.wounds[k].pace = speed * sites_[k]->strength;
    return fit;
}

/// mm that the blood of all sites must travel to cover together the most that was measured.
double WoundTables::full_extent() const {
    double extent = least_extent;
    for (; extent < most_extent; extent += least_extent) {
        double area = 0.0;
        for (const WoundSite* site : sites_) area += site->growth.area(extent);
        if (search_.share_per_mm2 * area >= curve_.most()) break;
    }
    return extent;
}

double WoundTables::tried_speed(int k) const {
    return usual_speed_ * std::pow(widest_speed, 2.0 * k / (speeds_tried - 1) - 1.0);
}

/// The best beginnings, at most one for each start. `alike` as in beginning().
std::vector<WoundFit> WoundTables::beginnings(const WoundFit& before, bool alike) const {
    std::vector<std::pair<double, WoundFit>> of_starts;
    const double length = curve_.end() - curve_.begin(), full = full_extent();
    for (int i = 0; i < starts_tried; ++i) {
        // The first: as early as can be, for blood that is there from the beginning.
        const double start = i > 0 ? curve_.begin() + length * (i - 1) / (starts_tried - 1)
                                   : std::min(sites_.front()->delay, curve_.begin());
        std::pair<double, WoundFit> best{unbounded, {}};
        const auto consider = [&](double speed, double extent) {
            WoundFit fit = beginning(before, start, speed, alike, extent);
            const double value = cost(fit);
            if (value < best.first) best = {value, std::move(fit)};
        };
        for (int k = 0; k < speeds_tried; ++k) {
            const double speed = tried_speed(k);
            consider(speed, alike ? unbounded : before.max_extent);
            if (alike)
                for (const double times : extents_tried) consider(speed, times * full);
        }
        of_starts.push_back(std::move(best));
    }
    std::sort(of_starts.begin(), of_starts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<WoundFit> fits;
    for (std::size_t i = 0; i < kept_beginnings; ++i) fits.push_back(std::move(of_starts[i].second));
    return fits;
}

/// The best beginning of which all wounds start at these times, alike.
WoundFit WoundTables::beginning_at(std::span<const double> starts) const {
    WoundFit best{.misfit = unbounded};
    const double full = full_extent();
    for (int k = 0; k < speeds_tried; ++k)
        for (const double times : extents_tried) {
            WoundFit fit{.max_extent = times * full};
            for (std::size_t i = 0; i < starts.size(); ++i)
                fit.wounds.push_back({starts[i], tried_speed(k) * sites_[i]->strength});
            fit.misfit = misfit_of(fit);
            if (fit.misfit < best.misfit) best = std::move(fit);
        }
    return best;
}

WoundFit WoundTables::with_one_more(const WoundFit& before) const {
    std::vector<WoundFit> from = beginnings(before, true);
    const std::size_t count = before.wounds.size() + 1;
    if (count > 1) {
        std::ranges::move(beginnings(before, false), std::back_inserter(from));
        from.push_back(beginning_at(curve_.steepest(count)));
        from.push_back(beginning_at(curve_.shares(count)));
    }
    WoundFit best{.misfit = unbounded};
    for (const WoundFit& beginning : from) {
        WoundFit fit = fitted(beginning);
        if (fit.misfit < best.misfit) best = std::move(fit);
    }
    best = fitted(best);
    std::sort(best.wounds.begin(), best.wounds.end(), earlier);
    return best;
}

std::vector<double> WoundTables::errors(const WoundFit& fit) const {
    const std::vector<double> x = unknowns_of(fit);
    const auto n = static_cast<int>(x.size());
    const auto blood_at = [&](std::vector<double> at, int i, double step) {
        at[static_cast<std::size_t>(i)] += step;
        std::vector<double> blood = raw(fit_of(at, fit));
        for (std::size_t b = 0; b < correction_.size(); ++b) blood[b] *= correction_[b];
        return blood;
    };
    cv::Mat1d information(n, n, 0.0), covariance;
    std::vector<std::vector<double>> slopes;
    for (int i = 0; i < n; ++i) {
        slopes.push_back(blood_at(x, i, numeric_step));
        const std::vector<double> below = blood_at(x, i, -numeric_step);
        for (std::size_t b = 0; b < below.size(); ++b)
            slopes.back()[b] = (slopes.back()[b] - below[b]) / (2.0 * numeric_step);
        const double unsure = i < std::ssize(fit.wounds) ? start_unsure : log_unsure;
        information(i, i) = 1.0 / (unsure * unsure);
    }
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k)
            for (std::size_t b = 0; b < curve_.blocks.size(); ++b)
                information(i, k) += curve_.blocks[b].weight * slopes[static_cast<std::size_t>(i)][b] *
                                     slopes[static_cast<std::size_t>(k)][b];
    cv::invert(information, covariance, cv::DECOMP_SVD);
    std::vector<double> errors;
    for (int i = 0; i < n; ++i) errors.push_back(std::sqrt(std::max(covariance(i, i), 0.0)));
    return errors;
}

}  // namespace lapfx::match
