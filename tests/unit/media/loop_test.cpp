#include "media/loop.h"

#include <gtest/gtest.h>

namespace lapfx::media {
namespace {

TEST(Loop, GoesOnAndStartsOver) {
    const Loop loop{3, 7};
    EXPECT_EQ(loop.length(), 5);
    EXPECT_EQ(loop.after(3), 4);
    EXPECT_EQ(loop.after(7), 3);
    EXPECT_EQ(loop.after(6, 2), 3);
    EXPECT_EQ(loop.after(3, 5), 3);
    EXPECT_EQ(loop.after(4, 13), 7) << "several times round";
    EXPECT_EQ((Loop{4, 4}.after(4, 3)), 4);
}

TEST(Loop, BeginsWithItsFirstFrameFromOutside) {
    const Loop loop{3, 7};
    for (const int outside : {0, 2, 8, 100}) {
        EXPECT_EQ(loop.after(outside), 3) << outside;
        EXPECT_EQ(loop.after(outside, 2), 4) << outside;
    }
}

}  // namespace
}  // namespace lapfx::media
