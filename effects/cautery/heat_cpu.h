// Heat under the tool, radial model (paper: "the amount of heat and its effects on the nearby tissue is
// proportional to the duration of the application of the cautery ... the region affected by the heat is
// expanded radially ... If a pre-determined temperature threshold is exceeded, the tissue within the region
// is divided and bleeding is initiated"). Temperatures degrees Celsius, lengths mm, times s; closed form.
// Pure; any thread.
#pragma once

#include <span>
#include <vector>

#include "lapfx/preset.h"
#include "lapfx/tool.h"
#include "lapfx/wound.h"

namespace lapfx::cautery {

inline constexpr double body_temperature = 37.0;
inline constexpr double tip_radius = 1.5;  ///< mm of tissue that the bare tip touches

/// Where on the tip's path, 0 at its start .. 1 at its end, the tip is nearest to `point`.
double nearest_share(const ToolContact& contact, glm::dvec3 point) noexcept;

/// The hottest that the tissue at `point` has been by `time` because of this contact.
double peak_temperature(const ToolContact& contact, const CauteryParameters& cautery, glm::dvec3 point,
                        double time) noexcept;

/// 0 = unburnt .. 1 = charred through, from the hottest temperature.
double char_of(double peak, const CauteryParameters& cautery) noexcept;

/// mm from the tip's path beyond which a contact of this length changes nothing that can be seen.
double heated_reach(const ToolContact& contact, const CauteryParameters& cautery) noexcept;

/// The wounds that these contacts open, each with the time at which a later coagulating contact stops it. A
/// moving tip opens a row of wounds along its path. In the order of the contacts.
std::vector<Wound> wounds_of(std::span<const ToolContact> contacts, const CauteryParameters& cautery);

}  // namespace lapfx::cautery
