// Contacts of tools for tests, with full power and strength.
#pragma once

#include <glm/glm.hpp>

#include "lapfx/tool.h"

namespace lapfx::test {

/// Along a line, mm; times in s.
inline ToolContact contact(ToolAction action, double time, double duration, const glm::dvec3& from,
                           const glm::dvec3& to) {
    return {.action = action, .time = time, .duration = duration, .position = from, .to = to};
}

/// On one place.
inline ToolContact contact(ToolAction action, double time, double duration, const glm::dvec3& place = glm::dvec3(0.0)) {
    return contact(action, time, duration, place, place);
}

}  // namespace lapfx::test
