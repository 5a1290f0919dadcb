// The part of a hot contact that is over tissue. Pure; any thread.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "lapfx/tool.h"

namespace lapfx::smoke {

/// Whether a tip at this place touches tissue.
using Touches = std::function<bool(const glm::dvec3&)>;

constexpr double touching_spacing = 1.0;  ///< mm between the places of a path that are tested
constexpr int most_touching_places =
    256;  ///< greatest number of places on one path; on longer paths they are farther apart

/// Adds the parts of the contact during which the tip touches to `parts`, in the order of time; a contact that touches
/// all the time is added unchanged. `contact`: usable (tool/usable_contact.h).
void touching_parts(const ToolContact& contact, const Touches& touches, std::vector<ToolContact>& parts);

}  // namespace lapfx::smoke
