// What Effects and AmountsModel take in, checked, and how they count. Pure; any thread.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "lapfx/preset.h"
#include "lapfx/wound.h"

namespace lapfx {

/// Throws Error (bad_input) with all faults of its values.
void require_valid(const Preset& preset);

/// Unit. Throws Error (bad_input) for what is no direction.
glm::dvec3 direction_of(const glm::dvec3& gravity);

int waiting_wounds(std::span<const WoundStatus> wounds) noexcept;

}  // namespace lapfx
