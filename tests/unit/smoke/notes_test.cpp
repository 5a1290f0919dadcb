// Notes for a person about smoke that no clip shows.
#include <gtest/gtest.h>

#include "lapfx/authoring/smoke_notes.h"

namespace lapfx {
namespace {

using Notes = std::vector<std::string>;
constexpr const char* no_plume = "no clip has the role plume: no smoke at the tool tip";
constexpr const char* even = "no clip has the role haze: the haze is an even veil";

SmokeParameters with(std::vector<ClipRole> roles) {
    SmokeParameters smoke;
    for (const ClipRole role : roles) smoke.clips.push_back({.file = "a.mp4", .role = role});
    return smoke;
}

TEST(SmokeNotes, TellOfEachKindThatNoClipShows) {
    EXPECT_EQ(smoke_notes(with({})), Notes{"no smoke clips: cautery makes no smoke"});
    EXPECT_EQ(smoke_notes(with({ClipRole::plume})), Notes{even});
    EXPECT_EQ(smoke_notes(with({ClipRole::haze})), Notes{no_plume});
    EXPECT_EQ(smoke_notes(with({ClipRole::plume, ClipRole::haze})), Notes{});
}

TEST(SmokeNotes, AClipWithoutWeightShowsNothing) {
    SmokeParameters smoke = with({ClipRole::plume, ClipRole::haze});
    smoke.clips[0].weight = 0.0;
    EXPECT_EQ(smoke_notes(smoke), Notes{no_plume});
}

TEST(SmokeNotes, WhatIsNotWantedIsNotMissed) {
    SmokeParameters smoke = with({ClipRole::plume});
    smoke.haze.accumulation = 0.0;
    EXPECT_EQ(smoke_notes(smoke), Notes{});
    smoke.clips.clear();
    smoke.plume.density = 0.0;
    EXPECT_EQ(smoke_notes(smoke), Notes{});
}

}  // namespace
}  // namespace lapfx
