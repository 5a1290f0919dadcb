// Looks for the parameters whose told curves (carried.h) are nearest to the reference: least squares within bounds,
// Levenberg and Marquardt's method (Ceres Solver). Nothing is drawn. The same call gives the same result.
//
// One thread at a time, any.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "match/fit/free_parameter.h"
#include "match/fit/objective.h"
#include "match/scene/core_amounts.h"

namespace lapfx::match {

/// What the search looks through. All must outlive it.
struct SearchSpace {
    const document::Content& base;
    const std::vector<FreeParameter>& parameters;
    const std::vector<double>& times;  ///< of the target, s
    const Objective& objective;
    const Carried& carried;
    CoreAmounts& core;

    document::Content tuned(std::span<const double> coordinates) const;
    /// `emission` is what the plume goes by: times its density.
    std::vector<Amounts> core_at(std::span<const double> coordinates) const;
    /// Of the told curves; infinite where the core refuses the values.
    double cost_at(std::span<const double> coordinates) const;
    /// These will be asked for (CoreAmounts::expect).
    void expect(std::span<const std::vector<double>> places) const;
};

/// Columns are the offset of the veil and the parameters; rows as in Objective::residuals.
struct Linearised {
    std::vector<double> residuals, slopes;  ///< slopes[row * columns + column]
    std::size_t columns = 0;
    std::size_t fitted = 0;  ///< of the columns: the others are held, and not fitted to the amounts
};

/// Where the core refuses the values, slopes of amounts are 0: of one parameter, that it cannot move, or of all.
Linearised linearised(const SearchSpace& space, std::span<const double> coordinates);

inline constexpr double unlimited = 1e9;  ///< coordinates

struct SearchOptions {
    std::vector<bool> held = {};         ///< of each parameter: it stays where it is; empty: none does
    double radius = unlimited;           ///< coordinates: how far each may move
    std::size_t others = 0;              ///< besides the start, so many places are tried, spread evenly over the bounds
    std::uint32_t seed = 1;              ///< of those places
    std::vector<double> also = {};       ///< one more place; empty: none
    std::function<bool()> goes_on = {};  ///< false ends the search with what it has
};

/// Coordinates of the nearest curves that were found.
std::vector<double> search(const SearchSpace& space, std::vector<double> start, const SearchOptions& options);

}  // namespace lapfx::match
