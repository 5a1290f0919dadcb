// Where and how dense the source smoke of one contact is at a time. Closed form; pure function, any thread.
#pragma once

#include <glm/glm.hpp>

#include "lapfx/preset.h"
#include "lapfx/tool.h"

namespace lapfx::smoke {

struct PlumeState {
    double density = 0.0;    ///< 0 = nothing to draw
    glm::dvec3 anchor{0.0};  ///< mm, where the clip's source lies
    double height = 0.0;     ///< mm, of the whole clip
};

/// The plume stands on the tip while the tool burns; when it stops, the smoke rises along `up` (unit), grows
/// and fades.
PlumeState plume_state(const ToolContact& contact, const PlumeParameters& plume, glm::dvec3 up, double time) noexcept;

}  // namespace lapfx::smoke
