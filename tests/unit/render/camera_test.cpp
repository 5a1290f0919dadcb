#include "render/camera.h"

#include <gtest/gtest.h>

#include <array>

#include "support/meshes.h"

namespace lapfx::render {
namespace {

glm::vec3 tip_of(const ToolContact& contact, double time, const Surface& surface) {
    const auto pose = tool_pose(std::array{contact}, {0, 100, 100}, time, surface);
    return pose ? glm::vec3((*pose)[3]) : glm::vec3(1e9F);
}

TEST(ToolPose, TheTipIsDrawnOnTheTissueThatItWorksOn) {
    const Surface surface(test::plane(40.0, 4));  // at y = 0
    ToolContact contact{
        .action = ToolAction::cauterise, .time = 1, .duration = 2, .position = {0, -3, 0}, .to = {10, 4, 0}};
    EXPECT_LT(glm::distance(tip_of(contact, 1, surface), {0, 0, 0}), 1e-4F) << "not in it";
    EXPECT_LT(glm::distance(tip_of(contact, 3, surface), {10, 0, 0}), 1e-4F) << "and not above it";
    contact.position.y = contact.to.y = 12;
    EXPECT_LT(glm::distance(tip_of(contact, 2, surface), {5, 12, 0}), 1e-4F) << "it touches nothing there";
    contact.position.y = contact.to.y = 4;
    contact.action = ToolAction::suction;
    EXPECT_LT(glm::distance(tip_of(contact, 2, surface), {5, 4, 0}), 1e-4F) << "suction need not touch";
    EXPECT_FALSE(tool_pose(std::array{contact}, {0, 100, 100}, 9, surface)) << "long after";
    contact.action = ToolAction::cut;
    EXPECT_LT(glm::distance(tip_of(contact, 2, Surface()), {5, 4, 0}), 1e-4F) << "no tissue at all";
}

TEST(ToolPose, TheEndOfTheInstrumentIsNotHiddenByTheTissueBesideIt) {
    const Surface surface(test::plane(40.0, 4));  // at y = 0
    const glm::dvec3 eye(0, 100, 0);
    const std::array<glm::vec3, 3> hook = {{{0, 0, 0}, {0, -3, 4}, {0, -50, 60}}};
    const glm::mat4 pose(1);
    const glm::mat4 moved = out_of_tissue(pose, tool_end(hook), eye, surface);
    EXPECT_NEAR(moved[3].y, 3, 0.05) << "what is 3 mm deep comes out";
    EXPECT_NEAR(moved[3].x, 0, 1e-5) << "towards the eye: the tip stays where it is seen";
    EXPECT_EQ(out_of_tissue(pose, std::array{glm::vec3(0, 5, 5)}, eye, surface), pose) << "nothing hides it";
    EXPECT_EQ(out_of_tissue(pose, std::array{glm::vec3(0, -9, 5)}, eye, surface), pose) << "it is behind the organ";
    EXPECT_EQ(out_of_tissue(pose, tool_end(hook), eye, Surface()), pose);
}

TEST(ToolPose, TheEndOfAnInstrumentIsAFewVerticesNearItsTip) {
    std::vector<glm::vec3> instrument;
    for (int i = 0; i < 200; ++i) instrument.emplace_back(0, 0, 0.1F * static_cast<float>(i));
    const std::vector<glm::vec3> end = tool_end(instrument);  // of the 120 or 121 within 12 mm every third
    ASSERT_GE(end.size(), 40U);
    ASSERT_LE(end.size(), 41U);
    EXPECT_EQ(end[0], instrument[0]);
    EXPECT_EQ(end[1], instrument[3]);
    EXPECT_EQ(end[39], instrument[117]);
    EXPECT_EQ(tool_end(std::span(instrument).first(47)).size(), 47U);
    EXPECT_LE(tool_end(std::span(instrument).first(95)).size(), 48U);
    EXPECT_TRUE(tool_end(std::span(instrument).last(20)).empty());
    EXPECT_TRUE(tool_end({}).empty());
}

}  // namespace
}  // namespace lapfx::render
