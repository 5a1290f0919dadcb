#include "match/picture/color_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>

namespace lapfx::match {
namespace {

struct Pair {
    glm::dvec3 a, b;
    double difference;
};
// Table 1 of Sharma, Wu and Dalal 2005, to four decimals: hues around half a turn apart and of grey (1 to 16), large
// differences (17 to 20), differences of 1 (21 to 24), and measured ones (25 to 34).
constexpr Pair published[] = {
    {{50.0000, 2.6772, -79.7751}, {50.0000, 0.0000, -82.7485}, 2.0425},
    {{50.0000, 3.1571, -77.2803}, {50.0000, 0.0000, -82.7485}, 2.8615},
    {{50.0000, 2.8361, -74.0200}, {50.0000, 0.0000, -82.7485}, 3.4412},
    {{50.0000, -1.3802, -84.2814}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, -1.1848, -84.8006}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, -0.9009, -85.5211}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, 0.0000, 0.0000}, {50.0000, -1.0000, 2.0000}, 2.3669},
    {{50.0000, -1.0000, 2.0000}, {50.0000, 0.0000, 0.0000}, 2.3669},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0009}, 7.1792},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0010}, 7.1792},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0011}, 7.2195},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0012}, 7.2195},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0009, -2.4900}, 4.8045},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0010, -2.4900}, 4.8045},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0011, -2.4900}, 4.7461},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 0.0000, -2.5000}, 4.3065},
    {{50.0000, 2.5000, 0.0000}, {73.0000, 25.0000, -18.0000}, 27.1492},
    {{50.0000, 2.5000, 0.0000}, {61.0000, -5.0000, 29.0000}, 22.8977},
    {{50.0000, 2.5000, 0.0000}, {56.0000, -27.0000, -3.0000}, 31.9030},
    {{50.0000, 2.5000, 0.0000}, {58.0000, 24.0000, 15.0000}, 19.4535},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.1736, 0.5854}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2972, 0.0000}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 1.8634, 0.5757}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2592, 0.3350}, 1.0000},
    {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
    {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
    {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
    {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
    {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
    {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
    {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
    {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
    {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
    {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
};
constexpr double decimals = 0.5e-4 + 1e-9;

TEST(ColorDifference, IsThatOfThePublishedPairsInBothOrders) {
    static_assert(std::size(published) == 34);
    for (const Pair& pair : published) {
        const auto number = &pair - published + 1;
        EXPECT_NEAR(delta_e_2000(pair.a, pair.b), pair.difference, decimals) << "pair " << number;
        EXPECT_NEAR(delta_e_2000(pair.b, pair.a), pair.difference, decimals) << "pair " << number << ", turned round";
    }
}

TEST(ColorDifference, OfAColorToItselfIsNone) {
    for (const Pair& pair : published) EXPECT_EQ(delta_e_2000(pair.a, pair.a), 0.0);
    EXPECT_EQ(delta_e_2000({0, 0, 0}, {0, 0, 0}), 0.0);
}

TEST(ColorDifference, OfGreysIsTheWeightedDifferenceOfTheirLightness) {
    EXPECT_NEAR(delta_e_2000({0, 0, 0}, {100, 0, 0}), 100.0, 1e-9) << "their mean lightness is 50, which has weight 1";
    // Mean 65: 1 + 0.015 * 225 / sqrt(245).
    EXPECT_NEAR(delta_e_2000({60, 0, 0}, {70, 0, 0}), 10.0 / (1.0 + 0.015 * 225.0 / std::sqrt(245.0)), 1e-12);
}

void expect_lab(const glm::dvec3& found, const glm::dvec3& wanted, double within) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], wanted[k], within) << "channel " << k;
}

TEST(ColorDifference, LabIsThatOfTheCornersOfSrgb) {
    constexpr double published_to = 0.02;
    expect_lab(lab_of({1, 1, 1}), {100, 0, 0}, published_to);
    expect_lab(lab_of({0, 0, 0}), {0, 0, 0}, published_to);
    expect_lab(lab_of({1, 0, 0}), {53.24, 80.09, 67.20}, published_to);
    expect_lab(lab_of({0, 1, 0}), {87.73, -86.18, 83.18}, published_to);
    expect_lab(lab_of({0, 0, 1}), {32.30, 79.19, -107.86}, published_to);
}

TEST(ColorDifference, LightnessOfGreyIsTheCubeRootOfItsLight) {
    constexpr double as_float = 1e-3;
    expect_lab(lab_of_linear({0.2, 0.2, 0.2}), {116.0 * std::cbrt(0.2) - 16.0, 0, 0}, as_float);
    expect_lab(lab_of_linear({0.004, 0.004, 0.004}), {903.3 * 0.004, 0, 0}, as_float);
    // Code 128 is 0.2158605 of the light of white.
    EXPECT_NEAR(lab_of(glm::dvec3(128.0 / 255.0)).x, 116.0 * std::cbrt(0.2158605) - 16.0, as_float);
}

TEST(ColorDifference, LabOfLightIsThatOfItsCode) {
    expect_lab(lab_of_linear({0.2158605, 0.0, 1.0}), lab_of({128.0 / 255.0, 0.0, 1.0}), 1e-3);
}

TEST(ColorDifference, LabOfWhatNoScreenShowsIsThatOfTheNearest) {
    expect_lab(lab_of({1.2, -0.1, 0}), lab_of({1, 0, 0}), 0.0);
    expect_lab(lab_of_linear({2, 2, 2}), lab_of_linear({1, 1, 1}), 0.0);
}

}  // namespace
}  // namespace lapfx::match
