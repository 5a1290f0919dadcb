#include "match/scene/view_share.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lapfx::match {
namespace {

/// 100 mm in front of the origin, half the picture's height as far as the focal length: f = 0.5 heights.
SceneCamera right_angled() {
    SceneCamera camera;
    camera.eye = {0.0, 0.0, 100.0};
    camera.target = {0.0, 0.0, 0.0};
    camera.field_of_view = 90.0;
    camera.vignette = 0.0;
    return camera;
}

TEST(ViewShare, OfWhatIsSeenStraightIsItsAreaOverThatOfThePictureThere) {
    // At 100 mm the picture shows 200 mm by 300 mm.
    EXPECT_NEAR(share_per_mm2(right_angled(), 1.5, {0, 0, 0}, {0, 0, 1}), 1.0 / (200.0 * 300.0), 1e-12);
    EXPECT_NEAR(share_per_mm2(right_angled(), 1.5, {0, 0, 50}, {0, 0, 3}), 1.0 / (100.0 * 150.0), 1e-12);
}

TEST(ViewShare, OfAPlaneAcrossTheViewIsTheSameEverywhere) {
    const double middle = share_per_mm2(right_angled(), 1.5, {0, 0, 0}, {0, 0, 1});
    EXPECT_NEAR(share_per_mm2(right_angled(), 1.5, {120, -70, 0}, {0, 0, 1}), middle, 1e-15);
}

TEST(ViewShare, IsForeshortened) {
    const double straight = share_per_mm2(right_angled(), 1.0, {0, 0, 0}, {0, 0, 1});
    const glm::dvec3 tilted{std::sin(std::numbers::pi / 3.0), 0.0, std::cos(std::numbers::pi / 3.0)};
    EXPECT_NEAR(share_per_mm2(right_angled(), 1.0, {0, 0, 0}, tilted), 0.5 * straight, 1e-12);
}

TEST(ViewShare, IsNothingBehindTheCameraAndOfTheFarSide) {
    EXPECT_EQ(share_per_mm2(right_angled(), 1.0, {0, 0, 200}, {0, 0, -1}), 0.0);
    EXPECT_EQ(share_per_mm2(right_angled(), 1.0, {0, 0, 0}, {0, 0, -1}), 0.0);
}

TEST(ViewShare, TheRoundViewIsThatOfTheVignetteElseAllOfThePicture) {
    SceneCamera camera = right_angled();
    EXPECT_EQ(round_view_of(camera, 1.5), glm::dvec3(0.5, 0.5, std::hypot(0.75, 0.5)));
    camera.vignette = 0.49;
    EXPECT_EQ(round_view_of(camera, 1.5).z, std::hypot(0.75, 0.5));
    camera.vignette = 0.5;
    EXPECT_EQ(round_view_of(camera, 1.5), glm::dvec3(0.5, 0.5, 0.56));
    EXPECT_EQ(round_view_of(camera, 0.4).z, std::hypot(0.2, 0.5)) << "the rim is beyond the corners";
}

TEST(ViewShare, IsOfTheRoundViewWhereThereIsOne) {
    SceneCamera camera = right_angled();
    EXPECT_EQ(view_area(camera, 1.5), 1.5);
    camera.vignette = 1.0;
    // The disc without what the picture cuts off above and below, by summing rows.
    constexpr int rows = 100000;
    double area = 0.0;
    for (int i = 0; i < rows; ++i) {
        const double y = (i + 0.5) / rows - 0.5;
        area += 2.0 * std::sqrt(0.56 * 0.56 - y * y) / rows;
    }
    EXPECT_NEAR(view_area(camera, 1.5), area, 1e-6);
    EXPECT_NEAR(share_per_mm2(camera, 1.5, {0, 0, 0}, {0, 0, 1}), 0.25 / 1e4 / area, 1e-9);
    EXPECT_LT(view_area(camera, 0.8), 0.8) << "corners are beyond the rim";
    EXPECT_EQ(view_area(camera, 0.4), 0.4) << "the rim is beyond the corners";
}

}  // namespace
}  // namespace lapfx::match
