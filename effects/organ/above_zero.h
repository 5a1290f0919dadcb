// Where a value that is linear in a triangle is above zero. Pure; any thread.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace lapfx::organ {

struct AboveZero {
    double share = 0.0;  ///< share of the triangle's area, 0..1
    double mean = 0.0;   ///< mean of the value there
};

/// From the values at the corners, in ascending order. Three zeros are nowhere above zero.
inline AboveZero above_zero(const std::array<double, 3>& v) {
    if (v[2] <= 0.0) return {};
    if (v[0] >= 0.0) return {1.0, (v[0] + v[1] + v[2]) / 3.0};
    if (v[1] <= 0.0) return {v[2] * v[2] / ((v[2] - v[0]) * (v[2] - v[1])), v[2] / 3.0};
    const double below_share = v[0] * v[0] / ((v[0] - v[1]) * (v[0] - v[2]));
    const double whole = (v[0] + v[1] + v[2]) / 3.0, below = below_share * v[0] / 3.0;
    return {1.0 - below_share, (whole - below) / (1.0 - below_share)};
}

/// A part of a sum over triangles, in whole units, so that the sum does not depend on the order. Parts of absurd size
/// (a file with a wrong unit) are limited, so that the sum does not overflow.
inline std::int64_t whole_units(double value, double unit) {
    constexpr double largest = 1e12;
    const double count = value / unit;
    return std::llround(count < largest ? count : largest);
}

}  // namespace lapfx::organ
