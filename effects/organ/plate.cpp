#include "organ/plate.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace lapfx::organ {

namespace {

/// A bowl is deeper by this share at the rim of the round view, as its square towards the middle, and level from
/// `farthest` radii on.
constexpr double fall = 0.3, farthest = 1.5;
constexpr double beyond = 0.01;            // share of the picture by which the surface reaches over each of its edges
constexpr double cell = 1.3;               // mm: a small pool is then within 2 % of its area
constexpr double fewest = 24, most = 300;  // cells a side

glm::dmat4 to_camera(const SceneCamera& camera) {
    return glm::lookAt(camera.eye, camera.target, camera.up);
}

struct Grid {
    glm::ivec2 cells;
    std::size_t vertex(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(cells.x + 1) + static_cast<std::size_t>(x);
    }
    glm::dvec2 place(int x, int y) const {
        return glm::dvec2(x, y) / glm::dvec2(cells) * (1.0 + 2.0 * beyond) - beyond;
    }
};

/// Towards the camera, and along growing u.
void set_directions(Organ& organ, const Grid& grid, const Plate& plate) {
    for (int y = 0; y <= grid.cells.y; ++y)
        for (int x = 0; x <= grid.cells.x; ++x) {
            const glm::dvec2 place = grid.place(x, y);
            constexpr double step = 1e-4;
            const glm::dvec3 right =
                plate.point_at(place + glm::dvec2(step, 0)) - plate.point_at(place - glm::dvec2(step, 0));
            const glm::dvec3 down =
                plate.point_at(place + glm::dvec2(0, step)) - plate.point_at(place - glm::dvec2(0, step));
            organ.normals[grid.vertex(x, y)] = glm::vec3(glm::normalize(glm::cross(down, right)));
            organ.tangents[grid.vertex(x, y)] = glm::vec4(glm::vec3(glm::normalize(right)), 1.0f);
        }
}

}  // namespace

double Plate::depth_at(glm::dvec2 place) const {
    if (depth == PlateDepth::flat) return distance;
    const double radii = std::min(glm::length((place - center) / radius), farthest);
    return distance * (1.0 + fall * radii * radii);
}

glm::dvec2 Plate::half_extent() const {
    const double height = std::tan(glm::radians(camera.field_of_view) / 2.0);
    return {height * aspect, height};
}

glm::dvec3 Plate::point_at(glm::dvec2 place) const {
    const double away = depth_at(place);
    const glm::dvec2 ahead = (place * 2.0 - 1.0) * half_extent() * away;
    return glm::dvec3(glm::inverse(to_camera(camera)) * glm::dvec4(ahead.x, -ahead.y, -away, 1.0));
}

glm::dvec3 Plate::below(const glm::dvec3& point) const {
    const glm::dvec4 thrown = projector() * glm::dvec4(point, 1.0);
    const glm::dvec2 place = glm::dvec2(thrown) / thrown.w;
    const bool seen = thrown.w > 0.0 && place.x >= 0.0 && place.y >= 0.0 && place.x <= 1.0 && place.y <= 1.0;
    return seen ? point_at(place) : point;
}

glm::dmat4 Plate::projector() const {
    const glm::dvec2 half = 0.5 / half_extent();
    glm::dmat4 throws(0.0);  // of camera space: x / -z from -1..1 to 0..1
    throws[0][0] = half.x;
    throws[1][1] = -half.y;
    throws[2] = glm::dvec4(-0.5, -0.5, 0.0, -1.0);
    return throws * to_camera(camera);
}

Plate plate_of(const Scene& scene, glm::dvec2 size, glm::dvec2 center, glm::dvec2 radius) {
    const double to_target = glm::distance(scene.camera.eye, scene.camera.target);
    return {.camera = scene.camera,
            .aspect = size.x / size.y,
            .distance = scene.plate.distance > 0.0 ? scene.plate.distance : to_target,
            .depth = scene.plate.depth,
            .center = center,
            .radius = radius};
}

Organ plate_organ(const Plate& plate, Image picture) {
    const glm::dvec2 size = 2.0 * plate.distance * plate.half_extent();
    const Grid grid{glm::ivec2(glm::clamp(glm::ceil(size / cell), fewest, most))};
    Organ organ;
    organ.name = picture.name;
    const std::size_t vertices = grid.vertex(grid.cells.x, grid.cells.y) + 1;
    organ.positions.resize(vertices);
    organ.normals.resize(vertices);
    organ.tangents.resize(vertices);
    organ.uvs.resize(vertices);
    organ.colors.assign(vertices, glm::vec4(1.0f));
    for (int y = 0; y <= grid.cells.y; ++y)
        for (int x = 0; x <= grid.cells.x; ++x) {
            const glm::dvec2 place = grid.place(x, y);
            organ.positions[grid.vertex(x, y)] = glm::vec3(plate.point_at(place));
            organ.uvs[grid.vertex(x, y)] = glm::vec2(place);
        }
    set_directions(organ, grid, plate);
    for (int y = 0; y < grid.cells.y; ++y)
        for (int x = 0; x < grid.cells.x; ++x)
            for (const glm::ivec2 step : {glm::ivec2(0, 0), {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}})
                organ.indices.push_back(static_cast<std::uint32_t>(grid.vertex(x + step.x, y + step.y)));
    organ.parts = {{.name = "plate",
                    .first_index = 0,
                    .index_count = static_cast<std::uint32_t>(organ.indices.size()),
                    .material = 0}};
    organ.materials = {{.name = "plate", .base_color_image = 0, .double_sided = true}};
    organ.images.push_back(std::move(picture));
    organ.has_uvs = true;
    return organ;
}

}  // namespace lapfx::organ
