#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "cautery/heat.h"

namespace lapfx::render {

namespace {

constexpr double nearest = 2.0, farthest = 5000.0;  // mm: from touching the lens to a whole body, seen from afar

constexpr double approach = 0.6, withdrawal = 0.8;  // s
constexpr double drawn_back = 70.0;                 // mm

/// Distance of the tip from the organ along the shaft, mm; nothing when the tool is not in the view.
std::optional<double> retreat(const ToolContact& contact, double time) {
    if (time >= contact.time && time <= contact.end()) return 0.0;
    const double share = time < contact.time ? (contact.time - time) / approach : (time - contact.end()) / withdrawal;
    if (share >= 1.0) return std::nullopt;
    return drawn_back * glm::smoothstep(0.0, 1.0, share);
}

/// Where the tip acts; as the contact says where it touches nothing, or need not.
glm::dvec3 on_surface(const ToolContact& contact, double time, const Surface& surface) {
    const glm::dvec3 tip = contact.tip(time);
    if (row_of(contact.action).clears != nullptr || surface.triangles.empty()) return tip;
    const SurfacePoint place = surface.closest_point(tip);
    return place.distance <= cautery::farthest_touch ? place.position : tip;
}

}  // namespace

View view_of(const SceneCamera& camera, const SceneLight& light, glm::ivec2 size) {
    View view;
    view.view = glm::mat4(glm::lookAt(camera.eye, camera.target, camera.up));
    view.projection = glm::mat4(
        glm::perspective(glm::radians(camera.field_of_view), static_cast<double>(size.x) / size.y, nearest, farthest));
    view.lamp = {.intensity = light.intensity,
                 .focus_distance = light.focus_distance,
                 .beam_angle = light.beam_angle,
                 .color = light.color};
    view.response = camera.response();
    return view;
}

SceneCamera fitted(const SceneCamera& camera, double aspect, glm::ivec2 size) {
    const double wider = std::max(1.0, aspect * size.y / size.x);
    SceneCamera made = camera;
    made.field_of_view = glm::degrees(2.0 * std::atan(wider * std::tan(glm::radians(camera.field_of_view) / 2.0)));
    return made;
}

glm::dvec3 ray_through(const SceneCamera& camera, glm::dvec2 pixel, glm::ivec2 size) {
    const double height = std::tan(glm::radians(camera.field_of_view) / 2.0);
    const glm::dvec2 ndc = pixel / glm::dvec2(size) * 2.0 - 1.0;
    const glm::dvec3 in_camera(ndc.x * height * size.x / size.y, -ndc.y * height, -1.0);
    const glm::dmat3 to_camera(glm::lookAt(camera.eye, camera.target, camera.up));
    return glm::normalize(glm::transpose(to_camera) * in_camera);
}

std::optional<glm::mat4> tool_pose(std::span<const ToolContact> contacts, glm::dvec3 port, double time,
                                   const Surface& surface) {
    std::optional<double> least;
    glm::dvec3 tip{0.0};
    for (const ToolContact& contact : contacts) {
        const std::optional<double> away = retreat(contact, time);
        if (!away || (least && *least <= *away)) continue;
        least = away;
        tip = on_surface(contact, time, surface);
    }
    if (!least || glm::distance(port, tip) < 1e-6) return std::nullopt;
    const glm::dvec3 shaft = glm::normalize(port - tip);
    // The x axis of the hook stays level.
    const glm::dvec3 reference = std::abs(shaft.y) < 0.99 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 x = glm::normalize(glm::cross(reference, shaft));
    return glm::mat4(glm::dmat4(glm::dvec4(x, 0.0), glm::dvec4(glm::cross(shaft, x), 0.0), glm::dvec4(shaft, 0.0),
                                glm::dvec4(tip + *least * shaft, 1.0)));
}

std::vector<glm::vec3> tool_end(std::span<const glm::vec3> instrument) {
    constexpr float length = 12.0f;  // mm from the tip
    constexpr std::size_t most = 48;
    std::vector<glm::vec3> end;
    for (const glm::vec3& p : instrument)
        if (glm::dot(p, p) <= length * length) end.push_back(p);
    const std::size_t step = 1 + end.size() / most;
    std::vector<glm::vec3> chosen;
    for (std::size_t i = 0; i < end.size(); i += step) chosen.push_back(end[i]);
    return chosen;
}

glm::mat4 out_of_tissue(const glm::mat4& pose, std::span<const glm::vec3> end, const glm::dvec3& eye,
                        const Surface& surface) {
    constexpr double deepest = 6.0;  // mm: what lies farther before it hides it rightly
    if (surface.triangles.empty()) return pose;
    double most = 0.0;
    for (const glm::vec3& p : end) {
        const glm::dvec3 place(pose * glm::vec4(p, 1.0f));
        const double away = glm::distance(place, eye);
        SurfacePoint hit;
        if (!(away > 0.0) || !surface.intersect_ray(eye, (place - eye) / away, hit)) continue;
        const double hidden = away - hit.distance;
        if (hidden <= deepest) most = std::max(most, hidden);
    }
    const glm::dvec3 tip(pose[3]);
    if (most <= 0.0 || glm::distance(eye, tip) <= 2.0 * deepest) return pose;
    glm::mat4 moved = pose;
    moved[3] += glm::vec4(most * glm::normalize(eye - tip), 0.0);
    return moved;
}

}  // namespace lapfx::render
