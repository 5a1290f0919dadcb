// How a camera has moved between two pictures of the same tissue. Pure; any thread.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "media/valid_view.h"

namespace lapfx::media {

/// The homography that leads from places of `from` to those of the same tissue in `to`, pixels; both pictures are of
/// one size. Only what lies in `view` counts. Nothing when too few places are found again, or when what they say is no
/// motion of a camera.
std::optional<glm::dmat3> camera_motion(const Image& from, const Image& to, const ValidView& view);

/// Where a homography leads.
inline glm::dvec2 moved(const glm::dmat3& motion, glm::dvec2 place) {
    const glm::dvec3 to = motion * glm::dvec3(place, 1.0);
    return glm::dvec2(to) / to.z;
}

}  // namespace lapfx::media
