// The simulation with samples of a tool that has not let go.
#include "simulation.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace lapfx {
namespace {

class LiveTool : public testing::Test {
  protected:
    LiveTool() { simulation.set_parameters(Preset{}); }
    /// Samples up to now, as a host has them when it draws its frame.
    double emission_at(double now, double last_sample, bool touching = true) {
        for (; next <= last_sample + 1e-9; next += 0.001)
            queue.push({.time = next, .position = {1, 0, 2}, .touching = touching});
        simulation.take_samples(queue, moved);
        simulation.seek(now);
        return simulation.amounts().emission;
    }

    Simulation simulation{std::make_shared<const Foundation>(test::plane(40.0, 40), VesselParameters{}), {0, -1, 0}};
    MovedSurface moved{simulation.foundation().surface};
    ToolQueue queue;
    double next = 1.0;  // s
};

TEST_F(LiveTool, SmokesUntilItLetsGo) {
    EXPECT_EQ(emission_at(1.5, 1.5), 1.0) << "samples up to this very moment";
    EXPECT_EQ(emission_at(1.62, 1.6), 1.0) << "the next one is on its way";
    EXPECT_EQ(emission_at(1.699, 1.6), 1.0);
    EXPECT_EQ(emission_at(1.702, 1.6), 0.0) << "longer than samples of one contact may be apart";
    EXPECT_EQ(emission_at(1.64, 1.64), 1.0) << "it went on";
    EXPECT_EQ(emission_at(1.66, 1.66, false), 0.0) << "it let go";
    EXPECT_EQ(emission_at(1.5, 1.66), 1.0) << "what has been stays";
    EXPECT_EQ(emission_at(0.9, 1.66), 0.0);
}

TEST_F(LiveTool, ContactsThatWereSetEndWhereTheyEnd) {
    simulation.set_contacts(std::vector{ToolContact{.time = 1.0, .duration = 0.5}});
    simulation.seek(1.499);
    EXPECT_EQ(simulation.amounts().emission, 1.0);
    simulation.seek(1.5);
    EXPECT_EQ(simulation.amounts().emission, 0.0);
}

}  // namespace
}  // namespace lapfx
