#include "app/preview/orbit.h"
#include "lapfx/authoring/organ_report.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace lapfx::app {

namespace {

constexpr double nearest = 5.0, farthest = 2000.0;  // mm
constexpr double pole = 0.02;                       // rad between view and up at least

glm::dvec3 turned(glm::dvec3 v, double angle, glm::dvec3 axis) {
    return glm::dvec3(glm::rotate(glm::dmat4(1.0), angle, axis) * glm::dvec4(v, 0.0));
}

}  // namespace

void orbit(SceneCamera& camera, double right, double up) {
    const glm::dvec3 pole_axis = glm::normalize(camera.up);
    glm::dvec3 arm = turned(camera.eye - camera.target, -right, pole_axis);
    const double from_pole = std::acos(std::clamp(glm::dot(glm::normalize(arm), pole_axis), -1.0, 1.0));
    const double wanted = std::clamp(from_pole - up, pole, std::numbers::pi - pole);
    const glm::dvec3 side = glm::normalize(glm::cross(pole_axis, arm));
    arm = turned(arm, wanted - from_pole, side);
    camera.eye = camera.target + arm;
}

void pan(SceneCamera& camera, glm::dvec2 pixels, double height) {
    const glm::dvec3 forward = camera.target - camera.eye;
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 up = glm::normalize(glm::cross(right, forward));
    const double mm_per_pixel =
        2.0 * glm::length(forward) * std::tan(glm::radians(camera.field_of_view) / 2.0) / std::max(height, 1.0);
    const glm::dvec3 shift = mm_per_pixel * (-pixels.x * right + pixels.y * up);
    camera.eye += shift;
    camera.target += shift;
}

void zoom(SceneCamera& camera, double factor) {
    const glm::dvec3 arm = camera.eye - camera.target;
    const double distance = std::clamp(glm::length(arm) * factor, nearest, farthest);
    camera.eye = camera.target + distance * glm::normalize(arm);
}

void zoom_at(SceneCamera& camera, double factor, const glm::dvec3& place) {
    const double distance = glm::distance(camera.eye, camera.target);
    const double share = std::clamp(distance * factor, nearest, farthest) / distance;
    camera.eye = place + share * (camera.eye - place);
    camera.target = place + share * (camera.target - place);
}

void center_on(SceneCamera& camera, const glm::dvec3& place) {
    camera.eye += place - camera.target;
    camera.target = place;
}

glm::dvec3 port_for(const SceneCamera& camera) {
    const glm::dvec3 back = camera.eye - camera.target;
    const double distance = glm::length(back);
    const glm::dvec3 right = glm::normalize(glm::cross(camera.up, back));
    return camera.target + 1.2 * distance * right + 0.2 * distance * glm::normalize(camera.up) + 1.1 * back;
}

SceneCamera frame(const OrganReport& organ) {
    SceneCamera camera;
    const glm::dvec3 center = (organ.minimum + organ.maximum) / 2.0;
    const double radius = std::max(glm::length(organ.maximum - organ.minimum) / 2.0, 1.0);
    const double distance = radius / std::sin(glm::radians(camera.field_of_view) / 2.0);
    camera.target = center;
    camera.eye = center + glm::dvec3(0.0, 0.0, std::clamp(distance, nearest, farthest));
    return camera;
}

void see_whole(Scene& scene, const OrganReport& organ) {
    SceneCamera seen = frame(organ);
    seen.set_response(scene.camera.response());
    scene.camera = seen;
    scene.tool.port = port_for(seen);
    scene.light.focus_distance = std::clamp(glm::distance(seen.eye, seen.target), 1.0, 2000.0);
}

SceneCamera fit(std::span<const glm::vec3> points, double aspect) {
    SceneCamera camera;
    if (points.empty()) return camera;
    constexpr double rim = 0.94;  // the outermost point lies at this share of the picture's half
    const double up = rim * std::tan(glm::radians(camera.field_of_view) / 2.0), right = up * aspect;
    // The eye sees a point at x within its side's half if x - eye.x <= right (eye.z - z), and so for the other sides:
    // each bound on x + right z, -x + right z and the same of y holds for all points.
    glm::dvec2 high(-1e30), low(-1e30);
    for (const glm::vec3& p : points) {
        const glm::dvec2 depth = glm::dvec2(right, up) * double(p.z);
        high = glm::max(high, glm::dvec2(p) + depth);
        low = glm::max(low, -glm::dvec2(p) + depth);
    }
    const glm::dvec2 eye = (high - low) / 2.0, far = (high + low) / (2.0 * glm::dvec2(right, up));
    glm::dvec2 depth(points.front().z);
    for (const glm::vec3& p : points) depth = {std::min(depth.x, double(p.z)), std::max(depth.y, double(p.z))};
    camera.target = {eye, (depth.x + depth.y) / 2.0};
    const double distance = std::max(far.x, far.y) - camera.target.z;
    camera.eye = camera.target + glm::dvec3(0.0, 0.0, std::clamp(distance, nearest, farthest));
    return camera;
}

double nearness(const SceneCamera& from, const SceneCamera& seen) {
    return glm::distance(seen.eye, seen.target) / std::max(glm::distance(from.eye, from.target), 1.0);
}

}  // namespace lapfx::app
