// How long work still takes, told by its last steps.
#include "app/measure/remaining.h"

#include <gtest/gtest.h>

namespace lapfx::test {
namespace {

TEST(Remaining, ItIsToldByThePaceOfTheLastSteps) {
    app::Remaining remaining;
    remaining.reached(100, 0);
    EXPECT_LT(remaining.seconds(100), 0) << "nothing is known";
    for (int i = 1; i <= 10; ++i) remaining.reached(100 + 0.1 * i, 0.02 * i);  // what is quick at first
    EXPECT_LT(remaining.seconds(101), 0) << "too little to tell";
    for (int i = 1; i <= 30; ++i) remaining.reached(101 + i, 0.2 + 0.01 * i);
    EXPECT_NEAR(remaining.seconds(131), 50, 1e-6) << "a second for each hundredth, whatever the first ones took";
    remaining.reached(131, 0.4);
    EXPECT_NEAR(remaining.seconds(131), 50, 1e-6) << "it never goes back";
    EXPECT_NEAR(remaining.seconds(141), 75, 1e-6) << "and a long step counts before it ends";
    remaining.reached(142, 1.0);
    EXPECT_EQ(remaining.seconds(142), 0);
}

}  // namespace
}  // namespace lapfx::test
