#include "app/files/organ_choice.h"

#include <gtest/gtest.h>

namespace lapfx::app {
namespace {

TEST(OrganChoice, TheUnitIsGuessedFromTheSize) {
    EXPECT_EQ(likely_scale(0.3, 1), 1000) << "metres";
    EXPECT_EQ(likely_scale(20000, 1000), std::nullopt) << "no unit makes an organ of this";
    EXPECT_EQ(likely_scale(180, 1000), 1) << "mm taken for metres";
    EXPECT_EQ(likely_scale(180, 1), std::nullopt) << "it is right already";
    EXPECT_EQ(likely_scale(25, 1000), 10) << "of cm and inches what is nearer to a liver";
    EXPECT_EQ(likely_scale(9.6, 1), 10) << "possible, but few organs are so small";
    EXPECT_EQ(likely_scale(25, 1), std::nullopt);
    EXPECT_EQ(likely_scale(500, 1), std::nullopt);
    EXPECT_EQ(likely_scale(0, 1), std::nullopt);
}

TEST(OrganChoice, UnitsAndAxesAreFoundAgain) {
    for (std::size_t i = 0; i < length_units.size(); ++i)
        EXPECT_EQ(unit_of(length_units[i].millimetres), static_cast<int>(i));
    EXPECT_EQ(unit_of(3), -1);
    for (std::size_t i = 0; i < up_axes.size(); ++i) EXPECT_EQ(up_axis_of(up_axes[i].rotation), static_cast<int>(i));
    EXPECT_EQ(up_axis_of({10, 0, 0}), -1);
}

}  // namespace
}  // namespace lapfx::app
