#include "match/explain/least_squares.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <exception>

namespace lapfx::match {

namespace {

/// A step that is refused is made to the other side; an unknown that cannot be moved to either changes nothing.
void add_slopes(const LeastSquares& problem, std::span<const double> x, std::span<const double> here,
                std::span<double> slopes) {
    std::vector<std::vector<double>> places(x.size(), {x.begin(), x.end()});
    for (std::size_t k = 0; k < x.size(); ++k)
        places[k][k] += x[k] + problem.slope_step > problem.high[k] ? -problem.slope_step : problem.slope_step;
    if (problem.expect) problem.expect(places);
    std::vector<double> there(here.size());
    for (std::size_t k = 0; k < x.size(); ++k) {
        double step = places[k][k] - x[k];
        bool moved = problem.evaluate(places[k], there);
        if (!moved && x[k] - step >= problem.low[k] && x[k] - step <= problem.high[k]) {
            places[k][k] = x[k] - step, step = -step;
            moved = problem.evaluate(places[k], there);
        }
        for (std::size_t i = 0; i < here.size(); ++i)
            slopes[i * x.size() + k] = moved ? (there[i] - here[i]) / step : 0.0;
    }
}

class Cost : public ceres::CostFunction {
  public:
    explicit Cost(const LeastSquares& problem) : problem_(problem) {
        set_num_residuals(static_cast<int>(problem.residuals));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.low.size()));
    }
    bool Evaluate(const double* const* blocks, double* residuals, double** jacobians) const override {
        const std::span<const double> x(blocks[0], problem_.low.size());
        const std::span<double> here(residuals, problem_.residuals);
        if (!problem_.evaluate(x, here)) return false;
        if (jacobians != nullptr && jacobians[0] != nullptr)
            add_slopes(problem_, x, here, {jacobians[0], here.size() * x.size()});
        return true;
    }

  private:
    const LeastSquares& problem_;
};

class GoesOn : public ceres::IterationCallback {
  public:
    explicit GoesOn(const std::function<bool()>& goes_on) : goes_on_(goes_on) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
        try {
            return !goes_on_ || goes_on_() ? ceres::SOLVER_CONTINUE : ceres::SOLVER_TERMINATE_SUCCESSFULLY;
        } catch (...) {
            thrown = std::current_exception();  // not through Ceres
            return ceres::SOLVER_ABORT;
        }
    }
    std::exception_ptr thrown;

  private:
    const std::function<bool()>& goes_on_;
};

}  // namespace

std::optional<double> solve(const LeastSquares& problem, std::vector<double>& x) {
    std::vector<double> residuals(problem.residuals), at = x;
    if (!problem.evaluate(x, residuals)) return {};
    ceres::Problem of_ceres;
    of_ceres.AddResidualBlock(new Cost(problem), nullptr, at.data());  // which owns it
    for (std::size_t k = 0; k < at.size(); ++k) {
        of_ceres.SetParameterLowerBound(at.data(), static_cast<int>(k), problem.low[k]);
        of_ceres.SetParameterUpperBound(at.data(), static_cast<int>(k), problem.high[k]);
    }
    GoesOn goes_on(problem.goes_on);
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.max_num_iterations = problem.iterations;
    options.function_tolerance = problem.tolerance;
    options.logging_type = ceres::SILENT;
    options.num_threads = 1;
    options.callbacks.push_back(&goes_on);
    ceres::Solver::Summary summary;
    ceres::Solve(options, &of_ceres, &summary);
    if (goes_on.thrown) std::rethrow_exception(goes_on.thrown);
    if (summary.IsSolutionUsable()) {
        x = at;
        return summary.final_cost;
    }
    double sum = 0.0;
    for (const double residual : residuals) sum += residual * residual;
    return 0.5 * sum;
}

bool linearise(const LeastSquares& problem, std::span<const double> x, std::span<double> residuals,
               std::span<double> slopes) {
    if (problem.evaluate(x, residuals)) {
        add_slopes(problem, x, residuals, slopes);
        return true;
    }
    std::fill(residuals.begin(), residuals.end(), 0.0);
    std::fill(slopes.begin(), slopes.end(), 0.0);
    return false;
}

}  // namespace lapfx::match
