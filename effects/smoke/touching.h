// The part of a hot contact that is over tissue. Pure; any thread.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "lapfx/tool.h"

namespace lapfx::smoke {

/// Whether a tip at this place touches tissue.
using Touches = std::function<bool(const glm::dvec3&)>;

constexpr double touching_spacing = 1.0;   ///< mm between the places of a path that are looked at
constexpr int most_touching_places = 256;  ///< of one path; then they lie farther apart

/// Adds to `parts` where the tip touches, in the order of time: the contact as it is when it does so all along.
/// `contact`: usable (tool/usable_contact.h).
void touching_parts(const ToolContact& contact, const Touches& touches, std::vector<ToolContact>& parts);

}  // namespace lapfx::smoke
