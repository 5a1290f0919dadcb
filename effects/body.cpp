#include "body.h"

#include <cassert>
#include <unordered_map>

namespace lapfx {

Body::Body(const Organ& organ, std::shared_ptr<const Foundation> foundation, glm::dvec3 down, std::uint32_t seed)
    : foundation_(std::move(foundation)),
      moved_(surface()),
      vertices_(organ.positions.size()),
      tissue_(foundation_->tissue),
      bleed_(std::in_place, surface(), down),
      cautery_(surface(), [this](const glm::dvec3& place) { return tissue_.wound_strength(place); }),
      bleed_gpu_(organ.positions.size(), seed, down),
      organ_gpu_(organ, &bleed_gpu_.values(), foundation_->pixels, foundation_->unsplit),
      touched_(organ.triangle_count()),
      is_touched_(vertices_, 0) {}

void Body::set_down(glm::dvec3 down) {
    bleed_.emplace(surface(), down);
    bleed_->set_strength(strength_);
    bleed_gpu_.set_down(down);
}

MemoryUse Body::memory_use() const {
    return {.surface = foundation_->surface_memory(),
            .pixels = foundation_->pixel_memory(),
            .densities = foundation_->tissue.shared_memory() + tissue_.own_memory(),
            .geometry = organ_gpu_.geometry_memory() + bleed_gpu_.values().size(),
            .textures = organ_gpu_.texture_memory()};
}

void Body::set(std::span<const ToolContact> contacts, const Preset& preset) {
    tissue_.set(preset.vessels);
    foundation_->let_go_pixels();  // not before the first set(), which may need them as they were loaded
    if (preset.vessels != vessels_) cautery_.strengths_changed();
    vessels_ = preset.vessels;
    bleeding_ = preset.bleeding;
    bleed_gpu_.set(bleeding_);
    send_density();
    set_contacts(contacts, preset);
    take_wounds();
}

void Body::set_contacts(std::span<const ToolContact> contacts, const Preset& preset) {
    cautery_.set(contacts, preset.cautery);
    bleed_->set_clearing(contacts, bleeding_);
}

void Body::take_wounds() {
    bleed_->set(cautery_.wounds(), bleeding_);
    wounds_version_ = cautery_.wounds_version();
}

/// Values of all vertices from those of the organ as the host has it: midpoints stay midway.
std::span<const glm::vec3> Body::follow(std::span<const glm::vec3> given, std::vector<glm::vec3>& all) const {
    all.assign(given.begin(), given.end());
    for (const glm::uvec2& between : midpoints()) all.push_back(0.5f * (all[between.x] + all[between.y]));
    return all;
}

void Body::set_shape(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals) {
    assert((positions.size() == given_vertices() || positions.size() == vertices_) &&
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
}

/// Of the vertices that splitting has made: no facet shows that the organ as it was given has not.
void Body::set_normals_midway() {
    for (std::size_t i = 0; i < midpoints().size(); ++i) {
        const glm::vec3 sum = normals_[midpoints()[i].x] + normals_[midpoints()[i].y];
        const float length = glm::length(sum);
        normals_[given_vertices() + i] = length > 1e-6f ? sum / length : normals_[midpoints()[i].x];
    }
}

void Body::set_overlay(Overlay overlay) {
    overlay_ = overlay;
    organ_gpu_.set_overlay(overlay);
    send_density();
}

/// Densities are sent only while they are looked at, and once.
void Body::send_density() {
    if ((overlay_ != Overlay::vessels && overlay_ != Overlay::fat) || sent_density_ == tissue_.version()) return;
    sent_density_ = tissue_.version();
    std::vector<render::DensityPicture> pictures(tissue_.images());
    for (std::size_t i = 0; i < pictures.size(); ++i)
        if (const bleeding::DensityMap* map = tissue_.map(static_cast<int>(i)))
            pictures[i] = {.size = map->size(), .values = map->values()};
    organ_gpu_.send_density(pictures, tissue_.vertex_values());
}

/// `origin` for all vertices: a midpoint was the former one between the same two, if their edge was there.
std::vector<std::uint32_t> Body::sources_of(const Body& former, std::span<const std::uint32_t> origin) const {
    std::vector<std::uint32_t> sources(origin.begin(), origin.end());
    if (sources.size() == vertices_) return sources;
    const auto edge = [](std::uint32_t a, std::uint32_t b) {
        return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    };
    std::unordered_map<std::uint64_t, std::uint32_t> known;
    auto next = static_cast<std::uint32_t>(former.given_vertices());
    for (const glm::uvec2& between : former.midpoints()) known.emplace(edge(between.x, between.y), next++);
    for (const glm::uvec2& between : midpoints()) {
        const auto found = known.find(edge(sources[between.x], sources[between.y]));
        sources.push_back(found == known.end() ? gone : found->second);
    }
    return sources;
}

void Body::inherit(const Body& former, std::span<const std::uint32_t> origin, double time) {
    std::vector<glm::vec2> kept(surface().positions.size(), glm::vec2(bleeding::BleedField::none, 0.0f));
    const std::span<const glm::vec2> values = former.bleed_->values();
    const std::vector<std::uint32_t> sources = sources_of(former, origin);
    for (std::size_t v = 0; v < sources.size(); ++v) {
        if (sources[v] >= values.size()) continue;
        glm::vec2& at = kept[surface().weld[v]];
        if (values[sources[v]].x > std::max(at.x, former.bleed_->dry())) at = values[sources[v]];
    }
    bleed_->keep(std::move(kept), time);
}

std::size_t Body::seek(double time) noexcept {
    cautery_.update(time);
    if (wounds_version_ != cautery_.wounds_version()) take_wounds();
    bleed_->update(time);
    const std::span<const VertexRun> bled = bleed_->changed().take(), marked = cautery_.changed().take();
    touch(bled, [&](std::uint32_t v) { return bleed_->values()[v].x > bleed_->dry(); });
    touch(marked, [&](std::uint32_t v) { return cautery_.marks()[v] != glm::vec2(0.0f); });
    return bleed_gpu_.send(bleed_->values(), bled) + organ_gpu_.send_marks(cautery_.marks(), marked);
}

/// Once touched, a triangle counts for good: blood and time go to and fro.
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
    bleed_gpu_.bind();
    organ_gpu_.draw(glm::mat4(1.0f), &touched_);
}

}  // namespace lapfx
