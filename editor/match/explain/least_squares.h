// Nonlinear least squares within bounds, by Levenberg and Marquardt's method (Ceres Solver), with slopes found by small
// steps: for fits whose residuals come out of a simulation.
//
//     LeastSquares problem{.residuals = 60, .low = {0, 0}, .high = {9, 9}, .evaluate = ...};
//     std::vector<double> x = {1, 1};
//     const double cost = solve(problem, x);
//
// The calling thread alone; the same problem gives the same result.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace lapfx::match {

struct LeastSquares {
    std::size_t residuals = 0;                ///< how many
    std::vector<double> low = {}, high = {};  ///< bounds of each unknown, low < high
    /// Residuals at `x`; false where there are none, such as outside of what is allowed: the search turns back. It must
    /// not throw. Slopes are asked for right after their place: first x, then x with its first unknown moved, and so
    /// on.
    std::function<bool(std::span<const double> x, std::span<double> residuals)> evaluate = {};
    /// Is told all places of the slopes before they are evaluated, one after the other; must not throw.
    std::function<void(std::span<const std::vector<double>> places)> expect = {};
    double slope_step = 0.02;            ///< how far an unknown is moved: up, or where that is refused, down
    double tolerance = 1e-4;             ///< ends when an iteration makes the cost less by no more than this share
    int iterations = 25;                 ///< at most
    std::function<bool()> goes_on = {};  ///< asked before each iteration; false ends it; may throw
};

/// `x`: where it begins, within the bounds, and where it ends. Gives half the sum of squares there; nothing where there
/// are no residuals at the beginning, which is left as it is.
std::optional<double> solve(const LeastSquares& problem, std::vector<double>& x);

/// Residuals, and slopes[row * unknowns + unknown]; all 0, and false, where there are none.
bool linearise(const LeastSquares& problem, std::span<const double> x, std::span<double> residuals,
               std::span<double> slopes);

}  // namespace lapfx::match
