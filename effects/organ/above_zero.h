// Of a triangle with a value linear in it: where the value is above zero. Pure; any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lapfx::organ {

struct AboveZero {
    double share = 0.0;  ///< of the triangle's area, 0..1
    double mean = 0.0;   ///< of the value there
};

/// Of the values at the corners. Three zeros are nowhere above.
inline AboveZero above_zero(double a, double b, double c) {
    double v[3] = {a, b, c};
    std::sort(v, v + 3);
    if (v[2] <= 0.0) return {};
    if (v[0] >= 0.0) return {1.0, (v[0] + v[1] + v[2]) / 3.0};
    if (v[1] <= 0.0) return {v[2] * v[2] / ((v[2] - v[0]) * (v[2] - v[1])), v[2] / 3.0};
    const double below_share = v[0] * v[0] / ((v[0] - v[1]) * (v[0] - v[2]));
    const double whole = (v[0] + v[1] + v[2]) / 3.0, below = below_share * v[0] / 3.0;
    return {1.0 - below_share, (whole - below) / (1.0 - below_share)};
}

/// A part of a sum over triangles, in whole units: such a sum is the same in whatever order it is made. Parts of absurd
/// size (a file with a wrong unit) are cut off, so that it has room.
inline std::int64_t whole_units(double value, double unit) {
    constexpr double largest = 1e12;
    const double count = value / unit;
    return std::llround(count < largest ? count : largest);
}

}  // namespace lapfx::organ
