#include "ui/value/number.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <limits>

namespace lapfx::ui {

namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest_power = 1e-290;  // below, powers of ten have no inverse

/// `digits` times ten to `exponent`; the double nearest to that decimal number while both parts are exact.
double decimal(double digits, int exponent) {
    constexpr double exact[] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
    const int size = std::abs(exponent);
    const double power = size < 10 ? exact[size] : std::pow(10.0, size);
    return exponent < 0 ? digits / power : digits * power;
}

std::string_view written(std::span<char> buffer, std::to_chars_result result) {
    if (result.ec != std::errc()) return {};  // smaller than the 32 bytes that are asked for
    return {buffer.data(), static_cast<std::size_t>(result.ptr - buffer.data())};
}

/// A line through 0 up to `knee`, of height `foot`, then logarithms; the same mirrored below 0. Every number has its
/// place, so that a drag can go anywhere.
struct Bend {
    double knee, foot;

    double of(double value) const {
        const double magnitude = std::abs(value);
        if (magnitude <= knee) return foot * (value / knee);
        return std::copysign(foot + std::log(magnitude / knee), value);
    }
    double back(double way) const {
        const double magnitude = std::abs(way);
        if (magnitude <= foot) return knee * (way / foot);
        return std::copysign(std::min(largest, knee * std::exp(magnitude - foot)), way);
    }
};

Bend bend_of(const ValueRange& range) {
    double knee = range.smallest > 0 ? range.smallest : range.maximum * 1e-4 - range.minimum * 1e-4;
    const bool ratios_only = range.minimum > 0;
    if (ratios_only) return {std::min(knee, range.minimum), 1};  // the line is below the range
    const auto decades = [&](double end) { return std::max(0.0, std::log(std::abs(end) / knee)); };
    const int sides = range.minimum < 0 && range.maximum > 0 ? 2 : 1;
    const double ways = decades(range.minimum) + decades(range.maximum);
    return {knee, ways > 0 ? 0.01 * ways / (1 - 0.01 * sides) : 1};
}

/// Also where a range is so narrow that logarithms in it are as good as straight, but not as exact.
bool is_straight(const ValueRange& range) {
    const double farthest = std::max(std::abs(range.minimum), std::abs(range.maximum));
    return range.scale == ValueScale::linear || range.maximum - range.minimum < 0.05 * farthest;
}

/// Most numbers of a UI are short: an integer with a point in it, several times faster than to_chars of a double.
/// Nothing, where the multiplication's rounding could decide between two results.
std::string_view format_quickly(std::span<char> buffer, double value, int decimals) {
    constexpr double tens[] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};
    if (decimals < 0 || decimals > 6 || !(std::abs(value) < 1e8) || buffer.size() < 32) return {};
    const double scaled = std::abs(value) * tens[decimals];
    const auto digits = static_cast<std::uint64_t>(scaled + 0.5);  // casts, not floor: that is a call without SSE 4.1
    const auto nearest = static_cast<double>(digits);
    if (std::abs(std::abs(scaled - nearest) - 0.5) < 1e-3 || (nearest == 0 && value != 0)) return {};
    char* at = buffer.data();
    if (value < 0) *at++ = '-';
    const auto before_point =
        static_cast<std::uint32_t>(nearest / tens[decimals]);  // exact enough: both are whole, below 2^53
    at = std::to_chars(at, buffer.data() + buffer.size(), before_point).ptr;
    if (decimals > 0) {
        *at = '.';
        auto rest = static_cast<std::uint32_t>(nearest - before_point * tens[decimals]);
        for (int i = decimals; i > 0; --i, rest /= 10) at[i] = static_cast<char>('0' + rest % 10);
        at += decimals + 1;
    }
    return {buffer.data(), static_cast<std::size_t>(at - buffer.data())};
}

}  // namespace

int decimals_of(double step) {
    const double magnitude = std::abs(step);
    if (!(magnitude > 0) || magnitude > largest) return 3;  // no step: what a person still reads
    for (int decimals = 0; decimals < 9; ++decimals) {
        const double digits = decimal(magnitude, decimals);
        // A cast, not std::round, which is a call; beyond 2^53 all are whole.
        const double nearest = digits < 9e15 ? static_cast<double>(static_cast<std::int64_t>(digits + 0.5)) : digits;
        if (std::abs(digits - nearest) <= 1e-6 * digits) return decimals;
    }
    return 9;
}

std::string_view format_number(std::span<char> buffer, double value, int decimals) {
    if (const std::string_view quick = format_quickly(buffer, value, decimals); !quick.empty()) return quick;
    char* const end = buffer.data() + buffer.size();
    const double magnitude = std::abs(value);
    const int precision = std::clamp(decimals, 0, 15);
    const bool exponent = magnitude >= 1e15 || (magnitude < 1e-9 && magnitude > 0);
    const auto format = exponent ? std::chars_format::scientific : std::chars_format::fixed;
    const std::string_view text = written(buffer, std::to_chars(buffer.data(), end, value, format, precision));
    const bool nothing = text.find_first_of("123456789n") == text.npos;  // "n": of nan and inf
    return text.starts_with('-') && (nothing || std::isnan(value)) ? text.substr(1) : text;
}

std::string_view format_exact(std::span<char> buffer, double value) {
    char* const end = buffer.data() + buffer.size();
    const double magnitude = std::abs(value);
    if (magnitude == 0 || std::isnan(value)) return format_number(buffer, value, 0);
    // Shortest of all would make 100000 "1e+05".
    if (magnitude >= 1e-5 && magnitude < 1e15) {
        return written(buffer, std::to_chars(buffer.data(), end, value, std::chars_format::fixed));
    }
    return written(buffer, std::to_chars(buffer.data(), end, value));
}

std::string_view format_time(std::span<char> buffer, double seconds, int decimals) {
    if (buffer.size() < 32) return {};
    if (!(std::abs(seconds) < 1e9)) return format_number(buffer, seconds, decimals);
    const int precision = std::clamp(decimals, 0, 6);
    const auto unit = static_cast<std::int64_t>(std::pow(10.0, precision));
    std::int64_t left = std::llround(std::abs(seconds) * static_cast<double>(unit));
    char* at = buffer.data();
    const auto write = [&](std::int64_t count, int width) {  // with zeros in front
        std::int64_t weight = 1;
        for (int i = 1; i < width; ++i) weight *= 10;
        for (; count < weight && weight > 1; weight /= 10) *at++ = '0';
        at = std::to_chars(at, buffer.data() + buffer.size(), count).ptr;
    };
    if (seconds < 0 && left > 0) *at++ = '-';
    const std::int64_t hours = left / (3600 * unit);
    if (hours > 0) write(hours, 1), *at++ = ':';
    left %= 3600 * unit;
    write(left / (60 * unit), hours > 0 ? 2 : 1), *at++ = ':';
    left %= 60 * unit;
    write(left / unit, 2);
    if (precision > 0) *at++ = '.', write(left % unit, precision);
    return {buffer.data(), static_cast<std::size_t>(at - buffer.data())};
}

double ValueRange::place_of(double value) const {
    assert(minimum <= maximum);
    if (minimum == maximum || value == minimum) return 0;
    if (value == maximum) return 1;
    double way = value, first = minimum, last = maximum;
    if (!is_straight(*this)) {
        const Bend bend = bend_of(*this);
        way = bend.of(value);
        first = bend.of(minimum), last = bend.of(maximum);
    }
    const double place = (way / 2 - first / 2) / (last / 2 - first / 2);  // halves: the whole may be beyond any number
    // Rounding must not carry it over an end.
    if (value < minimum) return std::min(place, 0.0);
    return value > maximum ? std::max(place, 1.0) : std::clamp(place, 0.0, 1.0);
}

double ValueRange::value_at(double place) const {
    assert(minimum <= maximum);
    if (minimum == maximum || place == 0) return minimum;
    if (place == 1) return maximum;
    double value = 0;
    if (is_straight(*this)) {
        value = std::lerp(minimum, maximum, place);
    } else {
        const Bend bend = bend_of(*this);
        value = bend.back(std::lerp(bend.of(minimum), bend.of(maximum), place));
    }
    if (place < 0) return std::clamp(value, -largest, minimum);
    return place > 1 ? std::clamp(value, maximum, largest) : std::clamp(value, minimum, maximum);
}

double roundest(double low, double high) {
    if (low > high) std::swap(low, high);
    if (low <= 0 && high >= 0) return 0;
    if (high < 0) return -roundest(-high, -low);
    if (!(high > low) || high > largest || high < smallest_power) return low;
    // The first power of ten, from above, that has multiples within: at most nine.
    const int top = static_cast<int>(std::floor(std::log10(high)));
    for (int exponent = top; exponent > top - 17; --exponent) {
        const double first = std::ceil(decimal(low, -exponent)), last = std::floor(decimal(high, -exponent));
        if (first > last) continue;
        double digits = std::floor(last / 5) * 5;
        if (digits < first)
            digits = std::clamp(2 * std::round((first + last) / 4), first, last);  // no half: an even one
        if (exponent == top && first <= 1) digits = 1;
        return std::clamp(decimal(digits, exponent), low, high);
    }
    return low;
}

double snap(double value, double step, double origin) {
    const double magnitude = std::abs(step);
    const double count = std::round((value - origin) / magnitude);
    if (!(magnitude > 0) || !std::isfinite(count * magnitude)) return value;
    // Steps of a tenth and such: by division, so that three of them are 0.3 and not 0.30000000000000004.
    const double parts = std::round(1 / magnitude);
    return origin + (std::abs(parts * magnitude - 1) < 1e-15 ? count / parts : count * magnitude);
}

Ticks ticks(double minimum, double maximum, int most) {
    if (minimum > maximum) std::swap(minimum, maximum);
    const double range = maximum - minimum;
    if (most < 1 || !std::isfinite(range)) return {};
    if (range < smallest_power || range > 1e300) return {.first = minimum, .step = 1, .count = 1, .decimals = 0};
    int exponent = static_cast<int>(std::floor(std::log10(range / most))) - 1;
    for (int size = 0;; ++size) {
        constexpr int sizes[] = {1, 2, 5};
        if (size == 3) size = 0, ++exponent;
        const double step = decimal(sizes[size], exponent);
        // A tick on an end counts in spite of rounding.
        const double first = std::ceil(minimum / step - 1e-9), last = std::floor(maximum / step + 1e-9);
        if (last - first + 1 > most) continue;
        return {.first = decimal(first * sizes[size], exponent) + 0.0,
                .step = step,
                .count = std::max(0, static_cast<int>(last - first + 1)),
                .decimals = std::clamp(-exponent, 0, 15)};
    }
}

}  // namespace lapfx::ui
