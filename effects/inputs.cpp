#include "inputs.h"
#include "lapfx/preset.h"

#include <algorithm>
#include <cmath>

namespace lapfx {

void require_valid(const Preset& preset) {
    if (std::vector<Fault> faults = check(preset_table(), &preset); !faults.empty())
        throw Error(Failure::bad_input, std::move(faults));
}

/// A unit vector. Throws Error (bad_input) for a vector without direction.
glm::dvec3 direction_of(const glm::dvec3& gravity) {
    const double length = glm::length(gravity);
    if (length > 1e-6 && std::isfinite(length)) return gravity / length;
    throw Error(Failure::bad_input, Fault{.file = "",
                                          .place = "/gravity",
                                          .reason = "a vector of length " + std::to_string(length) +
                                                    " has no direction; expected one longer than 0.000001"});
}

int waiting_wounds(std::span<const WoundStatus> wounds) noexcept {
    return static_cast<int>(std::count_if(wounds.begin(), wounds.end(),
                                          [](const WoundStatus& w) { return w.state == WoundState::waiting; }));
}

}  // namespace lapfx
