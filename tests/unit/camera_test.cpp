#include "lapfx/camera.h"

#include <gtest/gtest.h>

#include "lapfx/scene.h"

namespace lapfx {
namespace {

const CameraResponse film{.curve = ResponseCurve::film}, shoulder{};

TEST(Camera, FilmIsTheCurveOfItsFormula) {
    // toe(x) = x x (1 + t) / (x + t); above the knee k the shoulder, which reaches 1 at toe(x) = w.
    EXPECT_DOUBLE_EQ(shown_light(0.0, film), 0.0);
    EXPECT_NEAR(shown_light(0.1, film), 0.01 * 1.2 / 0.3, 1e-12);
    EXPECT_NEAR(shown_light(0.5, film), 0.25 * 1.2 / 0.7, 1e-12);
    EXPECT_NEAR(shown_light(1.0, film), 0.6 + 0.4 * (1.0 + 1.0 / 36.0) / 2.0, 1e-12) << "toe(1) = 1: u = 1, end = 6";
    const double at_white = light_shown_as(1.0, film);
    EXPECT_NEAR(at_white * at_white * 1.2 / (at_white + 0.2), 3.0, 1e-9);
    EXPECT_DOUBLE_EQ(shown_light(100.0, film), 1.0);
    EXPECT_DOUBLE_EQ(shown_light(-1.0, film), 0.0);
}

TEST(Camera, TheShoulderIsAsItWas) {
    EXPECT_DOUBLE_EQ(shown_light(0.7, shoulder), 0.7);
    EXPECT_DOUBLE_EQ(shown_light(1.0, shoulder), 0.85);
    EXPECT_LT(shown_light(1e4, shoulder), 1.0);
}

TEST(Camera, LightComesBackFromWhatIsShown) {
    const CameraResponse others[] = {film,
                                     shoulder,
                                     {.curve = ResponseCurve::film, .toe = 0.0},
                                     {.curve = ResponseCurve::film, .toe = 1.0, .knee = 0.1, .white = 1.05},
                                     {.curve = ResponseCurve::film, .knee = 0.95, .white = 20.0}};
    for (const CameraResponse& response : others)
        for (double light = 0.0; light < 4.0; light += 0.03) {
            const double shown = shown_light(light, response);
            if (shown >= 1.0) break;
            EXPECT_NEAR(light_shown_as(shown, response), light, 1e-6) << light;
        }
}

TEST(Camera, ASceneHasTheSameResponseWhereItSaysNothing) {
    EXPECT_EQ(SceneCamera{}.response(), CameraResponse{});
    SceneCamera camera;
    const CameraResponse other{.exposure = 2,
                               .vignette = 0.5,
                               .white_balance = {1, 2, 3},
                               .sharpening = 0.1,
                               .saturation = 0.2,
                               .lens_falloff = 0.3,
                               .curve = ResponseCurve::film,
                               .toe = 0.4,
                               .knee = 0.5,
                               .white = 6};
    camera.set_response(other);
    EXPECT_EQ(camera.response(), other);
}

}  // namespace
}  // namespace lapfx
