// Camera and tool of a scene as matrices. Pure functions, any thread.
#pragma once

#include <optional>

#include <span>

#include "lapfx/scene.h"
#include "lapfx/view.h"

namespace lapfx::render {

/// The view of a frame of `size` pixels.
View view_of(const SceneCamera& camera, const SceneLight& light, glm::ivec2 size);

/// The camera of a picture of that aspect (width over height), so wide that a frame of `size` pixels shows all of it.
SceneCamera fitted(const SceneCamera& camera, double aspect, glm::ivec2 size);

/// Direction from the camera through a pixel (origin top left), organ space, unit.
glm::dvec3 ray_through(const SceneCamera& camera, glm::dvec2 pixel, glm::ivec2 size);

/// The place of the instrument at `time`: its tip is on the organ during a contact and drawn back along the shaft
/// shortly before and after; otherwise nothing. The tip is the origin of the instrument, and the shaft runs along +z to
/// the port.
std::optional<glm::mat4> tool_pose(std::span<const ToolContact> contacts, glm::dvec3 port, double time);

}  // namespace lapfx::render
