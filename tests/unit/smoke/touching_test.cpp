// Only the part of a contact over tissue makes smoke.
#include "smoke/touching.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/contacts.h"

namespace lapfx::smoke {
namespace {

/// Tissue is where |x| <= 10.
bool tissue(const glm::dvec3& place) {
    return std::abs(place.x) <= 10.0;
}

ToolContact burn(double from, double to, double time = 1.0, double duration = 4.0) {
    return test::contact(ToolAction::cauterise, time, duration, {from, 0, 0}, {to, 0, 0});
}

std::vector<ToolContact> parts_of(const std::vector<ToolContact>& contacts) {
    std::vector<ToolContact> parts;
    for (const ToolContact& contact : contacts) touching_parts(contact, tissue, parts);
    return parts;
}

TEST(Touching, WhatTouchesAllAlongIsPassedOnAsItIs) {
    const std::vector<ToolContact> contacts{burn(-5, 5), burn(3, 3)};
    EXPECT_EQ(parts_of(contacts), contacts);
}

TEST(Touching, HeatInTheAirMakesNone) {
    EXPECT_TRUE(parts_of({burn(45, 45), burn(20, 90)}).empty());
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
    std::vector<ToolContact> parts;
    touching_parts(
        burn(-20, 20, 0.0, 4.0), [](const glm::dvec3& p) { return std::abs(p.x) >= 5.0; }, parts);
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_NEAR(parts[0].end(), 1.5, 1e-3);
    EXPECT_NEAR(parts[1].time, 2.5, 1e-3);
    EXPECT_EQ(parts[1].end(), 4.0);
}

}  // namespace
}  // namespace lapfx::smoke
