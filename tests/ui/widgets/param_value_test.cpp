#include "ui/widgets/param_value.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace lapfx::ui {
namespace {

double drag(const ParamOptions& o, double from, double pixels, double way, Mods mods = Mods::none) {
    double raw = from;
    return dragged(o, raw, pixels, way, mods, limits_of(o, from));
}

std::string shown(const ParamOptions& o, double value) {
    char buffer[32];
    return std::string(format_param(buffer, o, value));
}

TEST(ParamValue, ADragGoesThroughTheSoftRangeInItsWay) {
    const ParamOptions o{.minimum = 0, .maximum = 200};
    EXPECT_EQ(drag(o, 50, 30, 200), 80);
    EXPECT_EQ(drag(o, 50, -30, 100), 0) << "not beyond the soft range";
    EXPECT_EQ(drag(o, 50, 30, 200, Mods::shift), 53);
}

TEST(ParamValue, ADragAimsAtTheRoundestNumberWithinHalfAPixel) {
    const ParamOptions o{.minimum = 0, .maximum = 1};
    EXPECT_EQ(drag(o, 0.123456, 10, 100), 0.22) << "within 0.2185..0.2285";
    EXPECT_EQ(drag(o, 0.123456, 37.2, 100), 0.5) << "within 0.4905..0.5005";
    EXPECT_EQ(drag(o, 0.123456, 10, 100, Mods::shift), 0.133) << "within 0.13296..0.13396";
}

TEST(ParamValue, CtrlTakesStepsAndWithShiftTenthsOfThem) {
    const ParamOptions o{.minimum = 0, .maximum = 100, .step = 5};
    EXPECT_EQ(drag(o, 11, 11, 100, Mods::command), 20);
    EXPECT_EQ(drag(o, 11, 13, 100, Mods::command), 25);
    EXPECT_EQ(drag(o, 11, 13, 100, Mods::command | Mods::shift), 12.5);
}

TEST(ParamValue, TheEndsAreReachedEvenIfTheyAreNotRound) {
    const ParamOptions o{.minimum = -1.2345, .maximum = 7.3371, .step = 0.5};
    for (const Mods mods : {Mods::none, Mods::command, Mods::shift}) {
        EXPECT_EQ(drag(o, 7, 1000, 100, mods), 7.3371);
        EXPECT_EQ(drag(o, 0, -10000, 100, mods), -1.2345);
    }
}

TEST(ParamValue, TypedValuesOutsideOfTheSoftRangeCanBeDraggedFrom) {
    const ParamOptions o{.minimum = 0, .maximum = 10, .hard_maximum = 100};
    EXPECT_EQ(drag(o, 50, 10, 100), 50);
    EXPECT_NEAR(drag(o, 50, -10, 100), 49, 0.06);
    EXPECT_EQ(drag(o, 50, -5000, 100), 0);
}

TEST(ParamValue, TheHardRangeBoundsTheSoftOne) {
    const ParamOptions o{.minimum = 0, .maximum = 10, .hard_minimum = 2, .hard_maximum = 8};
    EXPECT_EQ(drag(o, 5, 1000, 100), 8);
    EXPECT_EQ(drag(o, 5, -1000, 100), 2);
}

TEST(ParamValue, AnEmptyRangeCannotBeDragged) {
    EXPECT_EQ(drag({.minimum = 5, .maximum = 5}, 7, 100, 100), 7);
}

TEST(ParamValue, WholeNumbersStayWhole) {
    const ParamOptions o{.minimum = 0, .maximum = 10, .integer = true};
    double raw = 3;
    for (int i = 0; i < 4; ++i) EXPECT_EQ(dragged(o, raw, 1, 100, Mods::none, {0, 10}), 3);
    for (int i = 0; i < 3; ++i) dragged(o, raw, 1, 100, Mods::none, {0, 10});
    EXPECT_EQ(dragged(o, raw, 1, 100, Mods::none, {0, 10}), 4) << "what is less than one adds up";
    EXPECT_EQ(stepped(o, 3, 1, true), 4) << "no tenths";
}

TEST(ParamValue, NothingJumpsWhenRangeScaleOrWayChangeInTheMiddle) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 20000; ++i) {
        double raw = unit(random) * 20 - 5;
        const auto any = [&] {
            ParamOptions o{.minimum = -10 * unit(random) - 6, .maximum = 16 + 100 * unit(random)};
            o.scale = unit(random) < 0.5 ? ValueScale::linear : ValueScale::logarithmic;
            o.smallest = 0.1;
            return o;
        };
        const ParamOptions first = any(), second = any();
        dragged(first, raw, 2 * unit(random), 100 + 400 * unit(random), Mods::none, limits_of(first, raw));
        const double before = raw;
        const double way = 100 + 400 * unit(random);
        dragged(second, raw, 1e-9, way, Mods::none, limits_of(second, raw));
        EXPECT_NEAR(raw, before, 1e-8);
    }
}

TEST(ParamValue, DragsStayWithinHalfAPixelOfWhereTheyAreAndComeBack) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 100000; ++i) {
        ParamOptions o{.minimum = unit(random) < 0.3 ? 0 : 10 * unit(random) - 20};
        o.maximum = 1 + 1000 * unit(random);
        o.scale = static_cast<ValueScale>(i % 3);
        if (o.scale == ValueScale::logarithmic) o.minimum = 0.01 + unit(random);
        const ValueRange range{o.minimum, o.maximum, o.scale, o.smallest};
        const double way = 50 + 500 * unit(random), start = range.value_at(0.2 + 0.6 * unit(random));
        const double pixels = way * 0.2 * (unit(random) * 2 - 1);
        double raw = start;
        const double value = dragged(o, raw, pixels, way, Mods::none, limits_of(o, start));
        ASSERT_GE(value, o.minimum);
        ASSERT_LE(value, o.maximum);
        ASSERT_LE(std::abs(range.place_of(value) - range.place_of(start) - pixels / way), 0.5 / way + 1e-9);
        dragged(o, raw, -pixels, way, Mods::none, limits_of(o, start));
        ASSERT_NEAR(range.place_of(raw), range.place_of(start), 1e-9);
    }
}

TEST(ParamValue, StepsAddUpWithoutNoise) {
    const ParamOptions o{.minimum = 0, .maximum = 1, .step = 0.1};
    double value = 0;
    for (int i = 1; i <= 10; ++i) {
        value = stepped(o, value, 1, false);
        EXPECT_EQ(value, i / 10.0);
    }
    EXPECT_EQ(stepped(o, 0.5, 1, true), 0.51);
    EXPECT_EQ(stepped(o, 0.5, -10, false), -0.5) << "limits are the caller's";
    EXPECT_EQ(stepped({.maximum = 60}, 10, 1, false), 11) << "a step of its own";
}

TEST(ParamValue, StepsOfOneKeyFollowTheScaleOverDecades) {
    const ParamOptions o{.minimum = 0.001, .maximum = 1000, .scale = ValueScale::logarithmic};
    double value = 0.001;
    int steps = 0;
    for (; value < 1000 && steps < 1000; ++steps) {
        const double next = stepped(o, value, 1, false);
        ASSERT_GT(next, value);
        ASSERT_NEAR(next / value, std::pow(10, 0.06), 0.1);
        value = next;
    }
    EXPECT_NEAR(steps, 100, 5);
    EXPECT_EQ(drag(o, 3.3, 1, 1000, Mods::command), 3);
    EXPECT_EQ(drag(o, 333, 1, 1000, Mods::command), 300);
}

TEST(ParamValue, DecimalsComeFromTheStepAndGoOnWhereTheValueDoes) {
    const ParamOptions o{.minimum = 0, .maximum = 60, .step = 0.5};
    EXPECT_EQ(shown(o, 12), "12.0");
    EXPECT_EQ(shown(o, 12.25), "12.25");
    EXPECT_EQ(shown(o, 12.125), "12.125");
    EXPECT_EQ(shown(o, 1.0 / 3), "0.333");
    EXPECT_EQ(shown({.maximum = 60, .step = 0.5, .decimals = 1}, 12.26), "12.3");
    EXPECT_EQ(shown({.maximum = 255, .integer = true}, 17), "17");
    EXPECT_EQ(shown({.maximum = 60}, 12), "12");
    const ParamOptions wide{.minimum = 0.001, .maximum = 1e5, .scale = ValueScale::logarithmic};
    EXPECT_EQ(shown(wide, 0.0123), "0.0123");
    EXPECT_EQ(shown(wide, 12345), "12345");
    EXPECT_EQ(shown(wide, 1.5), "1.50");
}

TEST(ParamValue, AnglesAndFloatsAreWrittenWithoutNoise) {
    char buffer[32];
    const ParamOptions degrees{.unit = "deg", .display = 180 / std::numbers::pi};
    EXPECT_EQ(format_whole(buffer, degrees, std::numbers::pi / 4 * degrees.display), "45");
    EXPECT_EQ(format_whole(buffer, {.single = true}, static_cast<double>(0.1F)), "0.1");
    EXPECT_EQ(format_whole(buffer, {}, 0.1 + 0.2), "0.30000000000000004") << "a double is what it is";
}

TEST(ParamValue, TheStandardIsMetWithinWhatTheKindOfNumberCanHold) {
    EXPECT_TRUE(is_standard({.standard = 0.1, .single = true}, static_cast<double>(0.1F)));
    EXPECT_FALSE(is_standard({.standard = 0.1}, 0.100001));
    EXPECT_FALSE(is_standard({.standard = 0.1, .single = true}, 0.1001));
    EXPECT_FALSE(is_standard({.standard = 0.0}, 1e-6));
    EXPECT_TRUE(is_standard({}, 5)) << "there is none";
    const ParamOptions degrees{.standard = 45.0, .display = 180 / std::numbers::pi};
    EXPECT_TRUE(is_standard(degrees, std::numbers::pi / 4 * degrees.display));
}

}  // namespace
}  // namespace lapfx::ui
