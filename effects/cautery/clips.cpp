#include "cautery/clips.h"

#include <algorithm>

#include "organ/path.h"

namespace lapfx::cautery {

namespace {

glm::dvec3 place_on(const SurfacePoint& point, TriangleMesh mesh) {
    glm::dvec3 place(0.0);
    for (int i = 0; i < 3; ++i) place += point.weights[i] * mesh.positions[mesh.triangles[point.triangle][i]];
    return place;
}

/// Its length is twice the triangle's area.
glm::dvec3 normal_at(const SurfacePoint& point, TriangleMesh mesh) {
    const auto& corners = mesh.triangles[point.triangle];
    const glm::dvec3 a = mesh.positions[corners[0]];
    return glm::cross(mesh.positions[corners[1]] - a, mesh.positions[corners[2]] - a);
}

glm::dvec3 unit(const glm::dvec3& v, const glm::dvec3& otherwise) {
    const double length = glm::length(v);
    return length > 1e-9 ? v / length : otherwise;
}

/// The part of `v` that lies in the surface.
glm::dvec3 within(const glm::dvec3& v, const glm::dvec3& normal) {
    return v - normal * glm::dot(v, normal);
}

}  // namespace

ClipPose pose_of(const Clip& clip, TriangleMesh now) {
    const glm::dvec3 middle = place_on(clip.middle, now), begin = place_on(clip.ends[0], now),
                     end = place_on(clip.ends[1], now);
    const glm::dvec3 sum = unit(normal_at(clip.middle, now), glm::dvec3(0.0)) +
                           unit(normal_at(clip.ends[0], now), glm::dvec3(0.0)) +
                           unit(normal_at(clip.ends[1], now), glm::dvec3(0.0));
    const glm::dvec3 along = unit(end - begin, {1.0, 0.0, 0.0});
    const glm::dvec3 across = std::abs(along.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    const glm::dvec3 up = unit(within(sum, along), unit(within(across, along), across));
    return {.position = glm::vec3(middle), .along = glm::vec3(along), .up = glm::vec3(up)};
}

/// The clip rests on the surface under its ends: it is straight across a hollow or over a bulge.
void ClipList::put(Clip& clip, const glm::dvec3& direction) const {
    const glm::dvec3 normal = unit(normal_at(clip.middle, surface_.mesh()), {0.0, 0.0, 1.0});
    const glm::dvec3 x = within({1.0, 0.0, 0.0}, normal), y = within({0.0, 1.0, 0.0}, normal);
    const glm::dvec3 lying = unit(glm::dot(x, x) > 0.1 ? x : y, {1.0, 0.0, 0.0});
    const glm::dvec3 half = 0.5 * length_ * unit(within(direction, normal), lying);
    clip.ends[0] = surface_.closest_point(clip.middle.position - half);
    clip.ends[1] = surface_.closest_point(clip.middle.position + half);
}

void ClipList::set(const Track& track, std::size_t first, const CauteryParameters& parameters) {
    const auto stays = track.stays();
    if (length_ != parameters.clip_length || reach_ != parameters.clip_reach) first = 0;
    length_ = parameters.clip_length;
    reach_ = parameters.clip_reach;
    bool changed = false;
    for (; !clips_.empty() && clips_.back().stay >= first; clips_.pop_back()) changed = true;
    for (Clip& clip : clips_)
        if (clip.aimed_by != Clip::none && clip.aimed_by >= first) {
            clip.aimed_by = Clip::none;
            put(clip, glm::dvec3(0.0));
            changed = true;
        }
    for (std::size_t i = first; i < stays.size(); ++i) {
        const Stay& stay = stays[i];
        if (stay.contact.action != ToolAction::clip) continue;
        const auto number = static_cast<std::uint32_t>(i);
        if (stay.chain == number && touches(surface_, stay.contact.position)) {
            clips_.push_back({.time = stay.contact.time,
                              .middle = surface_.closest_point(stay.contact.position),
                              .ends = {},
                              .stay = number});
            put(clips_.back(), glm::dvec3(0.0));
            changed = true;
        }
        if (stay.length < aim) continue;
        const auto clip =
            std::find_if(clips_.rbegin(), clips_.rend(), [&](const Clip& c) { return c.stay == stay.chain; });
        if (clip == clips_.rend() || clip->aimed_by != Clip::none) continue;
        const double piece = glm::distance(stay.contact.position, stay.contact.to);
        const double share = piece > 0.0 ? 1.0 - (stay.length - aim) / piece : 1.0;
        clip->aimed_by = number;
        put(*clip, glm::mix(stay.contact.position, stay.contact.to, share) - stays[stay.chain].contact.position);
        changed = true;
    }
    version_ += changed;
}

void ClipList::seal(const WoundList& wounds, std::vector<Wound>& sealed) {
    sealed.assign(wounds.wounds().begin(), wounds.wounds().end());
    for (const Clip& clip : clips_) {
        const glm::dvec3 begin = clip.ends[0].position, end = clip.ends[1].position;
        wounds.find(glm::min(begin, end) - reach_, glm::max(begin, end) + reach_, near_);
        for (const std::uint32_t i : near_) {
            Wound& wound = sealed[i];
            if (organ::distance_to_path(wound.position, begin, end) > reach_) continue;
            wound.sealed = std::min(wound.sealed, clip.time);
            wound.stop = std::min(wound.stop, clip.time);
        }
    }
}

}  // namespace lapfx::cautery
