// Moving a scene's camera by hand. Pure functions on the camera, no window; angles radians, lengths mm.
#pragma once

#include <span>

#include "lapfx/authoring/organ_report.h"
#include "lapfx/organ.h"
#include "lapfx/scene.h"

namespace lapfx::app {

/// Turns the eye around the target: `right` about the camera's up, `up` about its right axis. Never over the poles.
void orbit(SceneCamera& camera, double right, double up);

/// Moves eye and target together by this many pixels of a frame `height` pixels high, so that the target follows the
/// pointer.
void pan(SceneCamera& camera, glm::dvec2 pixels, double height);

/// Moves the eye to `factor` times its distance from the target, within 5 mm to 2 m.
void zoom(SceneCamera& camera, double factor);

/// The same, but towards `place`, which keeps its place in the picture.
void zoom_at(SceneCamera& camera, double factor, const glm::dvec3& place);

/// Looks at `place` from the same side and distance.
void center_on(SceneCamera& camera, const glm::dvec3& place);

/// Distance of `seen` from what it looks at, over that of `from`: the lamp moves with the camera by this factor.
double nearness(const SceneCamera& from, const SceneCamera& seen);

/// Where an instrument enters so that it is seen from the right, as in a picture of two ports; mm.
glm::dvec3 port_for(const SceneCamera& camera);

/// A camera that sees the whole organ from the front, from whichever side it is turned to later.
SceneCamera frame(const OrganReport& organ);

/// That camera for a scene, whose exposure and vignette stay, with the instrument and the light's focus that go with
/// it.
void see_whole(Scene& scene, const OrganReport& organ);

/// The same for this side alone: the points fill a picture of this aspect (width over height) but for a narrow rim.
SceneCamera fit(std::span<const glm::vec3> points, double aspect);

}  // namespace lapfx::app
