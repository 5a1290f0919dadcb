// Checks what Effects and AmountsModel take in. Pure; any thread.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "lapfx/wound.h"

namespace lapfx {

struct Preset;

/// Throws Error (bad_input) with every value that is not allowed.
void require_valid(const Preset& preset);

/// A unit vector. Throws Error (bad_input) for a vector without direction.
glm::dvec3 direction_of(const glm::dvec3& gravity);

int waiting_wounds(std::span<const WoundStatus> wounds) noexcept;

}  // namespace lapfx
