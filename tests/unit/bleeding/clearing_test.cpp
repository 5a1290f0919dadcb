#include "bleeding/clearing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/logged.h"
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
    test::Logged<Clearing> clearing{surface, down};

    std::vector<Clearing::Cap> caps_at(double x, double z) const {
        const SurfacePoint p = surface.closest_point({x, 0, z});
        const auto& corners = surface.triangles[p.triangle];
        std::uint32_t best = corners[0];
        for (const std::uint32_t c : corners)
            if (glm::distance(surface.positions[c], p.position) < glm::distance(surface.positions[best], p.position))
                best = c;
        std::vector<Clearing::Cap> caps;
        clearing.for_each(best, [&](const Clearing::Cap& cap) { caps.push_back(cap); });
        std::reverse(caps.begin(), caps.end());
        return caps;
    }
    /// The first cap, mm; 1000 where there is none.
    double cap_at(double x, double z) const {
        const auto caps = caps_at(x, z);
        return caps.empty() ? 1000.0 : static_cast<double>(caps[0].cap);
    }
    double time_at(double x, double z) const { return caps_at(x, z).at(0).time; }
};

TEST_F(ClearingTest, SuctionClearsADiscThatGrowsWhenTheTipIsPutOn) {
    clearing.set(std::vector<ToolContact>{{.action = ToolAction::suction, .time = 1.0, .duration = 2.0}}, reach(8, 15));
    clearing.update(0.5);
    EXPECT_FALSE(clearing.update(1.0));
    EXPECT_EQ(cap_at(0, 0), 1000.0);
    EXPECT_TRUE(clearing.update(1.15));
    EXPECT_NEAR(cap_at(4, 0), -6.0, 1e-5) << "40 mm/s for 0.15 s reaches 6 mm: 2 mm inside, slope 3";
    EXPECT_NEAR(cap_at(7, 0), 3.0, 1e-5) << "1 mm outside";
    clearing.update(2.0);
    EXPECT_NEAR(cap_at(7, 0), -3.0, 1e-5);
    EXPECT_NEAR(cap_at(13, 0), 15.0, 1e-5) << "the rim";
    EXPECT_EQ(cap_at(15, 0), 1000.0) << "beyond the rim";
    EXPECT_DOUBLE_EQ(time_at(7, 0), 2.0);
    clearing.update(50.0);
    EXPECT_DOUBLE_EQ(time_at(7, 0), 3.0) << "until the end of the contact";
    EXPECT_FALSE(clearing.update(60.0));
    EXPECT_TRUE(clearing.update(0.0)) << "back to before";
    EXPECT_EQ(cap_at(0, 0), 1000.0);
}

TEST_F(ClearingTest, AMovingTipClearsWhatItHasPassed) {
    clearing.set(
        std::vector<ToolContact>{
            {.action = ToolAction::suction, .time = 0.0, .duration = 4.0, .position = {-20, 0, 0}, .to = {20, 0, 0}}},
        reach(5, 15));
    clearing.update(2.0);  // the tip is at x = 0 then
    EXPECT_NEAR(cap_at(-10, 3), -6.0, 1e-5);
    EXPECT_NEAR(cap_at(3, 4), 0.0, 1e-5) << "5 mm off the tip";
    EXPECT_EQ(cap_at(12, 0), 1000.0);
    clearing.update(100.0);
    EXPECT_NEAR(cap_at(0, 3), -6.0, 1e-5);
    EXPECT_NEAR(cap_at(0, 7), 6.0, 1e-5);
    EXPECT_NEAR(time_at(0, 0), 2.0 + 1.1, 1e-9) << "10 mm/s: 5 mm and the rim of 6 mm on";
    EXPECT_NEAR(time_at(20, 0), 4.0, 1e-9);
}

TEST_F(ClearingTest, WaterRunsDownhill) {
    clearing.set(std::vector<ToolContact>{{.action = ToolAction::irrigation, .time = 0.0, .duration = 3.0}},
                 reach(8, 10));
    clearing.update(2.0);
    EXPECT_NEAR(cap_at(0, 14), -3.0, 1e-5) << "half as far again";
    EXPECT_NEAR(cap_at(9, 0), -3.0, 1e-5);
    EXPECT_NEAR(cap_at(0, -11), 3.0, 1e-5);
}

TEST_F(ClearingTest, OfSeveralOnlyThoseThatAreNotOverruledAreKept) {
    const auto suction = [](double time, double x) {
        return ToolContact{
            .action = ToolAction::suction, .time = time, .duration = 1.0, .position = {x, 0, 0}, .to = {x, 0, 0}};
    };
    clearing.set(std::vector{suction(0, 0), suction(4, 12), suction(2, 4)}, reach(8, 15));
    clearing.update(100.0);
    // At the origin: -24 at 1 s, -12 at 3 s, 12 at 5 s; the order of the list does not matter.
    const auto caps = caps_at(0, 0);
    ASSERT_EQ(caps.size(), 3u);
    const glm::dvec2 wanted[] = {{1, -24}, {3, -12}, {5, 12}};
    for (std::size_t n = 0; n < 3; ++n) {
        EXPECT_DOUBLE_EQ(caps[n].time, wanted[n].x);
        EXPECT_NEAR(caps[n].cap, wanted[n].y, 1e-5);
    }
    // At x = 12 the last cap is the lowest, so the others do not count.
    ASSERT_EQ(caps_at(12, 0).size(), 1u);
    EXPECT_DOUBLE_EQ(time_at(12, 0), 5.0);
}

TEST_F(ClearingTest, SteppingThroughShortContactsEqualsSeeking) {
    // Like contacts from samples of a moving tip: shorter than the time in which the reach grows.
    std::vector<ToolContact> contacts;
    for (int i = 0; i < 12; ++i)
        contacts.push_back({.action = ToolAction::suction,
                            .time = 0.1 * i,
                            .duration = 0.1,
                            .position = {2.0 * i - 12.0, 0, 0.5 * (i % 3)},
                            .to = {2.0 * i - 10.0, 0, 0.5 * ((i + 1) % 3)}});
    clearing.set(contacts, reach(8, 15));
    for (double time = 0.0; time < 3.0; time += 0.037) {
        clearing.update(time);
        test::Logged<Clearing> fresh(surface, down);
        fresh.set(contacts, reach(8, 15));
        fresh.update(time);
        for (std::uint32_t v = 0; v < surface.positions.size(); v += 3) {
            std::vector<std::pair<double, float>> stepped, direct;
            clearing.for_each(v, [&](const Clearing::Cap& c) { stepped.emplace_back(c.time, c.cap); });
            fresh.for_each(v, [&](const Clearing::Cap& c) { direct.emplace_back(c.time, c.cap); });
            ASSERT_EQ(stepped, direct) << time;
        }
    }
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
    EXPECT_NEAR(cap_at(20, 0), -12.0, 1e-5);
    contacts[1].position = contacts[1].to = {-20, 0, 0};
    EXPECT_TRUE(clearing.set(contacts, reach(4, 15)));
    clearing.update(9.0);
    EXPECT_EQ(cap_at(20, 0), 1000.0);
    EXPECT_NEAR(cap_at(-20, 0), -12.0, 1e-5);
    contacts.pop_back();
    clearing.set(contacts, reach(4, 15));
    clearing.update(9.0);
    EXPECT_EQ(cap_at(-20, 0), 1000.0);
    EXPECT_NEAR(cap_at(0, 0), -12.0, 1e-5);
}

}  // namespace
}  // namespace lapfx::bleeding
