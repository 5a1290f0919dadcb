// Shared by the heat models: which contacts count, what a tip does along its path, and what heat does to tissue.
// Temperatures degrees Celsius, rises degrees above the body's 37, lengths mm, times s. Pure; any thread.
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>

#include "lapfx/cautery_parameters.h"
#include "lapfx/tool.h"

namespace lapfx::cautery {

inline constexpr double body_temperature = 37.0;
inline constexpr double never = std::numeric_limits<double>::infinity();
inline constexpr double wound_spacing =
    2.5;  ///< mm between the wounds of a cut line; below the width of any visible pool
inline constexpr double farthest_touch = 5.0;  ///< mm from the surface beyond which the tip touches nothing

/// How strongly tissue bleeds where the tool divides it, as a factor on the wound's strength; 0 = not at all (too few
/// vessels). Empty = 1 everywhere.
using StrengthAt = std::function<double(const glm::dvec3& position)>;

/// Divides without heat.
inline bool cold(ToolAction action) noexcept {
    return divides(action) && !row_of(action).hot;
}

/// Strength of a wound that a contact opens at `place`.
double wound_strength(const ToolContact& contact, const glm::dvec3& place, const StrengthAt& strength_at);

/// Degrees per second directly under the tip.
inline double rise_rate(const ToolContact& contact, const CauteryParameters& c) noexcept {
    return contact.hot() ? c.heat_rate * contact.power : 0.0;
}

/// Highest rise that can be read.
inline double highest_rise(const CauteryParameters& c) noexcept {
    return c.maximum_temperature > body_temperature ? c.maximum_temperature - body_temperature : 0.0;
}

/// Highest rise that gentle heat makes, such as that of coagulation: it heats only up to half way between the
/// coagulation and the char temperature, so that tissue blanches and does not char.
inline double gentle_rise(const CauteryParameters& c) noexcept {
    return std::min(highest_rise(c), 0.5 * (c.coagulation_temperature + c.char_temperature) - body_temperature);
}

/// When heat has last divided the tissue of a wound, and where the tip was. Never: cold tools have opened it.
struct Burn {
    double time = never;
    glm::dvec3 tip{0.0};
};

struct Interval {
    double from, to;
};
/// When the tip of this contact is within `radius` of `place`.
std::optional<Interval> passes(const ToolContact& contact, glm::dvec3 place, double radius) noexcept;

/// char_of() of tissue that has reached the char temperature.
inline constexpr double browned = 0.35;

/// Char from the hottest temperature: 0 = unburnt .. 1 = fully charred.
double char_of(double peak, const CauteryParameters& c) noexcept;

/// How far tissue is divided `distance` mm from a divided place, 0 = whole .. 1 = divided: one tip radius wide, with a
/// soft edge. What frays (blunt dissection) is wider and nowhere fully divided, so that the shader's noise leaves
/// strands.
double divided_at(double distance, ToolAction action, const CauteryParameters& c) noexcept;

}  // namespace lapfx::cautery
