// sRGB transfer (IEC 61966-2-1), as in shaders/color.glsl.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/color_space.hpp>

namespace lapfx::gl {

inline glm::vec3 to_linear(glm::vec3 srgb) {
    return glm::convertSRGBToLinear(srgb);
}

}  // namespace lapfx::gl
