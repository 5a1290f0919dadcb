#include "match/scene/seen_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "match/scene/view_share.h"

namespace lapfx::match {

namespace {

constexpr int cells = 24;             // of the picture, each way: one place may be in each
constexpr double within = 0.8;        // of half the picture: its edge is dark, and round
constexpr double least_facing = 0.3;  // cosine

struct NearestInCell {
    SeenPlace place;
    double depth = 0.0;   ///< mm
    double middle = 0.0;  ///< distance to the middle of the picture, half heights
};

struct Pinhole {
    glm::dvec3 eye, ahead, right, up;
    double focal;  ///< half heights
    explicit Pinhole(const SceneCamera& camera)
        : eye(camera.eye),
          ahead(glm::normalize(camera.target - camera.eye)),
          right(glm::normalize(glm::cross(ahead, camera.up))),
          up(glm::cross(right, ahead)),
          focal(1.0 / std::tan(0.5 * glm::radians(camera.field_of_view))) {}
};

bool far_from(const glm::dvec3& position, std::span<const glm::dvec3> taken, double apart) {
    return std::all_of(taken.begin(), taken.end(),
                       [&](const glm::dvec3& other) { return glm::distance(position, other) >= apart; });
}

}  // namespace

std::vector<SeenPlace> seen_places(const Organ& organ, const SceneCamera& camera, double aspect, double apart,
                                   std::span<const glm::dvec3> taken, std::size_t most) {
    const Pinhole pinhole(camera);
    std::array<std::optional<NearestInCell>, cells * cells> nearest;
    for (std::size_t i = 0; i < organ.positions.size(); ++i) {
        const glm::dvec3 position(organ.positions[i]), normal(organ.normals[i]), seen = position - pinhole.eye;
        const double depth = glm::dot(seen, pinhole.ahead);
        if (depth <= 0.0) continue;
        const double x = pinhole.focal * glm::dot(seen, pinhole.right) / depth / aspect,
                     y = pinhole.focal * glm::dot(seen, pinhole.up) / depth;
        if (!(std::abs(x) < 1.0 && std::abs(y) < 1.0)) continue;
        const auto cell = [](double at) { return static_cast<std::size_t>(0.5 * (at + 1.0) * cells); };
        std::optional<NearestInCell>& here = nearest[cell(y) * cells + cell(x)];
        if (!here || depth < here->depth)
            here = NearestInCell{.place = {position, normal}, .depth = depth, .middle = std::hypot(x * aspect, y)};
    }
    std::vector<NearestInCell> found;
    for (const std::optional<NearestInCell>& here : nearest) {
        if (!here || here->middle > within) continue;
        const double facing = -glm::dot(glm::normalize(here->place.position - pinhole.eye), here->place.normal);
        if (facing > least_facing) found.push_back(*here);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const NearestInCell& a, const NearestInCell& b) { return a.middle < b.middle; });
    std::vector<SeenPlace> places;
    std::vector<glm::dvec3> all(taken.begin(), taken.end());
    for (const NearestInCell& here : found) {
        if (places.size() == most) break;
        if (!far_from(here.place.position, all, apart)) continue;
        places.push_back(here.place);
        all.push_back(here.place.position);
    }
    return places;
}

std::optional<double> seen_share_per_mm2(const Organ& organ, const Scene& scene, double aspect) {
    for (const ToolContact& event : scene.events) {
        if (!divides(event.action) || organ.positions.empty()) continue;
        const auto nearest = std::min_element(
            organ.positions.begin(), organ.positions.end(), [&event](const glm::vec3& a, const glm::vec3& b) {
                return glm::distance(glm::dvec3(a), event.position) < glm::distance(glm::dvec3(b), event.position);
            });
        const glm::dvec3 normal(organ.normals[static_cast<std::size_t>(nearest - organ.positions.begin())]);
        const double share = share_per_mm2(scene.camera, aspect, event.position, normal);
        if (share > 0.0) return share;
    }
    const std::vector<SeenPlace> places = seen_places(organ, scene.camera, aspect, 0.0, {}, 1);
    if (places.empty()) return {};
    return share_per_mm2(scene.camera, aspect, places.front().position, places.front().normal);
}

}  // namespace lapfx::match
