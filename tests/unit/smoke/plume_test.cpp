#include "smoke/plume_cpu.h"

#include <gtest/gtest.h>

namespace lapfx::smoke {
namespace {

constexpr glm::dvec3 up{0.0, 1.0, 0.0};

PlumeParameters parameters() {
    PlumeParameters p;
    p.size = 40.0;
    p.density = 2.0;
    p.rise = 6.0;
    p.growth = 0.25;
    p.fade_in = 0.4;
    p.fade_out = 2.0;
    return p;
}

/// From (0, 0, 0) to (10, 0, 0) between 1 s and 3 s, half power.
ToolContact contact(ToolAction action = ToolAction::cauterise) {
    return {.action = action, .time = 1.0, .duration = 2.0, .position = {0, 0, 0}, .to = {10, 0, 0}, .power = 0.5};
}

double density(double time, const PlumeParameters& p = parameters()) {
    return plume_state(contact(), p, up, time).density;
}

TEST(Plume, FadesInBurnsAndFadesOut) {
    EXPECT_EQ(density(0.99), 0.0);
    EXPECT_EQ(density(1.0), 0.0);
    EXPECT_NEAR(density(1.1), 2.0 * 0.5 * 0.15625, 1e-12) << "smoothstep of a quarter";
    EXPECT_NEAR(density(1.2), 0.5, 1e-12);
    EXPECT_NEAR(density(2.0), 1.0, 1e-12);
    EXPECT_NEAR(density(3.0), 1.0, 1e-12);
    EXPECT_NEAR(density(4.0), 0.5, 1e-12);
    EXPECT_NEAR(density(5.0), 0.0, 1e-12);
    EXPECT_EQ(density(5.01), 0.0);
}

TEST(Plume, WithoutFadesItIsThereExactlyWhileTheToolBurns) {
    PlumeParameters p = parameters();
    p.fade_in = p.fade_out = 0.0;
    EXPECT_EQ(density(0.999, p), 0.0);
    EXPECT_EQ(density(1.0, p), 1.0);
    EXPECT_EQ(density(2.999, p), 1.0);
    EXPECT_EQ(density(3.001, p), 0.0);
}

TEST(Plume, ColdToolsDoNotSmoke) {
    for (const double time : {1.5, 2.5, 3.5}) {
        EXPECT_EQ(plume_state(contact(ToolAction::cut), parameters(), up, time).density, 0.0);
        EXPECT_EQ(plume_state(contact(ToolAction::tear), parameters(), up, time).density, 0.0);
        EXPECT_GT(plume_state(contact(ToolAction::coagulate), parameters(), up, time).density, 0.0);
    }
}

TEST(Plume, StandsOnTheTipAndRisesWhenItStops) {
    const auto anchor = [](double time) { return plume_state(contact(), parameters(), up, time).anchor; };
    EXPECT_EQ(anchor(2.0), glm::dvec3(5, 0, 0));
    EXPECT_EQ(anchor(3.0), glm::dvec3(10, 0, 0));
    EXPECT_EQ(anchor(3.5), glm::dvec3(10, 3, 0));
    const glm::dvec3 aside(0.0, 0.0, -1.0);
    EXPECT_EQ(plume_state(contact(), parameters(), aside, 4.0).anchor, glm::dvec3(10, 0, -6));
}

TEST(Plume, IsSmallWhenYoungAndGrowsWhenTheToolStops) {
    const auto height = [](double time) { return plume_state(contact(), parameters(), up, time).height; };
    EXPECT_NEAR(height(1.0), 24.0, 1e-9);
    EXPECT_NEAR(height(1.4), 32.0, 1e-9);
    EXPECT_NEAR(height(1.8), 40.0, 1e-9);
    EXPECT_NEAR(height(3.0), 40.0, 1e-9);
    EXPECT_NEAR(height(4.0), 50.0, 1e-9);
    EXPECT_NEAR(height(5.0), 60.0, 1e-9);
}

TEST(Plume, FatSmokesMore) {
    PlumeParameters p = parameters();
    p.fat_gain = 1.5;
    EXPECT_NEAR(plume_state(contact(), p, up, 2.0, 0.4).density, 1.6 * plume_state(contact(), p, up, 2.0).density,
                1e-12);
    EXPECT_NEAR(emission(contact(), 1.0, p), 0.5 * 2.5, 1e-12);
    p.fat_gain = 0.0;
    EXPECT_EQ(plume_state(contact(), p, up, 2.0, 0.4).density, plume_state(contact(), p, up, 2.0).density);
}

}  // namespace
}  // namespace lapfx::smoke
