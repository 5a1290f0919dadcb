// When something is to be done about changes.
#include "app/base/settling.h"

#include <gtest/gtest.h>

namespace lapfx::app {
namespace {

TEST(Settling, IsDueOnceChangesHaveRested) {
    Settling settling(0.5);
    EXPECT_EQ(settling.due(), Settling::never);
    EXPECT_FALSE(settling.due_at(1e9)) << "nothing has changed";
    settling.change(10);
    EXPECT_EQ(settling.due(), 10.5);
    EXPECT_FALSE(settling.due_at(10.25));
    settling.change(10.25);
    EXPECT_FALSE(settling.due_at(10.5)) << "it has changed again";
    EXPECT_TRUE(settling.due_at(10.75));
    EXPECT_TRUE(settling.due_at(11)) << "until it is done";
    settling.clear();
    EXPECT_FALSE(settling.due_at(11));
}

TEST(Settling, ChangesThatGoOnDeferItNoLongerThanTheLimit) {
    Settling settling(2, 5);
    for (double now = 0; now < 5; now += 1) {
        settling.change(now);
        EXPECT_EQ(settling.due(), std::min(now + 2, 5.0));
    }
    EXPECT_TRUE(settling.due_at(5));
    settling.clear();
    settling.change(20);
    EXPECT_EQ(settling.due(), 22) << "the limit counts from the first change since";
    settling.change(24.5);
    EXPECT_EQ(settling.due(), 25);
}

TEST(Settling, WhatIsSetIsNotDeferred) {
    Settling settling(2, 5);
    settling.set(3);
    settling.change(2.5);
    EXPECT_EQ(settling.due(), 3);
    settling.set(9);
    EXPECT_EQ(settling.due(), 9);
}

}  // namespace
}  // namespace lapfx::app
