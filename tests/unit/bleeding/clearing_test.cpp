#include "bleeding/clearing_cpu.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/meshes.h"

namespace lapfx::bleeding {
namespace {

constexpr glm::dvec3 down{0.0, 0.0, 1.0};

BleedingParameters reach(double suction, double irrigation) {
    BleedingParameters b;
    b.suction_radius = suction;
    b.irrigation_radius = irrigation;
    return b;
}

class ClearingTest : public testing::Test {
  protected:
    Surface surface{test::plane(60.0, 60)};
    Clearing clearing{surface, down};

    double last_at(double x, double z) const {
        const SurfacePoint p = surface.closest_point({x, 0, z});
        const auto& corners = surface.triangles[p.triangle];
        std::uint32_t best = corners[0];
        for (const std::uint32_t c : corners)
            if (glm::distance(surface.positions[c], p.position) < glm::distance(surface.positions[best], p.position))
                best = c;
        return clearing.last(best);
    }
};

TEST_F(ClearingTest, SuctionClearsItsDiscWhileItLastsAndBloodIsDrawnInAtASpeed) {
    clearing.set(std::vector<ToolContact>{{.action = ToolAction::suction, .time = 1.0, .duration = 2.0}}, reach(8, 15));
    clearing.update(0.5);
    EXPECT_FALSE(clearing.update(1.0));
    EXPECT_TRUE(clearing.update(1.15));
    EXPECT_DOUBLE_EQ(last_at(4, 0), 1.15) << "drawn in at 40 mm/s: 0.1 s";
    EXPECT_EQ(last_at(7, 0), Clearing::never) << "0.175 s";
    clearing.update(2.0);
    EXPECT_DOUBLE_EQ(last_at(7, 0), 2.0);
    EXPECT_EQ(last_at(9, 0), Clearing::never);
    clearing.update(50.0);
    EXPECT_DOUBLE_EQ(last_at(7, 0), 3.0) << "until the end of the contact";
    EXPECT_DOUBLE_EQ(clearing.latest(), 3.0);
    EXPECT_FALSE(clearing.update(60.0));
    EXPECT_TRUE(clearing.update(0.0)) << "back to before";
    EXPECT_EQ(last_at(0, 0), Clearing::never);
}

TEST_F(ClearingTest, AMovingTipClearsEachPlaceWhileItIsInReach) {
    clearing.set(
        std::vector<ToolContact>{
            {.action = ToolAction::suction, .time = 0.0, .duration = 4.0, .position = {-20, 0, 0}, .to = {20, 0, 0}}},
        reach(5, 15));
    clearing.update(100.0);
    EXPECT_NEAR(last_at(0, 0), 2.5, 1e-9) << "10 mm/s: past x = 0 at 2 s, 5 mm on at 2.5 s";
    EXPECT_NEAR(last_at(0, 3), 2.4, 1e-9) << "half chord 4 mm";
    EXPECT_EQ(last_at(0, 6), Clearing::never);
    EXPECT_NEAR(last_at(20, 0), 4.0, 1e-9);
}

TEST_F(ClearingTest, WaterRunsDownhill) {
    clearing.set(std::vector<ToolContact>{{.action = ToolAction::irrigation, .time = 0.0, .duration = 3.0}},
                 reach(8, 10));
    clearing.update(2.0);
    EXPECT_NE(last_at(0, 14), Clearing::never) << "half as far again";
    EXPECT_EQ(last_at(0, 16), Clearing::never);
    EXPECT_NE(last_at(9, 0), Clearing::never);
    EXPECT_EQ(last_at(0, -11), Clearing::never);
}

TEST_F(ClearingTest, OtherActionsAndBadNumbersClearNothing) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<ToolContact> contacts(5, {.action = ToolAction::suction, .time = 0.0, .duration = 1.0});
    contacts[0].action = ToolAction::cauterise;
    contacts[1].position.x = nan;
    contacts[2].time = nan;
    contacts[3].duration = -1.0;
    contacts[4].to.z = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(clearing.set(contacts, reach(8, 15)));
    EXPECT_FALSE(clearing.update(0.5));
    EXPECT_FALSE(clearing.any());
}

TEST_F(ClearingTest, WhatIsTakenAwayOrChangedLeavesNothingBehind) {
    std::vector<ToolContact> contacts{
        {.action = ToolAction::suction, .time = 0.0, .duration = 1.0},
        {.action = ToolAction::suction, .time = 0.0, .duration = 1.0, .position = {20, 0, 0}}};
    contacts[1].to = contacts[1].position;
    clearing.set(contacts, reach(4, 15));
    clearing.update(9.0);
    EXPECT_DOUBLE_EQ(last_at(20, 0), 1.0);
    contacts[1].position = contacts[1].to = {-20, 0, 0};
    EXPECT_TRUE(clearing.set(contacts, reach(4, 15)));
    clearing.update(9.0);
    EXPECT_EQ(last_at(20, 0), Clearing::never);
    EXPECT_DOUBLE_EQ(last_at(-20, 0), 1.0);
    contacts.pop_back();
    clearing.set(contacts, reach(4, 15));
    clearing.update(9.0);
    EXPECT_EQ(last_at(-20, 0), Clearing::never);
    EXPECT_DOUBLE_EQ(last_at(0, 0), 1.0);
}

}  // namespace
}  // namespace lapfx::bleeding
