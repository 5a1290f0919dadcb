// Places that a camera sees.
#include "match/scene/seen_places.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace lapfx::match {
namespace {

SceneCamera above(double height) {
    return {.eye = {0.0, height, 0.0}, .target = {0.0, 0.0, 0.0}, .up = {0.0, 0.0, -1.0}};
}

TEST(SeenPlaces, BeginInTheMiddleAndAreApart) {
    const auto places = seen_places(test::plane(80.0, 60), above(100.0), 1.25, 15.0);
    ASSERT_GE(places.size(), 5U);
    EXPECT_LT(glm::length(places[0].position), 5.0);
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_GT(places[i].normal.y, 0.99);
        for (std::size_t k = 0; k < i; ++k) EXPECT_GE(glm::distance(places[i].position, places[k].position), 15.0);
    }
    EXPECT_EQ(seen_places(test::plane(80.0, 60), above(100.0), 1.25, 15.0, {}, 2).size(), 2U);
}

TEST(SeenPlaces, KeepAwayFromOnesThatAreTaken) {
    const std::vector<glm::dvec3> taken = {{0.0, 0.0, 0.0}};
    for (const SeenPlace& place : seen_places(test::plane(80.0, 60), above(100.0), 1.25, 20.0, taken))
        EXPECT_GE(glm::length(place.position), 20.0);
}

TEST(SeenPlaces, AreOnTheSideOfTheCamera) {
    const auto places = seen_places(test::sphere(20.0, 4), above(90.0), 1.0, 5.0);
    ASSERT_FALSE(places.empty());
    for (const SeenPlace& place : places) EXPECT_GT(place.position.y, 0.0) << "the far side is hidden";
}

TEST(SeenPlaces, AreNoneWhereTheOrganIsNotSeen) {
    SceneCamera away = above(100.0);
    away.target = {0.0, 200.0, 0.0};
    EXPECT_TRUE(seen_places(test::plane(80.0, 60), away, 1.25, 15.0).empty());
    EXPECT_TRUE(seen_places(test::plane(80.0, 60), above(-100.0), 1.25, 15.0).empty()) << "it faces the other way";
}

TEST(SeenPlaces, TellTheShareOfBlood) {
    Scene scene;
    scene.camera = above(100.0);
    scene.camera.vignette = 0.0;
    const double straight = 1.0 / (1.25 * 115.47 * 115.47);  // the view is 2 * 100 tan 30 deg high
    EXPECT_NEAR(*seen_share_per_mm2(test::plane(80.0, 60), scene, 1.25), straight, 0.02 * straight);
    scene.events = {{.action = ToolAction::cut, .position = {0.0, 50.0, 0.0}}};  // twice as near
    EXPECT_NEAR(*seen_share_per_mm2(test::plane(80.0, 60), scene, 1.25), 4.0 * straight, 0.02 * straight);
    scene.camera.target = {0.0, 200.0, 0.0};
    EXPECT_FALSE(seen_share_per_mm2(test::plane(80.0, 60), scene, 1.25));
}

}  // namespace
}  // namespace lapfx::match
