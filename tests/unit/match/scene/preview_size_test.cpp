// The size of pictures that are measured beside a reference.
#include <gtest/gtest.h>

#include "match/scene/preview_curve.h"

namespace lapfx::match {
namespace {

TEST(PreviewSize, HasTheShapeOfTheReferenceAsItIsShown) {
    EXPECT_EQ(preview_size({1280, 1024}), glm::ivec2(256, 205));
    EXPECT_EQ(preview_size({480, 854}), glm::ivec2(144, 256));
    EXPECT_EQ(preview_size({720, 576}, 16.0 / 9.0), glm::ivec2(256, 144)) << "stored 5:4, shown 16:9";
    EXPECT_EQ(preview_size({4000, 2}), glm::ivec2(256, 16));
    EXPECT_EQ(preview_size({0, 0}), glm::ivec2(256, 256));
    EXPECT_EQ(preview_size({1280, 1024}, 0.0, 96), glm::ivec2(96, 77)) << "as small as is asked for";
}

}  // namespace
}  // namespace lapfx::match
