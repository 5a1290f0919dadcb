// What is made of the parts of a fit; that its curves come near is tested with the parts (match/fit/fit_test.cpp).
#include "match/use/fit_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "lapfx/prepared_organ.h"
#include "support/meshes.h"

namespace lapfx::match {
namespace {

constexpr double aspect = 1.25;

/// A burn on a plane, held against smoke that rises from 2 s on, half a second later in the video.
SceneFit usual() {
    SceneFit fit{.organ = prepare_organ(test::plane(90.0, 20)),
                 .keys = {"smoke.haze.accumulation"},
                 .offset = 0.5,
                 .to = 6.0,
                 .aspect = aspect,
                 .seed = 5};
    fit.start.preset.smoke.clips = {{.file = "smoke.mkv"}};
    fit.start.scene.organ.file = "plane.obj";
    fit.start.scene.duration = 6.0;
    fit.start.scene.camera = {.eye = {0.0, 60.0, 0.0}, .target = {0.0, 0.0, 0.0}, .up = {0.0, 0.0, -1.0}};
    fit.start.scene.events = {
        {.action = ToolAction::cauterise, .time = 0.0, .duration = 1.0, .position = {0, 0, 0}, .to = {0, 0, 4}}};
    for (int i = 0; i <= 32; ++i) {
        const double time = 0.2 * i, veil = 0.1 * std::clamp(time - 2.5, 0.0, 3.0);
        fit.reference.push_back({.time = time, .blood = {0.0, 0.0, 0.002}, .veil = {veil, veil - 0.02, veil + 0.02}});
    }
    return fit;
}

/// Whose pictures are refused: no context is needed.
PreviewCurve refused() {
    return {usual().organ, {}, {}, [](const std::function<void()>&) { return false; }};
}

TEST(ProposeScene, MovesTheToolsToTheReference) {
    const SceneFit fit = usual();
    const FittedScene found = propose_scene(fit);
    EXPECT_NEAR(found.tuned.scene.events[0].time, 2.0, 0.3);
    EXPECT_EQ(found.fit.start.scene.events[0].time, 0.0) << "what it began with stays known";
    EXPECT_EQ(found.fit.offset, 0.5);
    EXPECT_EQ(found.fit.to, 6.0);
    EXPECT_EQ(found.fit.seed, 5U);
    EXPECT_EQ(found.fit.organ, fit.organ);
    EXPECT_THAT(found.lines, testing::Contains(testing::HasSubstr("smoke: from")));
    ASSERT_EQ(found.parameters.size(), 1U) << "those of the tools are not listed";
    EXPECT_EQ(found.parameters[0].key, "smoke.haze.accumulation");
    EXPECT_NEAR(found.target.front().time, 0.0, 0.11) << "of the scene, which the offset is taken from";
    EXPECT_FALSE(found.result);
}

TEST(ProposeScene, ToolsThatHaveToStayDo) {
    SceneFit fit = usual();
    fit.tools = false;
    const FittedScene found = propose_scene(fit);
    EXPECT_EQ(found.tuned.scene.events, fit.start.scene.events);
    EXPECT_NE(found.tuned.preset.smoke.haze.accumulation, fit.start.preset.smoke.haze.accumulation);
    EXPECT_THAT(found.lines, testing::Contains("tools: stay as they are"));
}

TEST(FitScene, EndsWithoutCurvesWhereNoPictureIsDrawn) {
    for (const ColorsOfFit colors : {ColorsOfFit::leave, ColorsOfFit::compare, ColorsOfFit::match}) {
        SceneFit fit = usual();
        fit.colors = colors;
        PreviewCurve curve = refused();
        int best = 0;
        const FittedScene found = fit_scene(fit, curve, {.best = [&best](const auto&) { ++best; }});
        ASSERT_TRUE(found.result);
        EXPECT_TRUE(found.result->after.empty());
        EXPECT_TRUE(found.result->ended_early);
        EXPECT_EQ(best, 0);
        EXPECT_THAT(found.colors, testing::IsEmpty());
        EXPECT_THAT(found.lines, testing::Contains(testing::HasSubstr("smoke: from")));
    }
}

TEST(FitScene, ToolsThatHaveToStayAreNoNews) {
    SceneFit fit = usual();
    fit.tools = false;
    PreviewCurve curve = refused();
    EXPECT_THAT(fit_scene(fit, curve).lines, testing::IsEmpty());
}

}  // namespace
}  // namespace lapfx::match
