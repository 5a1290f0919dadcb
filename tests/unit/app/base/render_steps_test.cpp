// Steps of drawing: a thread asks, and the render thread carries them out.
#include "app/base/render_steps.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

#include "support/wait_until.h"

namespace lapfx::app {
namespace {

using test::wait_until;

struct Asked {
    std::atomic<int> wakes = 0;
    RenderSteps steps{[this] { ++wakes; }};
};

TEST(RenderSteps, AreCarriedOutOnTheThreadThatServes) {
    Asked asked;
    std::thread::id carried_out_by;
    std::atomic<bool> ended = false;
    bool was = false;
    std::thread beside([&] {
        was = asked.steps.carry_out([&] { carried_out_by = std::this_thread::get_id(); });
        ended = true;
    });
    ASSERT_TRUE(wait_until([&] { return asked.wakes == 1; }));
    EXPECT_TRUE(asked.steps.waiting());
    EXPECT_FALSE(ended) << "whoever asks waits";
    asked.steps.serve(0);
    beside.join();
    EXPECT_TRUE(was);
    EXPECT_EQ(carried_out_by, std::this_thread::get_id());
    EXPECT_FALSE(asked.steps.waiting());
}

TEST(RenderSteps, WhatFollowsIsServedWithinTheBudget) {
    Asked asked;
    int steps = 0;
    std::thread beside([&] {
        for (int i = 0; i < 3; ++i)
            asked.steps.carry_out([&] {
                if (++steps == 3) asked.steps.stop();  // else it waits for what is asked for next
            });
    });
    ASSERT_TRUE(wait_until([&] { return asked.steps.waiting(); }));
    asked.steps.serve(100);
    EXPECT_EQ(steps, 3);
    beside.join();
}

TEST(RenderSteps, WithoutABudgetOneIsServed) {
    Asked asked;
    int steps = 0;
    std::thread beside([&] {
        while (asked.steps.carry_out([&] { ++steps; })) {
        }
    });
    ASSERT_TRUE(wait_until([&] { return asked.steps.waiting(); }));
    asked.steps.serve(0);
    EXPECT_EQ(steps, 1);
    asked.steps.stop();
    beside.join();
    EXPECT_EQ(steps, 1);
}

TEST(RenderSteps, WhatAStepThrowsIsThrownWhereItWasAskedFor) {
    Asked asked;
    std::string thrown;
    std::atomic<bool> after = false;
    std::thread beside([&] {
        try {
            asked.steps.carry_out([] { throw std::runtime_error("no context"); });
        } catch (const std::runtime_error& error) {
            thrown = error.what();
        }
        after = asked.steps.carry_out([] {});
    });
    EXPECT_TRUE(wait_until([&] { return after.load(); }, [&] { asked.steps.serve(0); }));
    beside.join();
    EXPECT_EQ(thrown, "no context");
}

TEST(RenderSteps, StoppedTheyAreNotCarriedOut) {
    Asked asked;
    bool was = true, later = true, touched = false;
    std::thread beside([&] {
        was = asked.steps.carry_out([&] { touched = true; });
        later = asked.steps.carry_out([&] { touched = true; });
    });
    ASSERT_TRUE(wait_until([&] { return asked.steps.waiting(); }));
    asked.steps.stop();
    beside.join();
    asked.steps.serve(0);
    EXPECT_FALSE(was);
    EXPECT_FALSE(later);
    EXPECT_FALSE(touched);
}

}  // namespace
}  // namespace lapfx::app
