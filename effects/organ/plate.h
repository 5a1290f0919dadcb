// The surface of a plate (lapfx/scene.h): tissue of a plausible depth that fills the view of a camera. Pure; any
// thread.
#pragma once

#include "lapfx/organ.h"
#include "lapfx/scene.h"

namespace lapfx::organ {

/// The surface and the camera that it is made for.
struct Plate {
    SceneCamera camera;       ///< of its picture: eye, target, up and field of view
    double aspect = 1.0;      ///< width over height of its picture
    double distance = 100.0;  ///< mm along the view, of its middle
    PlateDepth depth = PlateDepth::bowl;
    glm::dvec2 center{0.5};  ///< the round view's middle in the picture: 0..1 from the upper left corner
    glm::dvec2 radius{0.5};  ///< the round view's radii: shares of the picture's width and height

    /// Distance along the view, mm, at a place of the picture, 0..1 from its upper left corner.
    double depth_at(glm::dvec2 place) const;
    /// Where that place lies, mm.
    glm::dvec3 point_at(glm::dvec2 place) const;
    /// Where the camera sees `point` on the surface, mm; the point itself where it does not.
    glm::dvec3 below(const glm::dvec3& point) const;
    /// From organ space to places of the picture, homogeneous: as a projector would throw it.
    glm::dmat4 projector() const;
    /// Half the width and height of its picture, at 1 mm from the camera.
    glm::dvec2 half_extent() const;
};

/// The plate of a scene. `size`: that of its picture as it is shown; `center` and `radius`: as in Plate.
Plate plate_of(const Scene& scene, glm::dvec2 size, glm::dvec2 center, glm::dvec2 radius);

/// The surface with the picture as its texture. It reaches a little beyond the picture.
Organ plate_organ(const Plate& plate, Image picture);

}  // namespace lapfx::organ
