// The colour that a field needs so that the picture shows the one that a person picked: lamp, exposure, tone curve and
// what lies over and under it come between both. It is tried out: the scene is drawn with a few colours, and each
// channel of the light where the field acts is a straight line over the field's own light.
//
//     const app::SolvedColor solved = app::solve_color({0.37, 0.11, 0.13}, now, place, [&](const glm::dvec3& color) {
//         return drawn_with(color);
//     });
//
// Colours are sRGB, 0..1.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>

#include "lapfx/camera.h"
#include "lapfx/organ.h"

namespace lapfx::app {

struct SolvedColor {
    glm::dvec3 color{0.0};  ///< the field gets this colour, in whole code values
    bool acts = false;      ///< something in the picture has it; else `color` is the one that was picked
    glm::dvec2 place{0.0};  ///< where it was solved for, shares of the picture from its upper left corner
    glm::dvec3 picked{0.0};
    glm::dvec3 seen{0.0};  ///< what is seen there with `color`
    double off = 0;        ///< Delta E (CIE 1976) from the one that was picked
};

/// That far from what was picked it counts as the same.
inline constexpr double reached_color = 3;

/// `now`: the field as it is. `draw` gives the picture, of one size, with the field as it is told. The place is `place`
/// where the field acts there and the colour can be reached, else a typical one among those where it acts most. Where
/// the colour cannot be reached, one that comes as near to the eye as the nearest, and is not farther from what was
/// picked. `response`: of the pictures.
SolvedColor solve_color(const glm::dvec3& picked, const glm::dvec3& now, const std::optional<glm::dvec2>& place,
                        const std::function<Image(const glm::dvec3&)>& draw, const CameraResponse& response = {});

}  // namespace lapfx::app
