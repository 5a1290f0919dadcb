#include "app/preview/orbit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "lapfx/authoring/organ_report.h"
#include "render/camera.h"

namespace lapfx::app {
namespace {

SceneCamera camera() {
    SceneCamera c;
    c.eye = {30.0, 40.0, 120.0};
    c.target = {5.0, -3.0, 2.0};
    c.up = {0.1, 1.0, 0.0};
    return c;
}

double distance(const SceneCamera& c) {
    return glm::distance(c.eye, c.target);
}

/// Angle between the view and the pole, rad.
double from_pole(const SceneCamera& c) {
    return std::acos(glm::dot(glm::normalize(c.eye - c.target), glm::normalize(c.up)));
}

glm::dvec3 right_of(const SceneCamera& c) {
    return glm::normalize(glm::cross(c.target - c.eye, c.up));
}

/// Where a point is seen, pixels from the top left of a frame.
glm::dvec2 pixel(const SceneCamera& c, glm::dvec3 point, glm::ivec2 size) {
    const View view = render::view_of(c, {}, size);
    const glm::vec4 clip = view.projection * (view.view * glm::vec4(glm::vec3(point), 1.0f));
    return {(clip.x / clip.w + 1.0) / 2.0 * size.x, (1.0 - clip.y / clip.w) / 2.0 * size.y};
}

TEST(Orbit, KeepsTheDistanceAndTheTarget) {
    SceneCamera c = camera();
    const double before = distance(c);
    orbit(c, 0.7, -0.3);
    EXPECT_NEAR(distance(c), before, 1e-9);
    EXPECT_EQ(c.target, camera().target);
    EXPECT_EQ(c.up, camera().up);
}

TEST(Orbit, TurnsByTheAnglesGiven) {
    SceneCamera c = camera();
    const double height = from_pole(c);
    orbit(c, 0.0, 0.25);
    EXPECT_NEAR(from_pole(c), height - 0.25, 1e-9) << "up is towards the pole";
    c = camera();
    const glm::dvec3 before = right_of(c);
    orbit(c, 0.4, 0.0);
    EXPECT_NEAR(from_pole(c), height, 1e-9);
    EXPECT_NEAR(std::acos(glm::dot(right_of(c), before)), 0.4, 1e-9);
}

TEST(Orbit, ThereAndBackIsWhereItWas) {
    SceneCamera c = camera();
    orbit(c, 0.9, 0.2);
    orbit(c, 0.0, -0.2);
    orbit(c, -0.9, 0.0);
    EXPECT_NEAR(glm::distance(c.eye, camera().eye), 0.0, 1e-9);
}

TEST(Orbit, NeverFlipsOverAPole) {
    for (const double step : {0.3, -0.3, 5.0, -5.0}) {
        SceneCamera c = camera();
        const glm::dvec3 right = right_of(c);
        for (int i = 0; i < 40; ++i) {
            orbit(c, 0.0, step);
            ASSERT_NEAR(glm::distance(right_of(c), right), 0.0, 1e-6) << step << " after " << i;
            ASSERT_GT(from_pole(c), 0.019);
            ASSERT_LT(from_pole(c), std::numbers::pi - 0.019);
        }
    }
}

TEST(Orbit, AnyDragKeepsTheDistance) {
    SceneCamera c = camera();
    const double before = distance(c);
    std::mt19937 random(1);
    const auto angle = [&] { return static_cast<double>(random() % 2001) / 500.0 - 2.0; };
    for (int i = 0; i < 1000; ++i) {
        orbit(c, angle(), angle());
        ASSERT_NEAR(distance(c), before, 1e-6) << i;
    }
}

TEST(Pan, KeepsDistanceAndDirection) {
    SceneCamera c = camera();
    pan(c, {37.0, -12.0}, 600.0);
    EXPECT_NEAR(glm::distance(c.eye - c.target, camera().eye - camera().target), 0.0, 1e-9);
}

TEST(Pan, TheTargetFollowsThePointer) {
    const glm::ivec2 size(800, 600);
    const glm::dvec3 point = camera().target;
    for (const glm::dvec2 drag : {glm::dvec2(40.0, 0.0), glm::dvec2(0.0, 25.0), glm::dvec2(-60.0, 35.0)}) {
        SceneCamera c = camera();
        const glm::dvec2 before = pixel(c, point, size);
        pan(c, drag, size.y);
        EXPECT_NEAR(glm::distance(pixel(c, point, size) - before, drag), 0.0, 0.01);
    }
}

TEST(Pan, AFrameWithoutHeightIsNoDivisionByZero) {
    SceneCamera c = camera();
    pan(c, {1.0, 1.0}, 0.0);
    EXPECT_TRUE(std::isfinite(c.eye.x));
}

TEST(Zoom, ScalesTheDistanceWithinItsLimits) {
    SceneCamera c = camera();
    const double before = distance(c);
    const glm::dvec3 direction = glm::normalize(c.eye - c.target);
    zoom(c, 0.5);
    EXPECT_NEAR(distance(c), before / 2.0, 1e-9);
    EXPECT_EQ(c.target, camera().target);
    zoom(c, 1e-6);
    EXPECT_NEAR(distance(c), 5.0, 1e-9);
    zoom(c, 1e9);
    EXPECT_NEAR(distance(c), 2000.0, 1e-9);
    EXPECT_NEAR(glm::distance(glm::normalize(c.eye - c.target), direction), 0.0, 1e-9);
}

TEST(Frame, SeesTheWholeOrganFromTheFront) {
    OrganReport organ;
    organ.minimum = {-20.0, 10.0, -70.0};
    organ.maximum = {60.0, 40.0, 15.0};
    const SceneCamera c = frame(organ);
    EXPECT_EQ(c.target, glm::dvec3(20.0, 25.0, -27.5));
    EXPECT_GT(c.eye.z, 15.0);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) != 0 ? 60.0 : -20.0, (corner & 2) != 0 ? 40.0 : 10.0,
                           (corner & 4) != 0 ? 15.0 : -70.0);
        const glm::dvec2 at = pixel(c, p, {100, 100});
        EXPECT_TRUE(at.x >= 0.0 && at.x <= 100.0 && at.y >= 0.0 && at.y <= 100.0) << at.x << ' ' << at.y;
    }
}

TEST(Frame, AnOrganOfNoSizeIsSeenFromADistance) {
    OrganReport organ;
    organ.minimum = organ.maximum = {1.0, 2.0, 3.0};
    const SceneCamera c = frame(organ);
    EXPECT_GE(distance(c), 1.0);
    EXPECT_LE(distance(c), 2000.0);
}

TEST(Orbit, ZoomKeepsThePlaceUnderThePointer) {
    SceneCamera c = camera();
    const glm::dvec3 place(12.0, 8.0, 20.0);
    const glm::dvec2 before = pixel(c, place, {800, 600});
    const double far = glm::distance(c.eye, place);
    zoom_at(c, 0.5, place);
    EXPECT_NEAR(glm::distance(pixel(c, place, {800, 600}), before), 0.0, 1e-2);
    EXPECT_NEAR(glm::distance(c.eye, place), far / 2, 1e-9);
    for (int i = 0; i < 50; ++i) zoom_at(c, 0.5, place);
    EXPECT_NEAR(distance(c), 5.0, 1e-9) << "never nearer";
}

TEST(Orbit, CenteringTurnsNothing) {
    SceneCamera c = camera();
    const SceneCamera before = c;
    center_on(c, {1.0, 2.0, 3.0});
    EXPECT_EQ(c.target, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_NEAR(glm::distance(c.target - c.eye, before.target - before.eye), 0.0, 1e-12);
}

}  // namespace
}  // namespace lapfx::app
