// The amounts of smoke: only burning tissue makes smoke, and only a preset with clips shows it.
#include "lapfx/amounts.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/meshes.h"

namespace lapfx {
namespace {

double haze_of(const glm::dvec3& from, const glm::dvec3& to, bool clips = true) {
    Preset preset;
    preset.smoke.haze.ventilation = 0.0;
    if (clips) preset.smoke.clips = {{.file = "not_opened_for_amounts.mp4"}};
    const ToolContact burn{.duration = 10.0, .position = from, .to = to};
    AmountsModel model(test::plane(100.0, 50));
    model.set(preset, {&burn, 1});
    return model.at(10.0).haze;
}

TEST(SmokeAmounts, ABurnAwayFromTissueMakesNoHaze) {
    const double full = haze_of({1, 0, 2}, {1, 0, 2});
    EXPECT_GT(full, 0.5);
    EXPECT_EQ(haze_of({1, 4.9, 2}, {1, 4.9, 2}), full) << "as near as the tip touches";
    EXPECT_EQ(haze_of({1, 5.1, 2}, {1, 5.1, 2}), 0.0);
    EXPECT_EQ(haze_of({1, 45, 2}, {1, 45, 2}), 0.0);
}

TEST(SmokeAmounts, ATipThatLeavesTheTissueSmokesUpToThere) {
    const double full = haze_of({0, 0, 0}, {0, 0, 0});
    EXPECT_NEAR(haze_of({0, 0, 0}, {0, 20, 0}), 0.25 * full, 1e-3 * full);
}

TEST(SmokeAmounts, APresetWithoutClipsHasNone) {
    EXPECT_EQ(haze_of({1, 0, 2}, {1, 0, 2}, false), 0.0);
}

TEST(SmokeAmounts, AreTheSameWithoutSeekingTheTime) {
    Preset preset;
    preset.smoke.clips = {{.file = "not_opened_for_amounts.mp4"}};
    const ToolContact burn{.time = 1.0, .duration = 3.0, .power = 0.5};
    AmountsModel model(test::plane(100.0, 50)), sought(test::plane(100.0, 50));
    Curves curves;
    curves.emission = {{0.0, 1.0}, {6.0, 2.0}};
    model.set(preset, {&burn, 1}, curves);
    sought.set(preset, {&burn, 1}, curves);
    for (const double time : {7.0, 3.5, 0.5, 2.0}) {
        EXPECT_EQ(model.smoke_at(time).haze, sought.at(time).haze) << time;
        EXPECT_EQ(model.smoke_at(time).emission, sought.at(time).emission) << time;
    }
    EXPECT_NEAR(model.smoke_at(2.5).emission, 0.5 * (1.0 + 2.5 / 6.0), 1e-12);
    EXPECT_EQ(model.smoke_at(std::numeric_limits<double>::quiet_NaN()).haze, 0.0);
}

}  // namespace
}  // namespace lapfx
