// Where a frame is seen from, and the lamp beside the camera. Plain data; lengths mm.
#pragma once

#include <glm/glm.hpp>

namespace lapfx {

/// The endoscope's lamp, at the camera.
struct Lamp {
    double intensity = 1.0;         ///< a white surface that faces the lamp at the focus distance is lit to this
    double focus_distance = 100.0;  ///< mm
    double beam_angle = 75.0;       ///< degrees; whole angle within which the light is above half
    double ambient = 0.02;          ///< light from all around, as a share of the lamp's
    glm::dvec3 color{1.0};          ///< sRGB
};

/// False colour over the tissue, for tuning: what the effects use but the picture does not show.
enum class Overlay {
    none,
    vessels,  ///< density of vessels, blue
    fat,      ///< density of fat, yellow
    bleed,    ///< the bleed value: isolines every 2 mm, from blue at 0 to red at 20 mm
};

/// Where the frame is seen from.
struct View {
    glm::mat4 view{1.0f};        ///< organ space to camera space, rigid
    glm::mat4 projection{1.0f};  ///< OpenGL clip space, z in -1..1, perspective
    Lamp lamp;
};

}  // namespace lapfx
