// How much of the view a patch of tissue covers, in closed form: what turns mm2 of blood into the share of the picture
// that is measured. It is the figure of a small patch that nothing hides: blood that runs round a bend or behind a fold
// covers less. A render tells; this is where to begin.
//
//     const double per_mm2 = match::share_per_mm2(scene.camera, 4.0 / 3.0, wound.position, wound.normal);
//
// Pure functions, any thread.
#pragma once

#include <glm/glm.hpp>

#include "lapfx/scene.h"

namespace lapfx::match {

/// The valid view of what this camera draws, as EstimatorOptions::round_view: the round picture, or a disc around all
/// of it. A picture of ours need not be looked through for it: before smoke lights it, the dark behind an organ looks
/// like the surround.
glm::dvec3 round_view_of(const SceneCamera& camera, double aspect);

/// Area of the valid view, in squares as high as the picture: `aspect` (width over height) without a vignette, else the
/// round view as far as it is within the picture. It is round from a vignette of 0.5 on.
double view_area(const SceneCamera& camera, double aspect);

/// Share of the valid view, 0..1, that 1 mm2 of surface at `position` (mm, organ space) covers, seen through the
/// camera's pinhole: f * f * cos(angle of the view to `normal`) * distance / depth^3, f in heights of the picture, over
/// view_area(). 0 for what is behind the camera or faces away from it. `normal` needs no length of 1.
double share_per_mm2(const SceneCamera& camera, double aspect, const glm::dvec3& position, const glm::dvec3& normal);

}  // namespace lapfx::match
