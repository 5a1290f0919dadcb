#include "organ/point_set.h"

#include <gtest/gtest.h>

namespace lapfx::organ {
namespace {

TEST(PointSet, HasEachPointOnceInTheOrderOfArrival) {
    PointSet set(10);
    EXPECT_TRUE(set.empty());
    EXPECT_TRUE(set.add(7));
    EXPECT_TRUE(set.add(2));
    EXPECT_FALSE(set.add(7)) << "it is in it already";
    EXPECT_EQ(std::vector(set.points().begin(), set.points().end()), (std::vector<std::uint32_t>{7, 2}));
    EXPECT_TRUE(set.has(2));
    EXPECT_FALSE(set.has(3));
    set.clear();
    EXPECT_TRUE(set.empty());
    EXPECT_FALSE(set.has(7));
    EXPECT_TRUE(set.add(7)) << "as the first time";
}

}  // namespace
}  // namespace lapfx::organ
