// Which part of a contact makes smoke: the one over tissue.
#include "smoke/touching.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace lapfx::smoke {
namespace {

/// Tissue lies where |x| <= 10.
bool tissue(const glm::dvec3& place) {
    return std::abs(place.x) <= 10.0;
}

ToolContact burn(double from, double to, double time = 1.0, double duration = 4.0) {
    return {.time = time, .duration = duration, .position = {from, 0, 0}, .to = {to, 0, 0}};
}

std::vector<ToolContact> parts_of(const std::vector<ToolContact>& contacts) {
    Touching touching;
    const auto parts = touching.update(contacts, tissue);
    return {parts.begin(), parts.end()};
}

TEST(Touching, WhatTouchesAllAlongIsPassedOnAsItIs) {
    const std::vector<ToolContact> contacts{burn(-5, 5), burn(3, 3)};
    EXPECT_EQ(parts_of(contacts), contacts);
}

TEST(Touching, HeatInTheAirMakesNone) {
    EXPECT_TRUE(parts_of({burn(45, 45), burn(20, 90)}).empty());
}

TEST(Touching, SuctionAndCutsNeedNotTouch) {
    ToolContact suction = burn(45, 45);
    suction.action = ToolAction::suction;
    EXPECT_EQ(parts_of({suction}), std::vector<ToolContact>{suction});
}

TEST(Touching, APathThatLeavesTheTissueEndsThere) {
    const std::vector<ToolContact> parts = parts_of({burn(0, 40)});
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0].time, 1.0);
    EXPECT_NEAR(parts[0].duration, 1.0, 1e-3) << "a quarter of the way";
    EXPECT_NEAR(parts[0].to.x, 10.0, 1e-2);
    EXPECT_LE(parts[0].to.x, 10.0);
}

TEST(Touching, APathOverTheTissueBeginsAndEndsOnIt) {
    const std::vector<ToolContact> parts = parts_of({burn(-40, 40, 0.0, 8.0)});
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_NEAR(parts[0].time, 3.0, 1e-3);
    EXPECT_NEAR(parts[0].end(), 5.0, 1e-3);
    EXPECT_NEAR(parts[0].position.x, -10.0, 1e-2);
    EXPECT_NEAR(parts[0].tip(4.0).x, 0.0, 1e-2) << "where the tip was then";
}

TEST(Touching, AGapMakesTwo) {
    Touching touching;
    const std::vector<ToolContact> contacts{burn(-20, 20, 0.0, 4.0)};
    const auto parts = touching.update(contacts, [](const glm::dvec3& p) { return std::abs(p.x) >= 5.0; });
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_NEAR(parts[0].end(), 1.5, 1e-3);
    EXPECT_NEAR(parts[1].time, 2.5, 1e-3);
    EXPECT_EQ(parts[1].end(), 4.0);
}

TEST(Touching, WhatCannotBeMakesNone) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(parts_of({burn(nan, 0), burn(0, nan), burn(0, 0, nan), burn(0, 5000)}).empty());
}

TEST(Touching, OnlyWhatHasChangedIsLookedAtAgain) {
    Touching touching;
    int asked = 0;
    const auto counted = [&](const glm::dvec3& place) {
        ++asked;
        return tissue(place);
    };
    std::vector<ToolContact> contacts{burn(0, 5), burn(5, 15, 5.0)};
    const auto whole = [&] {
        const auto parts = touching.update(contacts, counted);
        return std::vector<ToolContact>(parts.begin(), parts.end());
    };
    EXPECT_EQ(whole(), parts_of(contacts));
    const int first = asked;
    EXPECT_EQ(whole(), parts_of(contacts));
    EXPECT_EQ(asked, first);
    contacts.back().to.x = 16.0;
    contacts.push_back(burn(0, 0, 9.0));
    EXPECT_EQ(whole(), parts_of(contacts));
    EXPECT_LT(asked, 3 * first);
    contacts.erase(contacts.begin());
    EXPECT_EQ(whole(), parts_of(contacts));
    touching.clear();
    EXPECT_EQ(whole(), parts_of(contacts));
}

}  // namespace
}  // namespace lapfx::smoke
