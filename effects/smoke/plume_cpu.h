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

/// How much smoke a hot contact gives, plume and haze: its power, and more where the tissue is fat (0..1).
inline double emission(const ToolContact& contact, double fat, const PlumeParameters& plume) {
    return contact.power * (1.0 + plume.fat_gain * fat);
}

/// The plume stands on the tip while the tool burns; when it stops, the smoke rises along `up` (unit), grows
/// and fades. `fat`: of the tissue under the contact, 0..1.
PlumeState plume_state(const ToolContact& contact, const PlumeParameters& plume, glm::dvec3 up, double time,
                       double fat = 0.0) noexcept;

}  // namespace lapfx::smoke
