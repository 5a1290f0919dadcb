#include "match/scene/view_share.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lapfx::match {

namespace {

/// Heights of the picture: the middle of the rim that shaders/post.frag draws.
constexpr double round_radius = 0.56;
constexpr double round_from = 0.5;  // vignette

/// Of a disc of that radius, what lies beyond a straight line at that distance from its middle.
double segment(double radius, double distance) {
    if (distance >= radius) return 0.0;
    return radius * radius * std::acos(distance / radius) - distance * std::sqrt(radius * radius - distance * distance);
}

}  // namespace

glm::dvec3 round_view_of(const SceneCamera& camera, double aspect) {
    const double all = std::hypot(0.5 * aspect, 0.5);
    return {0.5, 0.5, camera.vignette < round_from ? all : std::min(round_radius, all)};
}

double view_area(const SceneCamera& camera, double aspect) {
    const double half_width = 0.5 * aspect, half_height = 0.5;
    if (round_view_of(camera, aspect).z >= std::hypot(half_width, half_height)) return aspect;
    return std::numbers::pi * round_radius * round_radius - 2.0 * segment(round_radius, half_width) -
           2.0 * segment(round_radius, half_height);
}

double share_per_mm2(const SceneCamera& camera, double aspect, const glm::dvec3& position, const glm::dvec3& normal) {
    const double focal = 0.5 / std::tan(0.5 * glm::radians(camera.field_of_view));
    const glm::dvec3 seen = position - camera.eye;
    const double depth = glm::dot(seen, glm::normalize(camera.target - camera.eye));
    const double facing = -glm::dot(seen, glm::normalize(normal));  // distance * cos
    if (!(depth > 0.0) || !(facing > 0.0)) return 0.0;
    return std::min(focal * focal * facing / (depth * depth * depth) / view_area(camera, aspect), 1.0);
}

}  // namespace lapfx::match
