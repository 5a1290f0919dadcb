// Numbers as people read and drag them: decimals that fit a step, logarithmic scales, round values.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace lapfx::ui {

/// Decimals that show one `step`: 0.05 -> 2, 0.25 -> 2, 10 -> 0. At most 9.
int decimals_of(double step);

/// Writes `value` with so many decimals (std::to_chars, fixed; from 1e15 on, and below 1e-9 where not 0, in exponent
/// form), never
/// "-0". Returns the part of `buffer` that was written; 32 bytes are always enough.
std::string_view format_number(std::span<char> buffer, double value, int decimals);
/// The shortest text that reads back to the same double. It is used for copying and at the start of a text entry.
std::string_view format_exact(std::span<char> buffer, double value);
/// "1:23.45", of s, for time rulers.
std::string_view format_time(std::span<char> buffer, double seconds, int decimals);

enum class ValueScale : std::uint8_t {
    linear,
    logarithmic,  ///< equal ratios, equal ways; from 0 on, its first hundredth is linear up to `smallest`
};

/// Converts a value to its place along a slider, 0..1, and back. Both are monotonic and exact at the ends; there and
/// back the error is at most 1e-12 of the range. Outside of minimum..maximum they continue, so that a drag may leave
/// the soft range.
struct ValueRange {
    double minimum = 0, maximum = 1;
    ValueScale scale = ValueScale::linear;
    double smallest =
        0;  ///< of a logarithmic scale: below this magnitude it is linear; 0: a ten-thousandth of the range

    double place_of(double value) const;
    double value_at(double place) const;
};

/// The roundest number within [low, high]: 5 before 5.5 before 5.25; 0 before all; low > high is swapped.
double roundest(double low, double high);
/// The nearest multiple of `step` from `origin`; step 0: the value.
double snap(double value, double step, double origin = 0);

/// Round places for the ticks of an axis: steps of 1, 2 or 5 times a power of ten, at most `most` of them.
struct Ticks {
    double first = 0, step = 1;
    int count = 0, decimals = 0;
};
Ticks ticks(double minimum, double maximum, int most);

}  // namespace lapfx::ui
