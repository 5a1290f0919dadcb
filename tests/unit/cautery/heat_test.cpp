#include "cautery/heat.h"

#include <gtest/gtest.h>

#include <limits>

#include "unit/cautery/support.h"

namespace lapfx::cautery {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Char, FollowsThePeak) {
    const CauteryParameters c = simple_parameters();
    EXPECT_EQ(char_of(37.0, c), 0.0);
    EXPECT_EQ(char_of(57.0, c), 0.0);
    EXPECT_NEAR(char_of(97.0, c), 0.35 * 0.5, 1e-12);
    EXPECT_NEAR(char_of(137.0, c), 0.35, 1e-12);
    EXPECT_NEAR(char_of(212.0, c), 0.35 + 0.65 * 0.5, 1e-12);
    EXPECT_NEAR(char_of(287.0, c), 1.0, 1e-12);
    EXPECT_NEAR(char_of(1000.0, c), 1.0, 1e-12);
}

TEST(Divided, IsOneTipRadiusWideWithASoftEdge) {
    CauteryParameters c = simple_parameters();
    c.tip_radius = 2.0;
    EXPECT_EQ(divided_at(0.0, ToolAction::cut, c), 1.0);
    EXPECT_EQ(divided_at(0.5, ToolAction::cut, c), 1.0);
    EXPECT_NEAR(divided_at(1.0, ToolAction::cut, c), 0.5, 1e-12) << "half at half the width of one radius";
    EXPECT_EQ(divided_at(1.5, ToolAction::cut, c), 0.0);
}

TEST(Passes, TellsWhenTheTipIsNear) {
    const ToolContact moving = along({0, 0, 0}, {10, 0, 0}, 5.0, 2.0);  // 5 mm/s
    const auto over = passes(moving, {4, 0, 3}, 5.0);
    ASSERT_TRUE(over);
    EXPECT_NEAR(over->from, 5.0, 1e-12) << "4 mm before the place: near from the start";
    EXPECT_NEAR(over->to, 5.0 + 8.0 / 5.0, 1e-12);
    EXPECT_FALSE(passes(moving, {4, 0, 5.1}, 5.0));
    EXPECT_FALSE(passes(moving, {16, 0, 0}, 5.0));
    const auto still = passes(at({1, 1, 1}, 3.0, 4.0), {1, 1, 2}, 1.5);
    ASSERT_TRUE(still);
    EXPECT_EQ(still->from, 3.0);
    EXPECT_EQ(still->to, 7.0);
    EXPECT_FALSE(passes(at({1, 1, 1}, 3.0, 4.0), {1, 1, 3}, 1.5));
}

TEST(Strength, OfTornTissueIsLessAndVesselsDecide) {
    const StrengthAt vessels = [](const glm::dvec3& p) { return p.x; };
    EXPECT_EQ(wound_strength(at({0, 0, 0}, 0, 1, ToolAction::cut), {9, 0, 0}, {}), 1.0);
    EXPECT_EQ(wound_strength(at({0, 0, 0}, 0, 1, ToolAction::tear), {9, 0, 0}, {}), 0.6);
    EXPECT_EQ(wound_strength(at({0, 0, 0}, 0, 1, ToolAction::cut), {0.25, 0, 0}, vessels), 0.25);
    EXPECT_EQ(wound_strength(at({0, 0, 0}, 0, 1, ToolAction::cut), {nan, 0, 0}, vessels), 0.0);
}

}  // namespace
}  // namespace lapfx::cautery
