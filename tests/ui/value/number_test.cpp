#include "ui/value/number.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>

namespace lapfx::ui {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

std::string number(double value, int decimals) {
    std::array<char, 32> buffer;
    return std::string(format_number(buffer, value, decimals));
}
std::string exact(double value) {
    std::array<char, 32> buffer;
    return std::string(format_exact(buffer, value));
}
std::string time(double seconds, int decimals) {
    std::array<char, 32> buffer;
    return std::string(format_time(buffer, seconds, decimals));
}

/// A random number of any size, with either sign.
double any_number(std::mt19937_64& random) {
    std::uniform_real_distribution<double> exponent(-12, 14), sign(-1, 1);
    return std::copysign(std::pow(10.0, exponent(random)), sign(random));
}

TEST(Decimals, ShowOneStepAndNoMore) {
    EXPECT_EQ(decimals_of(0.05), 2);
    EXPECT_EQ(decimals_of(0.25), 2);
    EXPECT_EQ(decimals_of(10), 0);
    EXPECT_EQ(decimals_of(1), 0);
    EXPECT_EQ(decimals_of(2.5), 1);
    EXPECT_EQ(decimals_of(0.1), 1);
    EXPECT_EQ(decimals_of(0.3), 1);
    EXPECT_EQ(decimals_of(-0.125), 3);
    EXPECT_EQ(decimals_of(0.01F), 2) << "a float's error is no decimal";
    EXPECT_EQ(decimals_of(1e-9), 9);
    EXPECT_EQ(decimals_of(1e-12), 9);
    EXPECT_EQ(decimals_of(0), 3);
    EXPECT_EQ(decimals_of(infinity), 3);
    EXPECT_EQ(decimals_of(not_a_number), 3);
}

TEST(FormatNumber, WritesSoManyDecimals) {
    EXPECT_EQ(number(1.005, 1), "1.0");
    EXPECT_EQ(number(12, 2), "12.00");
    EXPECT_EQ(number(-3.14159, 3), "-3.142");
    EXPECT_EQ(number(1234567, 0), "1234567");
    EXPECT_EQ(number(2.5, -4), "2") << "of two as near, the even one, as to_chars has it";
}

TEST(FormatNumber, IsNeverMinusNothing) {
    EXPECT_EQ(number(-0.0, 0), "0");
    EXPECT_EQ(number(-0.001, 2), "0.00");
    EXPECT_EQ(number(-0.4, 0), "0");
    EXPECT_EQ(number(-0.006, 2), "-0.01");
    EXPECT_EQ(exact(-0.0), "0");
}

TEST(FormatNumber, GoesToExponentsWhereDigitsWouldNotFit) {
    EXPECT_EQ(number(1e15, 1), "1.0e+15");
    EXPECT_EQ(number(999999999999999, 0), "999999999999999");
    EXPECT_EQ(number(-2.5e300, 2), "-2.50e+300");
    EXPECT_EQ(number(5e-10, 1), "5.0e-10");
    EXPECT_EQ(number(1e-9, 9), "0.000000001");
    EXPECT_EQ(number(infinity, 2), "inf");
    EXPECT_EQ(number(-infinity, 2), "-inf");
    EXPECT_EQ(number(-not_a_number, 2), "nan");
}

TEST(FormatNumber, AlwaysFitsIn32BytesAndIsNearTheValue) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 100000; ++i) {
        const double value = any_number(random);
        const int decimals = static_cast<int>(random() % 18);
        const std::string text = number(value, decimals);
        double back = 0;
        ASSERT_EQ(std::from_chars(text.data(), text.data() + text.size(), back).ec, std::errc()) << value;
        ASSERT_LE(std::abs(back - value), 0.5 * std::pow(10.0, -std::min(decimals, 15)) + 1e-12 * std::abs(value))
            << text;
        const std::string most = number(std::bit_cast<double>(random()), decimals);
        ASSERT_FALSE(most.empty());
    }
    EXPECT_EQ(number(-999999999999999, 15).size(), 32u);
    std::array<char, 3> small;
    EXPECT_EQ(format_number(small, 1234, 0), "");
}

TEST(FormatNumber, ShortNumbersAreThoseOfToChars) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> exponent(-9, 9), mantissa(-10, 10);
    char mine[32], theirs[64];
    for (int i = 0; i < 200000; ++i) {
        const int decimals = static_cast<int>(random() % 8);
        double value = mantissa(random) * std::pow(10.0, exponent(random));
        if (i % 3 == 0) value = std::round(value * 8) / 8;  // halves, which have to be rounded to the even digit
        const auto end = std::to_chars(theirs, theirs + sizeof theirs, value, std::chars_format::fixed, decimals).ptr;
        std::string expected(theirs, end);
        if (expected.find_first_of("123456789") == expected.npos && expected.starts_with('-')) expected.erase(0, 1);
        if (std::abs(value) < 1e-9 && value != 0) continue;  // written with an exponent
        ASSERT_EQ(format_number(mine, value, decimals), expected) << decimals;
    }
}

TEST(FormatExact, ReadsBackToTheSameNumberInFewDigits) {
    EXPECT_EQ(exact(0.1), "0.1");
    EXPECT_EQ(exact(100000), "100000");
    EXPECT_EQ(exact(-2.50), "-2.5");
    EXPECT_EQ(exact(1e-5), "0.00001");
    EXPECT_EQ(exact(1e22), "1e+22");
    std::mt19937_64 random(2);
    for (int i = 0; i < 100000; ++i) {
        const double value = i % 2 == 0 ? any_number(random) : std::bit_cast<double>(random());
        if (!std::isfinite(value)) continue;
        const std::string text = exact(value);
        double back = 0;
        ASSERT_EQ(std::from_chars(text.data(), text.data() + text.size(), back).ec, std::errc()) << value;
        ASSERT_EQ(back, value) << text;
    }
}

TEST(FormatTime, ReadsAsAClock) {
    EXPECT_EQ(time(83.45, 2), "1:23.45");
    EXPECT_EQ(time(0, 0), "0:00");
    EXPECT_EQ(time(5.05, 1), "0:05.1");
    EXPECT_EQ(time(5.004, 3), "0:05.004");
    EXPECT_EQ(time(59.999, 2), "1:00.00") << "carried";
    EXPECT_EQ(time(3599.9999, 1), "1:00:00.0");
    EXPECT_EQ(time(3723, 0), "1:02:03");
    EXPECT_EQ(time(-61.5, 1), "-1:01.5");
    EXPECT_EQ(time(-0.001, 2), "0:00.00");
    EXPECT_EQ(time(1e9, 1), "1000000000.0");
    EXPECT_EQ(time(-999999999, 6), "-277777:46:39.000000");
    EXPECT_EQ(time(not_a_number, 1), "nan");
}

/// A random range, such as parameters have, or a stranger one.
ValueRange any_range(std::mt19937_64& random) {
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto scale = static_cast<ValueScale>(random() % 2);
    ValueRange range{.scale = scale};
    const double size = std::pow(10.0, uniform(-3, 6));
    switch (random() % 4) {
        case 0:
            range.minimum = 0, range.maximum = size;
            break;
        case 1:
            range.minimum = size * std::pow(10.0, -uniform(0.001, 6)), range.maximum = size;
            break;
        case 2:
            range.minimum = -size, range.maximum = size * uniform(0, 2);
            break;
        default:
            range.minimum = -size, range.maximum = size * uniform(-0.99, 0);
            break;
    }
    if (random() % 2 == 0) range.smallest = size * std::pow(10.0, -uniform(0, 6));
    return range;
}

TEST(ValueRange, EndsAreExactAndWaysGoBackAndForthOnEveryScale) {
    std::mt19937_64 random(3);
    for (int i = 0; i < 100000; ++i) {
        const ValueRange range = any_range(random);
        const double width = range.maximum - range.minimum;
        const auto about = [&] {
            return testing::Message() << range.minimum << ".." << range.maximum << ' ' << static_cast<int>(range.scale)
                                      << ' ' << range.smallest;
        };
        ASSERT_EQ(range.place_of(range.minimum), 0) << about();
        ASSERT_EQ(range.place_of(range.maximum), 1) << about();
        ASSERT_EQ(range.value_at(0), range.minimum) << about();
        ASSERT_EQ(range.value_at(1), range.maximum) << about();
        std::uniform_real_distribution<double> place(-0.5, 1.5);
        double low = place(random), high = place(random);
        if (low > high) std::swap(low, high);
        ASSERT_LE(range.value_at(low), range.value_at(high)) << about() << ' ' << low << ' ' << high;
        ASSERT_LE(range.place_of(range.value_at(low)), range.place_of(range.value_at(high))) << about();
        const double value = std::uniform_real_distribution<double>(range.minimum, range.maximum)(random);
        ASSERT_GE(range.place_of(value), 0) << about();
        ASSERT_LE(range.place_of(value), 1) << about();
        ASSERT_NEAR(range.value_at(range.place_of(value)), value, 1e-12 * width) << about();
        ASSERT_GE(range.value_at(std::nextafter(0.0, 1.0)), range.minimum) << about();
        ASSERT_LE(range.value_at(std::nextafter(0.0, -1.0)), range.minimum) << about();
        ASSERT_LE(range.value_at(std::nextafter(1.0, 0.0)), range.maximum) << about();
        ASSERT_GE(range.value_at(std::nextafter(1.0, 2.0)), range.maximum) << about();
        ASSERT_LE(range.place_of(std::nextafter(range.minimum, -infinity)), 0) << about();
        ASSERT_GE(range.place_of(std::nextafter(range.maximum, infinity)), 1) << about();
        const double inside = std::clamp(high, 0.0, 1.0);
        ASSERT_NEAR(range.place_of(range.value_at(inside)), inside, 1e-12) << about();
    }
}

TEST(ValueRange, GoesOnOutside) {
    for (const ValueScale scale : {ValueScale::linear, ValueScale::logarithmic}) {
        const ValueRange range{.minimum = 1, .maximum = 100, .scale = scale};
        for (const double value : {-1000.0, -1.0, 0.0, 0.5, 150.0, 1e5}) {
            const double place = range.place_of(value);
            EXPECT_TRUE(value < 1 ? place < 0 : place > 1) << value << ' ' << static_cast<int>(scale);
            EXPECT_NEAR(range.value_at(place), value, 1e-9 * std::abs(value) + 1e-12) << static_cast<int>(scale);
        }
        EXPECT_TRUE(std::isfinite(range.value_at(1e6)));
        EXPECT_TRUE(std::isfinite(range.value_at(-1e6)));
    }
}

TEST(ValueRange, LinearHasEqualWaysForEqualDifferences) {
    const ValueRange range{.minimum = -10, .maximum = 30};
    EXPECT_DOUBLE_EQ(range.place_of(0), 0.25);
    EXPECT_DOUBLE_EQ(range.value_at(0.75), 20);
    EXPECT_DOUBLE_EQ(range.value_at(-0.25), -20);
    const ValueRange all{.minimum = -1.7e308, .maximum = 1.7e308};
    EXPECT_DOUBLE_EQ(all.place_of(0), 0.5);
}

TEST(ValueRange, LogarithmicHasEqualWaysForEqualRatios) {
    const ValueRange range{.minimum = 0.01, .maximum = 100, .scale = ValueScale::logarithmic};
    EXPECT_NEAR(range.place_of(1), 0.5, 1e-12);
    EXPECT_NEAR(range.place_of(10), 0.75, 1e-12);
    EXPECT_NEAR(range.value_at(1.25), 1000, 1e-9) << "outside, too";
    const ValueRange wide{.minimum = 1, .maximum = 1e6, .scale = ValueScale::logarithmic};
    EXPECT_NEAR(wide.place_of(1000), 0.5, 1e-12) << "its smallest is not above its minimum";
}

TEST(ValueRange, LogarithmicFromNothingBeginsWithALineOfOneHundredth) {
    const ValueRange range{.minimum = 0, .maximum = 10, .scale = ValueScale::logarithmic, .smallest = 0.1};
    EXPECT_NEAR(range.place_of(0.1), 0.01, 1e-12);
    EXPECT_NEAR(range.place_of(0.05), 0.005, 1e-12);
    EXPECT_NEAR(range.place_of(1), 0.505, 1e-12);
    const ValueRange plain{.minimum = 0, .maximum = 10, .scale = ValueScale::logarithmic};
    EXPECT_NEAR(plain.place_of(0.001), 0.01, 1e-12) << "a ten-thousandth of the range";
}

TEST(ValueRange, LogarithmicOverBothSignsIsTheSameToBothSides) {
    const ValueRange range{.minimum = -100, .maximum = 100, .scale = ValueScale::logarithmic, .smallest = 0.01};
    EXPECT_NEAR(range.place_of(0), 0.5, 1e-12);
    EXPECT_NEAR(range.place_of(0.01), 0.51, 1e-12);
    EXPECT_NEAR(range.place_of(1), 0.755, 1e-12);
    EXPECT_NEAR(range.place_of(-1), 0.245, 1e-12);
}

TEST(ValueRange, ARangeOfOneValueHasOnePlace) {
    const ValueRange range{.minimum = 3, .maximum = 3, .scale = ValueScale::logarithmic};
    EXPECT_EQ(range.place_of(3), 0);
    EXPECT_EQ(range.place_of(7), 0);
    EXPECT_EQ(range.value_at(0.4), 3);
    const ValueRange narrow{.minimum = 1, .maximum = std::nextafter(1.0, 2.0), .scale = ValueScale::logarithmic};
    EXPECT_EQ(narrow.place_of(narrow.maximum), 1);
    EXPECT_TRUE(std::isfinite(narrow.place_of(2)));
}

TEST(Roundest, PrefersFewDigitsThenHalves) {
    EXPECT_EQ(roundest(4.8, 5.6), 5);
    EXPECT_EQ(roundest(5.2, 5.6), 5.5);
    EXPECT_EQ(roundest(5.21, 5.29), 5.25);
    EXPECT_EQ(roundest(-1, 3), 0);
    EXPECT_EQ(roundest(0, 3), 0);
    EXPECT_EQ(roundest(3, 0), 0) << "swapped";
    EXPECT_EQ(roundest(-5.6, -5.2), -5.5);
    EXPECT_EQ(roundest(7, 13), 10);
    EXPECT_EQ(roundest(0.9, 7), 1);
    EXPECT_EQ(roundest(970, 1040), 1000);
    EXPECT_EQ(roundest(6.1, 6.3), 6.2);
    EXPECT_EQ(roundest(0.29, 0.31), 0.3);
    EXPECT_EQ(roundest(5.9, 8.1), 8);
    EXPECT_EQ(roundest(1.234567, 1.234567), 1.234567);
}

/// The number of digits before a decimal number has only zeros. People call a number round if there are few.
std::size_t digits_of(double value) {
    std::array<char, 32> buffer;
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::scientific).ptr;
    const std::string_view text(buffer.data(), end);
    return text.substr(0, text.find('e')).size() - (value < 0 ? 1 : 0);
}

TEST(Roundest, IsWithinAndHasTheFewestDigits) {
    std::mt19937_64 random(4);
    for (int i = 0; i < 100000; ++i) {
        double low = any_number(random);
        double high =
            random() % 2 == 0 ? any_number(random) : low * (1 + std::pow(10.0, -static_cast<double>(random() % 18)));
        if (i % 5 == 0) low = std::bit_cast<double>(random()), high = std::bit_cast<double>(random());
        if (std::isnan(low) || std::isnan(high)) continue;
        const double round = roundest(low, high);
        if (low > high) std::swap(low, high);
        ASSERT_GE(round, low);
        ASSERT_LE(round, high) << low;
        if (low < 0 && high > 0) {
            ASSERT_EQ(round, 0);
            continue;
        }
        // In a narrower range a double has too few digits for other numbers.
        for (int k = 0; k < 4 && i % 5 != 0 && high - low > 1e-14 * std::abs(high); ++k) {
            const double other = std::strtod(
                number(std::uniform_real_distribution<double>(low, high)(random), static_cast<int>(random() % 9))
                    .c_str(),
                nullptr);
            if (other >= low && other <= high) {
                ASSERT_LE(digits_of(round), digits_of(other)) << low << ' ' << high << ' ' << other;
            }
        }
    }
    EXPECT_EQ(ticks(0, 5e-324, 5).count, 1);
    for (const double strange : {infinity, 5e-324, 1e-300, 1.7e308}) {
        EXPECT_EQ(roundest(strange, strange), strange);
        EXPECT_EQ(roundest(-strange, strange), 0);
    }
}

TEST(Snap, GoesToTheNearestStepFromTheOrigin) {
    EXPECT_EQ(snap(0.31, 0.1), 0.3) << "not 0.30000000000000004";
    EXPECT_EQ(snap(7.4, 5), 5);
    EXPECT_EQ(snap(7.6, -5), 10);
    EXPECT_EQ(snap(1.3, 0.5, 0.2), 1.2);
    EXPECT_EQ(snap(-0.26, 0.25), -0.25);
    EXPECT_EQ(snap(3.21, 0), 3.21);
    EXPECT_EQ(snap(3e300, 1e-300), 3e300);
    EXPECT_EQ(snap(1.5, infinity), 1.5);
    std::mt19937_64 random(5);
    for (int i = 0; i < 100000; ++i) {
        const double step = std::abs(any_number(random)),
                     value = step * std::uniform_real_distribution<double>(-1e4, 1e4)(random);
        ASSERT_LE(std::abs(snap(value, step) - value), step * 0.5000001);
        ASSERT_NEAR(snap(value, step) / step, std::round(snap(value, step) / step), 1e-9);
    }
}

TEST(Ticks, AreRoundPlaces) {
    const Ticks t = ticks(0, 10, 6);
    EXPECT_EQ(t.first, 0);
    EXPECT_EQ(t.step, 2);
    EXPECT_EQ(t.count, 6);
    EXPECT_EQ(t.decimals, 0);
    const Ticks fine = ticks(0.13, 0.49, 5);
    EXPECT_EQ(fine.first, 0.2);
    EXPECT_EQ(fine.step, 0.1);
    EXPECT_EQ(fine.count, 3);
    EXPECT_EQ(fine.decimals, 1);
    EXPECT_EQ(ticks(10, 0, 6).step, 2) << "swapped";
    EXPECT_EQ(ticks(0, 0.3, 4).count, 4) << "the end counts in spite of rounding";
    EXPECT_EQ(ticks(0.1 + 0.2, 0.7, 5).count, 5) << "and so does the beginning";
    EXPECT_EQ(ticks(4, 4, 5).count, 1);
    EXPECT_EQ(ticks(4, 4, 5).first, 4);
    EXPECT_EQ(ticks(0, 1, 0).count, 0);
    EXPECT_EQ(ticks(0, infinity, 5).count, 0);
    EXPECT_EQ(ticks(not_a_number, 1, 5).count, 0);
}

TEST(Ticks, CoverTheRangeWithNoMoreThanAsked) {
    std::mt19937_64 random(6);
    for (int i = 0; i < 100000; ++i) {
        const double minimum = any_number(random), maximum = minimum + std::abs(any_number(random));
        const double slack = 1e-9 * (maximum - minimum) + 1e-12 * std::abs(minimum);
        if (maximum - minimum < 1e-9 * std::abs(minimum)) continue;
        const int most = 1 + static_cast<int>(random() % 30);
        const Ticks t = ticks(minimum, maximum, most);
        ASSERT_LE(t.count, most);
        ASSERT_LE(minimum - slack, t.first);
        ASSERT_LT(t.first - t.step, minimum + slack) << "none is missing in front";
        ASSERT_LE(t.first + (t.count - 1) * t.step, maximum + slack);
        ASSERT_GT(t.first + t.count * t.step, maximum - slack) << "nor behind";
        if (most >= 6) {
            ASSERT_GE(t.count * 5, most) << "not too few";
        }
        const double digits = std::abs(t.step) / std::pow(10.0, std::floor(std::log10(t.step) + 1e-9));
        ASSERT_TRUE(std::abs(digits - 1) < 1e-9 || std::abs(digits - 2) < 1e-9 || std::abs(digits - 5) < 1e-9)
            << t.step;
        if (t.step > 1e-9) {
            ASSERT_EQ(t.decimals, decimals_of(t.step));
        }
    }
}

}  // namespace
}  // namespace lapfx::ui
