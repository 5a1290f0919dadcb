// The roles of smoke clips, one row each: what lapfx's programs, files and help have of them.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <iterator>
#include <string_view>

#include "lapfx/rows.h"
#include "lapfx/smoke_parameters.h"

namespace lapfx {

/// What light becomes in the smoke of a role.
struct SmokeMedium {
    glm::dvec3 color{1.0};  ///< sRGB
    glm::dvec3 extinction{1.0};
};

/// How a row leads to the part of the parameters that its smoke is made with. `amount`: the member without which there
/// is none.
template <auto part>
SmokeMedium medium_of_part(const SmokeParameters& smoke) {
    return {.color = (smoke.*part).color, .extinction = (smoke.*part).extinction};
}
template <auto part, auto amount>
bool wants_part(const SmokeParameters& smoke) {
    return smoke.*part.*amount > 0.0;
}
template <auto part, auto amount>
void leave_out_part(SmokeParameters& smoke) {
    smoke.*part.*amount = 0.0;
}

/// Everything about a role that is no drawing, one row each, in the order of the enumerators: arrays by role have their
/// size from here, files, help and user interfaces its name. Where its layers are is said by Smoke::add_layers(),
/// which shaders draw them by shaders_of() of the SmokeGpu: both ask for the enumerator in a switch without default, so
/// that the compiler names them.
struct ClipRoleRow {
    ClipRole role;
    std::string_view key;      ///< JSON has this name for it: "plume"
    std::string_view help;     ///< where its smoke is, in a few words for behind a colon
    std::string_view without;  ///< what is seen while no clip has this role
    /// Lies between the camera and all that it sees, as wide as the view. Otherwise its layers stand in the scene,
    /// which may hide them, at the place in their clip where smoke starts.
    bool fills_view;
    SmokeMedium (*medium)(const SmokeParameters&);
    bool (*wanted)(const SmokeParameters&);  ///< the preset makes such smoke
    void (*leave_out)(SmokeParameters&);     ///< the preset makes none any more
};

inline constexpr ClipRoleRow clip_roles[] = {
    {.role = ClipRole::plume,
     .key = "plume",
     .help = "smoke at the tool tip",
     .without = "no smoke at the tool tip",
     .fills_view = false,
     .medium = medium_of_part<&SmokeParameters::plume>,
     .wanted = wants_part<&SmokeParameters::plume, &PlumeParameters::density>,
     .leave_out = leave_out_part<&SmokeParameters::plume, &PlumeParameters::density>},
    {.role = ClipRole::haze,
     .key = "haze",
     .help = "smoke over the whole view",
     .without = "the haze is an even veil",
     .fills_view = true,
     .medium = medium_of_part<&SmokeParameters::haze>,
     .wanted = wants_part<&SmokeParameters::haze, &HazeParameters::accumulation>,
     .leave_out = leave_out_part<&SmokeParameters::haze, &HazeParameters::accumulation>},
};

inline constexpr std::size_t clip_role_count = std::size(clip_roles);
static_assert(rows_follow<&ClipRoleRow::role>(clip_roles));

constexpr const ClipRoleRow& row_of(ClipRole role) noexcept {
    return clip_roles[static_cast<std::size_t>(role)];
}

/// One value for each role.
template <class T>
struct PerRole {
    std::array<T, clip_role_count> values{};

    constexpr T& operator[](ClipRole role) noexcept { return values[static_cast<std::size_t>(role)]; }
    constexpr const T& operator[](ClipRole role) const noexcept { return values[static_cast<std::size_t>(role)]; }
    constexpr auto begin() noexcept { return values.begin(); }
    constexpr auto begin() const noexcept { return values.begin(); }
    constexpr auto end() noexcept { return values.end(); }
    constexpr auto end() const noexcept { return values.end(); }
};

}  // namespace lapfx
