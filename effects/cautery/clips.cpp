#include "cautery/clips.h"

#include <algorithm>

#include "lapfx/parameter.h"
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

bool lie_alike(const Clip& a, const Clip& b) {
    const auto alike = [](const SurfacePoint& p, const SurfacePoint& q) {
        return p.position == q.position && p.triangle == q.triangle;
    };
    return a.time == b.time && alike(a.middle, b.middle) && alike(a.ends[0], b.ends[0]) && alike(a.ends[1], b.ends[1]);
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

void ClipList::enter(std::uint32_t clip) {
    const glm::dvec3 begin = clips_[clip].ends[0].position, end = clips_[clip].ends[1].position;
    grid_.insert(clip, glm::min(begin, end) - reach_, glm::max(begin, end) + reach_);
}

void ClipList::leave(std::uint32_t clip) {
    const glm::dvec3 begin = clips_[clip].ends[0].position, end = clips_[clip].ends[1].position;
    grid_.remove(clip, glm::min(begin, end) - reach_, glm::max(begin, end) + reach_);
}

void ClipList::turn(std::uint32_t clip, const glm::dvec3& direction) {
    leave(clip);
    put(clips_[clip], direction);
    enter(clip);
}

double ClipList::set(const Track& track, std::size_t first, const CauteryParameters& parameters, unsigned changed) {
    const auto stays = track.stays();
    const bool same = (changed & redo::metal_clips) == 0;
    if (!same) first = 0;
    double from = never;
    before_.clear();
    for (; !clips_.empty() && clips_.back().stay >= first; clips_.pop_back()) {
        leave(static_cast<std::uint32_t>(clips_.size() - 1));
        before_.push_back(clips_.back());
    }
    length_ = parameters.clip_length;
    reach_ = parameters.clip_reach;
    const std::size_t kept = clips_.size();
    for (std::uint32_t i = 0; i < kept; ++i)
        if (clips_[i].aimed_by != Clip::none && clips_[i].aimed_by >= first) {
            clips_[i].aimed_by = Clip::none;
            turn(i, glm::dvec3(0.0));
            from = std::min(from, clips_[i].time);
        }
    for (std::size_t i = first; i < stays.size(); ++i) {
        const Stay& stay = stays[i];
        if (!row_of(stay.contact.action).sets_clip) continue;
        const auto number = static_cast<std::uint32_t>(i);
        if (stay.chain == number && touches(surface_, stay.contact.position)) {
            clips_.push_back({.time = stay.contact.time,
                              .middle = surface_.closest_point(stay.contact.position),
                              .ends = {},
                              .stay = number});
            put(clips_.back(), glm::dvec3(0.0));
            enter(static_cast<std::uint32_t>(clips_.size() - 1));
        }
        if (stay.length < aim) continue;
        const auto clip =
            std::find_if(clips_.rbegin(), clips_.rend(), [&](const Clip& c) { return c.stay == stay.chain; });
        if (clip == clips_.rend() || clip->aimed_by != Clip::none) continue;
        const double piece = glm::distance(stay.contact.position, stay.contact.to);
        const double share = piece > 0.0 ? 1.0 - (stay.length - aim) / piece : 1.0;
        clip->aimed_by = number;
        const auto index = static_cast<std::uint32_t>(clips_.rend() - clip - 1);
        turn(index, glm::mix(stay.contact.position, stay.contact.to, share) - stays[stay.chain].contact.position);
        if (index < kept) from = std::min(from, clip->time);
    }
    // Most samples of the stroke that sets a clip change nothing: the clip is there from the first one on.
    std::reverse(before_.begin(), before_.end());
    for (std::size_t i = 0; i < std::max(before_.size(), clips_.size() - kept); ++i) {
        const Clip* const was = i < before_.size() ? &before_[i] : nullptr;
        const Clip* const is = kept + i < clips_.size() ? &clips_[kept + i] : nullptr;
        if (same && was != nullptr && is != nullptr && lie_alike(*was, *is)) continue;
        for (const Clip* clip : {was, is})
            if (clip != nullptr) from = std::min(from, clip->time);
    }
    version_ += from < never;
    return from;
}

double ClipList::sealed_at(const glm::dvec3& place) {
    double time = never;
    grid_.find(place, place, near_);
    for (const std::uint32_t i : near_) {
        const Clip& clip = clips_[i];
        if (clip.time < time &&
            !(organ::distance_to_path(place, clip.ends[0].position, clip.ends[1].position) > reach_))
            time = clip.time;
    }
    return time;
}

}  // namespace lapfx::cautery
