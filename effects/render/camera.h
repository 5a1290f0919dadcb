// Camera and tool of a scene as matrices. Pure functions, any thread.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lapfx/scene.h"
#include "lapfx/view.h"
#include "organ/surface.h"

namespace lapfx::render {

/// The view of a frame of `size` pixels.
View view_of(const SceneCamera& camera, const SceneLight& light, glm::ivec2 size);

/// The camera of a picture of that aspect (width over height), so wide that a frame of `size` pixels shows all of it.
SceneCamera fitted(const SceneCamera& camera, double aspect, glm::ivec2 size);

/// Direction from the camera through a pixel (origin top left), organ space, unit.
glm::dvec3 ray_through(const SceneCamera& camera, glm::dvec2 pixel, glm::ivec2 size);

/// The place of the instrument at `time`: its tip is on the organ during a contact and drawn back along the shaft
/// shortly before and after; otherwise nothing. The tip is the origin of the instrument, and the shaft runs along +z to
/// the port. A tip that touches is drawn on the surface, where it acts: the way of a contact is straight, and leads
/// through tissue that bulges or past it.
std::optional<glm::mat4> tool_pose(std::span<const ToolContact> contacts, glm::dvec3 port, double time,
                                   const Surface& surface);

/// Vertices of an instrument's mesh that stand for its end, the first 12 mm from its tip: at most 48 of them, evenly
/// chosen.
std::vector<glm::vec3> tool_end(std::span<const glm::vec3> instrument);

/// That place, moved so far towards the eye that no fold of the tissue beside the tip hides the end of the instrument:
/// it is rigid here and comes straight from its port, where a hand would turn it out of the tissue. The tip keeps its
/// place in the picture. `end`: its tool_end(). Allocates nothing.
glm::mat4 out_of_tissue(const glm::mat4& pose, std::span<const glm::vec3> end, const glm::dvec3& eye,
                        const Surface& surface);

}  // namespace lapfx::render
