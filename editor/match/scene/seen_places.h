// Places of an organ that a camera sees, without drawing: where a tool may be put that works in view.
//
// Pure functions, any thread.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "lapfx/organ.h"
#include "lapfx/scene.h"

namespace lapfx::match {

struct SeenPlace {
    glm::dvec3 position{0.0};          ///< mm
    glm::dvec3 normal{0.0, 0.0, 1.0};  ///< unit
};

/// Vertices that face the camera and are the nearest of their part of the picture, from its middle outwards; each at
/// least `apart` mm from those before and from `taken`. `aspect`: of the picture, width over height.
std::vector<SeenPlace> seen_places(const Organ& organ, const SceneCamera& camera, double aspect, double apart,
                                   std::span<const glm::dvec3> taken = {}, std::size_t most = 8);

/// What 1 mm2 of blood covers of the view (view_share.h) at the first event that divides tissue in view, or else in the
/// middle of the picture. Nothing where no place is seen.
std::optional<double> seen_share_per_mm2(const Organ& organ, const Scene& scene, double aspect);

}  // namespace lapfx::match
