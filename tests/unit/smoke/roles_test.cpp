// The roles of smoke (lapfx/smoke_parameters.h): one row each, from which files, help and arrays have them.
#include <gtest/gtest.h>

#include <set>

#include "lapfx/authoring/clip_roles.h"
#include "lapfx/authoring/smoke_notes.h"
#include "lapfx/preset.h"
#include "smoke/window.h"

namespace lapfx {
namespace {

TEST(ClipRoles, RowsFollowTheEnumeratorsAndAreToldApart) {
    std::set<std::string_view> keys, helps, without;
    for (std::size_t i = 0; i < clip_role_count; ++i) {
        const ClipRoleRow& row = clip_roles[i];
        EXPECT_EQ(row.role, static_cast<ClipRole>(i)) << row.key;
        EXPECT_EQ(&row_of(row.role), &row);
        EXPECT_TRUE(keys.insert(row.key).second && helps.insert(row.help).second) << row.key;
        EXPECT_TRUE(without.insert(row.without).second) << row.key;
        EXPECT_FALSE(row.help.empty() || row.help.ends_with('.')) << row.key;
    }
}

TEST(ClipRoles, PresetsTakeTheirKeysAndHelp) {
    const Table& clips = *preset_table().find("smoke")->find("clips");
    const Parameter& role = *clips.find_row("role");
    ASSERT_EQ(role.choices.size(), clip_role_count);
    for (const ClipRoleRow& row : clip_roles) {
        EXPECT_EQ(role.choices[static_cast<std::size_t>(row.role)], row.key);
        const std::string told = std::string(row.key) + ": " + std::string(row.help) + '.';
        EXPECT_NE(role.help.find(told), std::string_view::npos) << role.help;
        EXPECT_NE(clips.find_row("weight")->help.find(row.key), std::string_view::npos) << row.key;
    }
    EXPECT_TRUE(role.help.starts_with("plume: smoke at the tool tip. haze: ")) << role.help;
    EXPECT_TRUE(clips.find_row("weight")->help.starts_with(
        "Share of this clip in the smoke of its role, plume or haze: its weight, divided"))
        << clips.find_row("weight")->help;
}

TEST(ClipRoles, EachIsMadeByItsOwnPartOfThePreset) {
    for (const ClipRoleRow& row : clip_roles) {
        const SmokeParameters before;
        SmokeParameters smoke;
        row.leave_out(smoke);
        for (const ClipRoleRow& other : clip_roles)
            EXPECT_EQ(other.wanted(smoke), &other != &row && other.wanted(before)) << other.key;
        const Table* const group = preset_table().find("smoke")->find(row.key);
        ASSERT_NE(group, nullptr) << row.key;
        Preset preset;
        const glm::dvec3 extinction{0.25, 0.5, 0.75};
        *static_cast<glm::dvec3*>(group->find_row("extinction")->member(group->member(&preset.smoke))) = extinction;
        EXPECT_EQ(row.medium(preset.smoke).extinction, extinction) << row.key;
        EXPECT_EQ(row.medium(SmokeParameters{}).color, row.medium(preset.smoke).color) << row.key;
    }
}

TEST(ClipRoles, WhatNoClipShowsIsToldForEach) {
    for (const ClipRoleRow& row : clip_roles) {
        SmokeParameters smoke;
        for (const ClipRoleRow& other : clip_roles)
            if (&other != &row) smoke.clips.push_back({.file = "a.mp4", .role = other.role});
        if (smoke.clips.empty()) smoke.clips.push_back({.file = "a.mp4", .weight = 0.0});
        std::vector<std::string> notes;  // none of a role that the preset makes no smoke of
        if (row.wanted(smoke))
            notes.push_back("no clip has the role " + std::string(row.key) + ": " + std::string(row.without));
        EXPECT_EQ(smoke_notes(smoke), notes) << row.key;
    }
}

TEST(ClipRoles, OneValueForEachIsThatOfTheRole) {
    PerRole<int> numbers;
    int next = 0;
    for (const ClipRoleRow& row : clip_roles) numbers[row.role] = ++next;
    EXPECT_EQ(numbers[ClipRole::plume], 1);
    EXPECT_EQ(numbers[ClipRole::haze], 2);
    EXPECT_EQ(static_cast<std::size_t>(numbers.end() - numbers.begin()), clip_role_count);
}

TEST(ClipRoles, OnlyWhatFillsTheViewIsNotFadedAtItsEdges) {
    for (const ClipRoleRow& row : clip_roles) {
        const smoke::Window window =
            smoke::window_of({.file = "a.mp4", .role = row.role, .edge_fade = 0.2}, {100, 100});
        EXPECT_EQ(window.fills_view, row.fills_view) << row.key;
        EXPECT_EQ(window.fades.x > 1.0f, !row.fills_view) << row.key;
    }
}

}  // namespace
}  // namespace lapfx
