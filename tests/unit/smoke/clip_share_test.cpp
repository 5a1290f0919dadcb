#include "smoke/clip_share.h"

#include <gtest/gtest.h>

#include <vector>

namespace lapfx::smoke {
namespace {

std::vector<double> shares(const std::vector<SmokeClip>& clips) {
    std::vector<double> all;
    for (const SmokeClip& clip : clips) all.push_back(clip_share(clips, clip));
    return all;
}

TEST(ClipShare, IsTheWeightAmongTheClipsOfItsRole) {
    EXPECT_EQ(shares({{.file = "a.mp4", .role = ClipRole::plume, .weight = 1.0},
                      {.file = "a.mp4", .role = ClipRole::haze, .weight = 4.0},
                      {.file = "a.mp4", .role = ClipRole::plume, .weight = 3.0},
                      {.file = "a.mp4", .role = ClipRole::haze, .weight = 1.0}}),
              (std::vector{0.25, 0.8, 0.75, 0.2}));
}

TEST(ClipShare, OfOneAloneIsAllWhateverItsWeight) {
    for (const double weight : {0.05, 1.0, 4.0})
        for (const ClipRole role : {ClipRole::plume, ClipRole::haze})
            EXPECT_EQ(shares({{.file = "a.mp4", .role = role, .weight = weight}}), std::vector{1.0});
}

TEST(ClipShare, IsNothingWithoutAWeight) {
    EXPECT_EQ(shares({{.file = "a.mp4", .weight = 0.0}, {.file = "a.mp4", .weight = 2.0}}), (std::vector{0.0, 1.0}));
    EXPECT_EQ(shares({{.file = "a.mp4", .weight = 0.0}, {.file = "a.mp4", .weight = 0.0}}), (std::vector{0.0, 0.0}));
}

}  // namespace
}  // namespace lapfx::smoke
