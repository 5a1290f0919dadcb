// What an endoscope shows inside the black that surrounds it. Pure; any thread.
#pragma once

#include <optional>

#include "lapfx/organ.h"

namespace lapfx::media {

/// The round view of an endoscope, pixels of a picture, y downwards; an ellipse in a video that is stored squeezed.
struct ViewDisc {
    glm::dvec2 center{0.0};
    glm::dvec2 radius{0.0};  ///< across and down

    /// Distance from the center: 1 on the rim.
    double radii(glm::dvec2 place) const { return glm::length((place - center) / radius); }
};

struct ValidView {
    glm::ivec2 from{0}, to{0};     ///< pixels; the rectangle within the black: first ones, and one behind the last
    std::optional<ViewDisc> disc;  ///< none: the view fills that rectangle

    /// How much of a pixel belongs to it, 0..1; softened over two pixels at the rim of the disc.
    double share(glm::ivec2 pixel) const;
};

/// Finds it in one picture. A picture that is black all over counts as a whole.
ValidView valid_view(const Image& picture);

}  // namespace lapfx::media
