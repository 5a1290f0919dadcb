#include "bleeding/tissue_color.h"

#include "lapfx/authoring/srgb.h"

namespace lapfx::bleeding {

glm::dvec3 lab_of(const glm::dvec3& linear) {
    const glm::dvec3 white(0.950456, 1.0, 1.088754);
    const glm::dvec3 xyz = glm::dvec3(glm::dot(linear, glm::dvec3(0.412453, 0.357580, 0.180423)),
                                      glm::dot(linear, glm::dvec3(0.212671, 0.715160, 0.072169)),
                                      glm::dot(linear, glm::dvec3(0.019334, 0.119193, 0.950227))) /
                           white;
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
    return {116.0 * f(xyz.y) - 16.0, 500.0 * (f(xyz.x) - f(xyz.y)), 200.0 * (f(xyz.y) - f(xyz.z))};
}

glm::dvec3 lab_of_srgb(const glm::dvec3& srgb) {
    glm::dvec3 linear;
    for (int c = 0; c < 3; ++c) linear[c] = linear_of_srgb(srgb[c]);
    return lab_of(linear);
}

}  // namespace lapfx::bleeding
