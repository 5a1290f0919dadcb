// A small picture of an organ before it is loaded, to see its shape, its way up and its size by. Drawn here, not by the
// preview: that needs the organ split, its vessels found and the unit known.
//
//     const app::OrganPicture seen = app::organ_picture(organ, turned, {320, 200});
//
// Any thread.
#pragma once

#include <glm/glm.hpp>

#include "lapfx/organ.h"

namespace lapfx::app {

struct OrganPicture {
    Image image;                 ///< transparent around the organ
    double units_per_pixel = 0;  ///< of the organ's positions; there is no perspective
};
/// From the front, y up, turned by `rotation`. At most some million triangles are drawn, evenly chosen.
OrganPicture organ_picture(const Organ& organ, const glm::dmat3& rotation, glm::ivec2 size);

}  // namespace lapfx::app
