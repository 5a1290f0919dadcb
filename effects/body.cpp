#include "body.h"

#include <cassert>

namespace lapfx {

Body::Body(const Organ& organ, std::shared_ptr<const Foundation> foundation, const Simulation& simulation,
           std::uint32_t seed, std::shared_ptr<render::OrganPrograms> programs, render::OrganTextures textures)
    : foundation_(std::move(foundation)),
      moved_(surface()),
      vertices_(organ.positions.size()),
      seed_(seed),
      blood_(bleeding::make_bleeding_gpu(simulation.blood().model(), vertices_)),
      organ_gpu_(organ, blood_.get(), std::move(programs), std::move(textures), foundation_->unsplit),
      touched_(organ.triangle_count()),
      is_touched_(vertices_, 0) {}

MemoryUse Body::memory_use(const Simulation& simulation) const {
    return {.surface = foundation_->surface_memory(),
            .pixels = foundation_->pixel_memory(),
            .densities = foundation_->tissue.shared_memory() + simulation.density().own_memory(),
            .geometry = organ_gpu_.geometry_memory() + blood_->memory() + clips_gpu_.memory(),
            .textures = organ_gpu_.texture_memory()};
}

void Body::take(const Simulation& simulation) {
    foundation_->let_go_pixels();  // densities may need them as they were loaded, and exist now
    if (const bleeding::Model model = simulation.blood().model(); model != blood_->model()) {
        auto other = bleeding::make_bleeding_gpu(model, vertices_);
        organ_gpu_.set_blood(*other);
        blood_ = std::move(other);
    }
    blood_->set(simulation.parameters().bleeding, simulation.down(), seed_);
    send_density(simulation.density());
}

/// Computes the values of all vertices from those that the host gives: midpoints stay midway.
std::span<const glm::vec3> Body::follow(std::span<const glm::vec3> given, std::vector<glm::vec3>& all) const {
    all.assign(given.begin(), given.end());
    for (const glm::uvec2& between : midpoints()) all.push_back(0.5f * (all[between.x] + all[between.y]));
    return all;
}

void Body::set_shape(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals) {
    assert((positions.size() == foundation_->given_vertices() || positions.size() == vertices_) &&
           (normals.empty() || normals.size() == positions.size()));
    const bool midway = positions.size() < vertices_;
    if (midway) positions = follow(positions, positions_);
    moved_.move(positions);
    if (normals.empty()) {
        normals_.resize(vertices_);
        moved_.normals(normals_);
    } else if (midway) {
        normals_.resize(vertices_);
        std::copy(normals.begin(), normals.end(), normals_.begin());
    }
    if (midway) set_normals_midway();
    organ_gpu_.set_shape(positions, normals.empty() || midway ? normals_ : normals, midway || midpoints().empty());
    send_clips();
}

/// Normals of the vertices that splitting has made: no facet appears that the given organ does not have.
void Body::set_normals_midway() {
    for (std::size_t i = 0; i < midpoints().size(); ++i) {
        const glm::vec3 sum = normals_[midpoints()[i].x] + normals_[midpoints()[i].y];
        const float length = glm::length(sum);
        normals_[foundation_->given_vertices() + i] = length > 1e-6f ? sum / length : normals_[midpoints()[i].x];
    }
}

void Body::set_overlay(Overlay overlay, const Simulation& simulation) {
    overlay_ = overlay;
    organ_gpu_.set_overlay(overlay);
    send_density(simulation.density());
}

/// Densities are sent only when an overlay shows them, and only once.
void Body::send_density(const bleeding::TissueDensity& density) {
    if (!row_of(overlay_).densities || sent_density_ == density.version()) return;
    sent_density_ = density.version();
    std::vector<render::DensityPicture> pictures(density.images());
    for (std::size_t i = 0; i < pictures.size(); ++i)
        if (const bleeding::DensityMap* map = density.map(static_cast<int>(i)))
            pictures[i] = {.size = map->size(),
                           .values = map->values(),
                           .wrap_u = map->layout().beyond.u,
                           .wrap_v = map->layout().beyond.v};
    organ_gpu_.send_density(pictures, density.vertex_values());
}

std::size_t Body::send(Simulation& simulation) noexcept {
    bleeding::Bleeding& blood = simulation.blood();
    cautery::Cautery& cautery = simulation.cautery();
    const std::span<const VertexRun> bled = blood.changed().take(), marked = cautery.changed().take();
    touch(bled, [&](std::uint32_t v) { return blood.at(v).any; });
    touch(marked, [&](std::uint32_t v) { return cautery.marks()[v] != glm::vec2(0.0f); });
    const auto clips = cautery.clips();
    const auto there = std::ranges::upper_bound(clips, simulation.time(), {}, &cautery::Clip::time);
    const std::size_t sent = blood_->send(blood, bled) + organ_gpu_.send_marks(cautery.marks(), marked);
    const auto count = static_cast<std::size_t>(there - clips.begin());
    const double length = simulation.parameters().cautery.clip_length;
    if (clips_version_ == cautery.clips_version() && count == clips_.size() && length == clip_length_) return sent;
    clips_version_ = cautery.clips_version();
    clips_.assign(clips.begin(), there);
    clip_length_ = length;
    return sent + send_clips();
}

/// Where the clips are on the organ as it is now.
std::size_t Body::send_clips() {
    poses_.clear();
    for (const cautery::Clip& clip : clips_) poses_.push_back(pose_of(clip, moved_.now()));
    return clips_gpu_.set(poses_, clip_length_);
}

/// A touched triangle stays touched, because blood and time go forwards and backwards.
template <class Touched>
void Body::touch(std::span<const VertexRun> changed, const Touched& is_touched) noexcept {
    for (const VertexRun& run : changed)
        for (std::uint32_t v = run.begin; v < run.end; ++v) {
            if (is_touched_[v] != 0 || !is_touched(v)) continue;
            is_touched_[v] = 1;
            for (const std::uint32_t t : surface().triangles_at(surface().weld[v])) touched_.touch(t);
        }
}

void Body::draw() const noexcept {
    blood_->bind();
    organ_gpu_.draw(glm::mat4(1.0f), &touched_);
    draw_metal_clips();
}

}  // namespace lapfx
