#include "cautery/char_cpu.h"

#include <gtest/gtest.h>

namespace lapfx::cautery {
namespace {

/// Vertices every half millimetre on the x axis, -10 to 30 mm.
std::vector<glm::vec3> row() {
    std::vector<glm::vec3> positions;
    for (int i = -20; i <= 60; ++i) positions.emplace_back(0.5f * static_cast<float>(i), 0.0f, 0.0f);
    return positions;
}

ToolContact at(double x, double time, double duration, ToolAction action = ToolAction::cauterise) {
    return {.action = action, .time = time, .duration = duration, .position = {x, 0, 0}, .to = {x, 0, 0}};
}

class CharTest : public testing::Test {
  protected:
    std::vector<glm::vec3> positions = row();
    CharField field{positions};
    CauteryParameters parameters;

    float at_x(double x) const { return field.values()[static_cast<std::size_t>(2.0 * x + 20.0)].x; }
};

TEST_F(CharTest, IsTheCharOfTheHottestThatEachVertexHasBeen) {
    const ToolContact contact = at(0, 1.0, 1.2);
    field.set(std::vector{contact}, parameters);
    ASSERT_TRUE(field.update(2.0));
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const double wanted = char_of(peak_temperature(contact, parameters, glm::dvec3(positions[v]), 2.0), parameters);
        EXPECT_NEAR(field.values()[v].x, wanted, 1e-6) << positions[v].x;
    }
    EXPECT_GT(at_x(0), 0.6f);
    EXPECT_EQ(at_x(12), 0.0f);
}

TEST_F(CharTest, WhatIsBeyondTheReachWouldNotShow) {
    const ToolContact contact = at(0, 0.0, 10.0);
    const double reach = heated_reach(contact, parameters);
    EXPECT_EQ(char_of(peak_temperature(contact, parameters, {reach, 0, 0}, 10.0), parameters), 0.0);
}

TEST_F(CharTest, OfTwoContactsTheHotterCounts) {
    const std::vector contacts{at(0, 0.0, 0.5), at(1, 5.0, 1.5)};
    field.set(contacts, parameters);
    field.update(20.0);
    const glm::dvec3 place(0.5, 0, 0);
    EXPECT_GT(peak_temperature(contacts[1], parameters, place, 20.0),
              peak_temperature(contacts[0], parameters, place, 20.0));
    EXPECT_NEAR(at_x(0.5), char_of(peak_temperature(contacts[1], parameters, place, 20.0), parameters), 1e-6);
}

TEST_F(CharTest, ColdActionsAndNoPowerLeaveTissueUnburnt) {
    ToolContact powerless = at(0, 0.0, 5.0);
    powerless.power = 0.0;
    field.set(std::vector{at(0, 0.0, 5.0, ToolAction::cut), at(0, 0.0, 5.0, ToolAction::tear), powerless}, parameters);
    field.update(9.0);
    for (const glm::vec2 value : field.values()) EXPECT_EQ(value, glm::vec2(0.0f));
}

TEST_F(CharTest, UpdateTellsWhetherAnythingChanged) {
    field.set(std::vector{at(0, 1.0, 1.0), at(5, 4.0, 1.0)}, parameters);
    field.update(0.0);
    EXPECT_FALSE(field.update(0.5)) << "before";
    EXPECT_TRUE(field.update(1.5));
    EXPECT_FALSE(field.update(1.5)) << "the same time";
    EXPECT_TRUE(field.update(3.0));
    EXPECT_FALSE(field.update(3.5)) << "between";
    EXPECT_TRUE(field.update(9.0)) << "over the whole second contact at one go";
    EXPECT_FALSE(field.update(10.0)) << "after";
    EXPECT_TRUE(field.update(0.0)) << "back before all";
    for (const glm::vec2 value : field.values()) EXPECT_EQ(value, glm::vec2(0.0f));
}

TEST_F(CharTest, AnyOrderOfTimesGivesTheSame) {
    const std::vector contacts{at(0, 1.0, 1.0),
                               {.time = 2.5, .duration = 4.0, .position = {2, 0, 0}, .to = {12, 0, 0}}};
    field.set(contacts, parameters);
    for (const double time : {8.0, 1.2, 5.0, 0.0, 3.1, 30.0, 1.9}) {
        field.update(time);
        CharField fresh(positions);
        fresh.set(contacts, parameters);
        fresh.update(time);
        for (std::size_t v = 0; v < positions.size(); ++v) ASSERT_EQ(field.values()[v], fresh.values()[v]) << time;
    }
}

TEST_F(CharTest, TakingContactsAwayTakesTheirCharAway) {
    field.set(std::vector{at(0, 0.0, 2.0)}, parameters);
    field.update(5.0);
    ASSERT_GT(at_x(0), 0.5f);
    field.set(std::vector<ToolContact>{}, parameters);
    EXPECT_TRUE(field.update(5.0));
    for (const glm::vec2 value : field.values()) EXPECT_EQ(value, glm::vec2(0.0f));
}

}  // namespace
}  // namespace lapfx::cautery
