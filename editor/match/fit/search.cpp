#include "match/fit/search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "match/explain/least_squares.h"

namespace lapfx::match {

namespace {

constexpr double slope_step = 0.02;  // coordinates
constexpr int most_iterations = 25, few_iterations = 6;
constexpr double tolerance = 1e-4;   // of the cost: less is no progress
constexpr std::size_t followed = 3;  // of the places that are tried
constexpr double spread = 2.5;       // coordinates to either side of the start, where bounds allow

constexpr double most_offset = 0.3;  // of the veil
constexpr double unmoved = 1e-9;     // coordinates

struct Span {
    double low, high;
};

/// Within the bounds and the radius.
std::vector<Span> spans_of(const SearchSpace& space, std::span<const double> start, double radius) {
    std::vector<Span> spans;
    for (std::size_t k = 0; k < start.size(); ++k) {
        const FreeParameter& p = space.parameters[k];
        spans.push_back({std::max(p.coordinate(p.minimum), start[k] - radius),
                         std::min(p.coordinate(p.maximum), start[k] + radius)});
    }
    return spans;
}

/// Unknowns are the veil's offset, then the coordinates of the parameters that are not held.
class Problem {
  public:
    Problem(const SearchSpace& space, std::vector<double> coordinates, const std::vector<bool>& held)
        : space_(space), coordinates_(std::move(coordinates)) {
        for (std::size_t k = 0; k < coordinates_.size(); ++k)
            if (held.empty() || !held[k]) open_.push_back(k);
    }
    LeastSquares problem(std::span<const Span> spans) {
        LeastSquares problem{.residuals = space_.objective.size(), .low = {-most_offset}, .high = {most_offset}};
        for (const std::size_t k : open_) problem.low.push_back(spans[k].low), problem.high.push_back(spans[k].high);
        problem.evaluate = [this](std::span<const double> x, std::span<double> residuals) {
            return evaluate(x, residuals);
        };
        problem.expect = [this](std::span<const std::vector<double>> places) {
            std::vector<std::vector<double>> expected;
            for (const std::vector<double>& x : places) expected.push_back(coordinates_of(x));
            space_.expect(expected);
        };
        problem.slope_step = slope_step;
        return problem;
    }
    std::vector<double> unknowns() {
        std::vector<double> x = {0.0};
        if (shown_at(coordinates_)) x[0] = std::clamp(space_.objective.best_offset(shown_), -most_offset, most_offset);
        for (const std::size_t k : open_) x.push_back(coordinates_[k]);
        return x;
    }
    std::vector<double> coordinates_of(std::span<const double> x) const {
        std::vector<double> coordinates = coordinates_;
        for (std::size_t i = 0; i < open_.size(); ++i) coordinates[open_[i]] = x[i + 1];
        return coordinates;
    }

  private:
    bool evaluate(std::span<const double> x, std::span<double> residuals) {
        const std::vector<double> coordinates = coordinates_of(x);
        if (!shown_at(coordinates)) return false;
        space_.objective.residuals(shown_, x[0], coordinates, residuals);
        return true;
    }
    /// False where a rule between values is broken. The offset is the first unknown: what is shown is the same then.
    bool shown_at(const std::vector<double>& coordinates) {
        if (known_ == coordinates) return true;
        try {
            shown_ = space_.carried.at(coordinates, space_.core_at(coordinates));
        } catch (const Error&) {
            return false;
        }
        known_ = coordinates;
        return true;
    }

    const SearchSpace& space_;
    std::vector<double> coordinates_;
    std::vector<std::size_t> open_;
    std::vector<double> known_;  ///< coordinates of shown_
    ShownCurves shown_;
};

struct Place {
    std::vector<double> coordinates;
    double cost;
};

Place descend(const SearchSpace& space, const Place& from, std::span<const Span> spans, int iterations,
              const SearchOptions& options) {
    Problem unknowns(space, from.coordinates, options.held);
    LeastSquares problem = unknowns.problem(spans);
    problem.iterations = iterations, problem.tolerance = tolerance, problem.goes_on = options.goes_on;
    std::vector<double> x = unknowns.unknowns();
    if (!solve(problem, x)) return from;
    const Place place{unknowns.coordinates_of(x), space.cost_at(unknowns.coordinates_of(x))};
    return place.cost < from.cost ? place : from;
}

/// Each parameter's span is divided evenly, in an order of its own (McKay, Beckman and Conover, 1979: Latin hypercube).
std::vector<Place> spread_places(const SearchSpace& space, std::span<const double> start,
                                 const SearchOptions& options) {
    const std::vector<Span> spans = spans_of(space, start, std::min(options.radius, spread));
    std::mt19937 random(options.seed);
    std::vector<Place> places(options.others, {std::vector<double>(start.size()), 0.0});
    std::vector<std::size_t> order(options.others);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t k = 0; k < start.size(); ++k) {
        for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
        for (std::size_t i = 0; i < places.size(); ++i)
            places[i].coordinates[k] =
                !options.held.empty() && options.held[k]
                    ? start[k]
                    : std::lerp(spans[k].low, spans[k].high,
                                (static_cast<double>(order[i]) + 0.5) / static_cast<double>(places.size()));
    }
    return places;
}

}  // namespace

document::Content SearchSpace::tuned(std::span<const double> coordinates) const {
    document::Content tuned = base;
    for (std::size_t k = 0; k < parameters.size(); ++k)  // one that does not move keeps its value to the last bit
        if (std::abs(coordinates[k] - parameters[k].coordinate(parameters[k].get(base))) > unmoved)
            parameters[k].set(tuned, parameters[k].value(coordinates[k]));
    return tuned;
}

std::vector<Amounts> SearchSpace::core_at(std::span<const double> coordinates) const {
    const document::Content at = tuned(coordinates);
    std::vector<Amounts> amounts = core.at(at, times);
    for (Amounts& amount : amounts) amount.emission *= at.preset.smoke.plume.density;
    return amounts;
}

double SearchSpace::cost_at(std::span<const double> coordinates) const {
    try {
        return objective.cost(carried.at(coordinates, core_at(coordinates)), coordinates);
    } catch (const Error&) {
        return std::numeric_limits<double>::infinity();
    }
}

void SearchSpace::expect(std::span<const std::vector<double>> places) const {
    std::vector<document::Content> scenes;
    for (const std::vector<double>& coordinates : places) scenes.push_back(tuned(coordinates));
    core.expect(scenes, times);
}

Linearised linearised(const SearchSpace& space, std::span<const double> coordinates) {
    const std::vector<double> at(coordinates.begin(), coordinates.end());
    Problem unknowns(space, at, {});
    const LeastSquares problem = unknowns.problem(spans_of(space, at, unlimited));
    const std::size_t rows = problem.residuals, columns = at.size() + 1;
    Linearised linear{.residuals = std::vector<double>(rows),
                      .slopes = std::vector<double>(rows * columns),
                      .columns = columns,
                      .fitted = columns};
    linearise(problem, unknowns.unknowns(), linear.residuals, linear.slopes);
    // Priors do not depend on the core: an unknown that it refuses to move is known by its prior alone.
    for (std::size_t k = 0; k < at.size(); ++k)
        linear.slopes[(space.objective.amounts() + k) * columns + k + 1] = 1.0 / Objective::prior;
    return linear;
}

std::vector<double> search(const SearchSpace& space, std::vector<double> start, const SearchOptions& options) {
    const std::vector<Span> spans = spans_of(space, start, options.radius);
    std::vector<Place> places = spread_places(space, start, options);
    if (!options.also.empty()) {
        Place& also = places.emplace_back(Place{options.also, 0.0});
        for (std::size_t k = 0; k < options.held.size(); ++k)
            if (options.held[k]) also.coordinates[k] = start[k];
    }
    std::vector<std::vector<double>> expected;
    for (const Place& place : places) expected.push_back(place.coordinates);
    space.expect(expected);
    for (Place& place : places) {
        if (options.goes_on && !options.goes_on()) return start;
        place.cost = space.cost_at(place.coordinates);
    }
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.cost < b.cost; });
    places.resize(std::min(places.size(), followed));
    places.insert(places.begin(), {start, space.cost_at(start)});
    if (places.size() > 1)
        for (Place& place : places) place = descend(space, place, spans, few_iterations, options);
    Place& best =
        *std::min_element(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.cost < b.cost; });
    return descend(space, best, spans, most_iterations, options).coordinates;
}

}  // namespace lapfx::match
