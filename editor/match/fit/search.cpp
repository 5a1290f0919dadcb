#include "match/fit/search.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace lapfx::match {

namespace {

constexpr double slope_step = 0.02;  // coordinates
constexpr int most_iterations = 25, few_iterations = 6;
constexpr double tolerance = 1e-4;   // of the cost: less is no progress
constexpr std::size_t followed = 3;  // of the places that are tried
constexpr double spread = 2.5;       // coordinates to either side of the start, where bounds allow

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

/// The residuals at `coordinates`, and how those of `open` parameters change them: slopes[row * open + column], away
/// from the upper bound. Throws Error where a rule between values is broken.
class Slopes {
  public:
    explicit Slopes(const SearchSpace& space) : space_(space) {}
    void residuals(std::span<const double> coordinates, double offset, std::span<double> into) const {
        space_.objective.residuals(space_.carried.at(coordinates, space_.core_at(coordinates)), offset, coordinates,
                                   into);
    }
    void slopes(std::span<const double> coordinates, double offset, std::span<const std::size_t> open,
                std::span<const double> here, double* into) const {
        std::vector<double> moved(coordinates.begin(), coordinates.end()), there(here.size());
        for (std::size_t column = 0; column < open.size(); ++column) {
            const std::size_t k = open[column];
            const FreeParameter& p = space_.parameters[k];
            const double step = coordinates[k] + slope_step > p.coordinate(p.maximum) ? -slope_step : slope_step;
            moved[k] = coordinates[k] + step;
            residuals(moved, offset, there);
            moved[k] = coordinates[k];
            for (std::size_t i = 0; i < here.size(); ++i) into[i * open.size() + column] = (there[i] - here[i]) / step;
        }
    }

  private:
    const SearchSpace& space_;
};

/// The same for Ceres; blocks are the open coordinates and the offset.
class Cost : public ceres::CostFunction {
  public:
    Cost(const SearchSpace& space, std::vector<double> coordinates, std::vector<std::size_t> open)
        : space_(space), slopes_(space), coordinates_(std::move(coordinates)), open_(std::move(open)) {
        set_num_residuals(static_cast<int>(space.objective.size()));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(open_.size()));
        mutable_parameter_block_sizes()->push_back(1);
    }
    /// False where a rule between values is broken: the search turns back.
    bool Evaluate(const double* const* blocks, double* residuals, double** jacobians) const override {
        std::vector<double> coordinates = coordinates_;
        for (std::size_t i = 0; i < open_.size(); ++i) coordinates[open_[i]] = blocks[0][i];
        const std::span<double> here(residuals, space_.objective.size());
        try {
            slopes_.residuals(coordinates, blocks[1][0], here);
            if (jacobians != nullptr && jacobians[0] != nullptr)
                slopes_.slopes(coordinates, blocks[1][0], open_, here, jacobians[0]);
        } catch (const Error&) {
            return false;
        }
        if (jacobians != nullptr && jacobians[1] != nullptr)
            space_.objective.offset_slopes({jacobians[1], here.size()});
        return true;
    }

  private:
    const SearchSpace& space_;
    Slopes slopes_;
    std::vector<double> coordinates_;
    std::vector<std::size_t> open_;
};

class GoesOn : public ceres::IterationCallback {
  public:
    explicit GoesOn(const std::function<bool()>& goes_on) : goes_on_(goes_on) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
        return !goes_on_ || goes_on_() ? ceres::SOLVER_CONTINUE : ceres::SOLVER_TERMINATE_SUCCESSFULLY;
    }

  private:
    const std::function<bool()>& goes_on_;
};

double cost_at(const SearchSpace& space, std::span<const double> coordinates) {
    try {
        return space.objective.cost(space.carried.at(coordinates, space.core_at(coordinates)), coordinates);
    } catch (const Error&) {
        return std::numeric_limits<double>::infinity();
    }
}

struct Place {
    std::vector<double> coordinates;
    double cost;
};

std::vector<std::size_t> open_of(const SearchSpace& space, const std::vector<bool>& held) {
    std::vector<std::size_t> open;
    for (std::size_t k = 0; k < space.parameters.size(); ++k)
        if (held.empty() || !held[k]) open.push_back(k);
    return open;
}

Place descend(const SearchSpace& space, Place from, std::span<const Span> spans, int iterations,
              const SearchOptions& options) {
    const std::vector<std::size_t> open = open_of(space, options.held);
    if (open.empty() || !std::isfinite(from.cost)) return from;
    double offset = space.objective.best_offset(space.carried.at(from.coordinates, space.core_at(from.coordinates)));
    std::vector<double> x;
    for (const std::size_t k : open) x.push_back(from.coordinates[k]);
    ceres::Problem problem;
    problem.AddResidualBlock(new Cost(space, from.coordinates, open), nullptr, x.data(), &offset);  // which owns it
    for (std::size_t i = 0; i < open.size(); ++i) {
        problem.SetParameterLowerBound(x.data(), static_cast<int>(i), spans[open[i]].low);
        problem.SetParameterUpperBound(x.data(), static_cast<int>(i), spans[open[i]].high);
    }
    GoesOn goes_on(options.goes_on);
    ceres::Solver::Options solver;
    solver.linear_solver_type = ceres::DENSE_QR;
    solver.max_num_iterations = iterations;
    solver.function_tolerance = tolerance;
    solver.logging_type = ceres::SILENT;
    solver.num_threads = 1;
    solver.callbacks.push_back(&goes_on);
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem, &summary);
    Place place = from;
    for (std::size_t i = 0; i < open.size(); ++i) place.coordinates[open[i]] = x[i];
    place.cost = cost_at(space, place.coordinates);
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

Tuned SearchSpace::tuned(std::span<const double> coordinates) const {
    Tuned tuned = base;
    for (std::size_t k = 0; k < parameters.size(); ++k)
        if (coordinates[k] != parameters[k].coordinate(parameters[k].get(base)))  // it keeps its value to the last bit
            parameters[k].set(tuned, parameters[k].value(coordinates[k]));
    return tuned;
}

std::vector<Amounts> SearchSpace::core_at(std::span<const double> coordinates) const {
    return core.at(tuned(coordinates), times);
}

Linearised linearised(const SearchSpace& space, std::span<const double> coordinates) {
    const Slopes slopes(space);
    const std::size_t rows = space.objective.size(), parameters = space.parameters.size();
    Linearised at{.residuals = std::vector<double>(rows), .slopes = {}, .columns = parameters + 1};
    const double offset = space.objective.best_offset(space.carried.at(coordinates, space.core_at(coordinates)));
    std::vector<double> of_parameters(rows * parameters), of_offset(rows);
    slopes.residuals(coordinates, offset, at.residuals);
    slopes.slopes(coordinates, offset, open_of(space, {}), at.residuals, of_parameters.data());
    space.objective.offset_slopes(of_offset);
    for (std::size_t i = 0; i < rows; ++i) {
        const auto row = of_parameters.begin() + static_cast<std::ptrdiff_t>(i * parameters);
        at.slopes.insert(at.slopes.end(), row, row + static_cast<std::ptrdiff_t>(parameters));
        at.slopes.push_back(of_offset[i]);
    }
    return at;
}

std::vector<double> search(const SearchSpace& space, std::vector<double> start, const SearchOptions& options) {
    const std::vector<Span> spans = spans_of(space, start, options.radius);
    std::vector<Place> places = spread_places(space, start, options);
    for (Place& place : places) {
        if (options.goes_on && !options.goes_on()) return start;
        place.cost = cost_at(space, place.coordinates);
    }
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.cost < b.cost; });
    places.resize(std::min(places.size(), followed));
    places.insert(places.begin(), {start, cost_at(space, start)});
    if (places.size() > 1)
        for (Place& place : places) place = descend(space, std::move(place), spans, few_iterations, options);
    Place& best =
        *std::min_element(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.cost < b.cost; });
    return descend(space, std::move(best), spans, most_iterations, options).coordinates;
}

}  // namespace lapfx::match
