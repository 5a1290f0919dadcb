// Samples of a haptic thread through the queue.
#include "lapfx/effects.h"

#include <gtest/gtest.h>

#include "support/gpu_test.h"
#include "support/meshes.h"

namespace lapfx::test {
namespace {

class ToolInputTest : public GpuTest {};

TEST_F(ToolInputTest, SamplesOfTheQueueCutAndBecomeContacts) {
    const Organ organ = plane(60.0, 40);
    Effects effects(organ, Preset{});
    effects.seek(1.0);
    EXPECT_EQ(effects.amounts().bleeding_wounds, 0);
    EXPECT_TRUE(effects.contacts().empty());
    for (int i = 0; i <= 200; ++i)
        ASSERT_TRUE(effects.tool_queue().push(
            {.time = 1.0 + 0.001 * i, .position = {0.05 * i, 0.0, 0.0}, .touching = true, .action = ToolAction::cut}));
    EXPECT_TRUE(effects.contacts().empty()) << "they wait for seek()";
    effects.seek(1.25);
    ASSERT_FALSE(effects.contacts().empty());
    EXPECT_EQ(effects.contacts().front().action, ToolAction::cut);
    EXPECT_NEAR(effects.contacts().front().time, 1.0, 1e-9);
    EXPECT_NEAR(effects.contacts().back().end(), 1.2, 1e-9);
    EXPECT_NEAR(effects.contacts().back().to.x, 10.0, 1e-9);
    EXPECT_EQ(effects.amounts().bleeding_wounds, 5) << "10 mm of cut, a wound each 2.5 mm";
    // Setting the log again gives the same.
    const std::vector<ToolContact> log(effects.contacts().begin(), effects.contacts().end());
    Effects replayed(organ, Preset{});
    replayed.set_contacts(log);
    for (const double time : {1.25, 3.0}) {
        effects.seek(time);
        replayed.seek(time);
        EXPECT_EQ(replayed.amounts().blood_area, effects.amounts().blood_area);
        EXPECT_GT(replayed.amounts().blood_area, 0.0);
    }
    effects.set_contacts({});
    effects.seek(3.0);
    EXPECT_EQ(effects.amounts().blood_area, 0.0);
    EXPECT_TRUE(effects.contacts().empty());
}

TEST_F(ToolInputTest, WithBioheatWoundsOpenWhileTimeGoesOn) {
    Preset preset;
    preset.cautery.model = HeatModel::bioheat;
    Effects effects(plane(40.0, 40), preset);
    effects.set_contacts(std::vector{ToolContact{.time = 1.0, .duration = 2.0}});
    effects.seek(1.5);
    EXPECT_EQ(effects.amounts().bleeding_wounds, 0);
    effects.seek(2.5);
    EXPECT_EQ(effects.amounts().bleeding_wounds, 1);
    EXPECT_GT(effects.amounts().blood_area, 0.0);
    effects.seek(1.0);
    EXPECT_EQ(effects.amounts().bleeding_wounds, 0);
}

}  // namespace
}  // namespace lapfx::test
