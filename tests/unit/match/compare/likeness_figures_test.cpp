#include "match/compare/likeness_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace lapfx::match {
namespace {

TEST(LikenessFigures, EachHasANameOfItsOwnByWhichItIsFound) {
    std::set<std::string> names;
    for (const Figure& figure : figures()) {
        EXPECT_TRUE(names.insert(figure.name).second) << figure.name;
        EXPECT_EQ(figure_named(figure.name), &figure);
        EXPECT_FALSE(figure.help.empty()) << figure.name;
    }
    for (const char* name : {"blood_rms", "blood_bias", "blood_late", "blood_peak_ratio", "veil_rms", "veil_late",
                             "veil_area_ratio", "blood_delta_e", "smoke_delta_e", "tissue_delta_e"})
        EXPECT_TRUE(names.contains(name)) << name;
    EXPECT_EQ(figure_named("rms"), nullptr);
    EXPECT_EQ(figure_named(""), nullptr);
}

TEST(LikenessFigures, EachIsItsOwnValue) {
    Compared compared;
    double next = 1.0;
    const auto fill = [&next](std::optional<double>& value) { value = next++; };
    for (AmountLikeness* amount : {&compared.amounts.blood, &compared.amounts.veil}) {
        fill(amount->rms), fill(amount->bias), fill(amount->rms_over_error), fill(amount->error);
        fill(amount->late);
        fill(amount->peak_ratio), fill(amount->peak_over_error), fill(amount->area_ratio);
        fill(amount->rise_difference), fill(amount->decay_difference);
    }
    fill(compared.colors.blood), fill(compared.colors.smoke), fill(compared.colors.tissue);
    double expected = 1.0;
    for (const Figure& figure : figures()) EXPECT_EQ(figure.of(compared), expected++) << figure.name;
    EXPECT_EQ(expected, next) << "every figure has its row";
    for (const Figure& figure : figures()) EXPECT_FALSE(figure.of({})) << figure.name << " is not known";
}

TEST(LikenessFigures, TooLittleIsAsFarAsTooMuch) {
    const Figure &late = *figure_named("veil_late"), &ratio = *figure_named("veil_peak_ratio");
    EXPECT_DOUBLE_EQ(late.far(-1.5), 1.5);
    EXPECT_DOUBLE_EQ(late.far(1.5), 1.5);
    EXPECT_DOUBLE_EQ(ratio.far(2.0), 2.0);
    EXPECT_DOUBLE_EQ(ratio.far(0.5), 2.0);
    EXPECT_DOUBLE_EQ(ratio.far(1.0), 1.0);
    EXPECT_TRUE(std::isinf(ratio.far(0.0)));
    EXPECT_DOUBLE_EQ(figure_named("blood_area_ratio")->far(0.25), 4.0);
    EXPECT_DOUBLE_EQ(figure_named("veil_bias")->far(-0.1), 0.1);
}

}  // namespace
}  // namespace lapfx::match
