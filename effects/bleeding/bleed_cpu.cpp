#include "bleeding/bleed_cpu.h"

#include <algorithm>
#include <utility>

#include "bleeding/front_cpu.h"
#include "bleeding/wound_cpu.h"

namespace lapfx::bleeding {

namespace {

/// How far along the surface blood can come: noise moves its edge by noise_strength at most, and downhill it travels
/// 1 / (1 - bias) times as far.
double reach(const BleedingParameters& parameters) {
    return (parameters.max_extent + parameters.noise_strength) / (1.0 - std::min(parameters.gravity_bias, 0.95));
}

/// Bleed value `beyond` mm outside the reach of a source value, below 0: noise may show blood there. While the source
/// value is smaller than the noise the value falls faster, so that a wound never begins as a blob of noise.
float outside(float beyond, float source, float noise_strength) {
    return -beyond * std::max(1.0f, noise_strength / source);
}

double longest_edge(const Surface& surface) {
    double longest = 0.0;
    const auto& p = surface.positions;
    for (const auto& c : surface.triangles)
        for (int i = 0; i < 3; ++i) longest = std::max(longest, glm::distance(p[c[i]], p[c[(i + 1) % 3]]));
    return longest;
}

/// Share of a triangle where a value linear in it is above zero.
double share_above_zero(double a, double b, double c) {
    double v[3] = {a, b, c};
    std::sort(v, v + 3);
    if (v[2] <= 0.0) return 0.0;  // first: three zeros are none, blood shows above the threshold
    if (v[0] >= 0.0) return 1.0;
    if (v[1] <= 0.0) return v[2] * v[2] / ((v[2] - v[0]) * (v[2] - v[1]));
    return 1.0 - v[0] * v[0] / ((v[0] - v[1]) * (v[0] - v[2]));
}

}  // namespace

BleedField::BleedField(const Surface& surface, glm::dvec3 down)
    : surface_(surface),
      down_(down),
      longest_edge_(longest_edge(surface)),
      surface_values_(surface.positions.size(), driest()),
      values_(surface.weld.size(), glm::vec2(driest(), 0.0f)) {
    copies_of_.resize(surface.positions.size() + 1);
    for (const std::uint32_t v : surface.weld) ++copies_of_[v + 1];
    for (std::size_t i = 1; i < copies_of_.size(); ++i) copies_of_[i] += copies_of_[i - 1];
    copies_.resize(surface.weld.size());
    std::vector<std::uint32_t> next(copies_of_.begin(), copies_of_.end() - 1);
    for (std::uint32_t i = 0; i < surface.weld.size(); ++i) copies_[next[surface.weld[i]]++] = i;
}

/// Gravity at most doubles a distance, so no neighbour of what noise can reach is drier.
float BleedField::driest() const {
    return static_cast<float>(-2.0 * longest_edge_ - parameters_.noise_strength);
}

BleedField::Spread BleedField::spread_from(glm::dvec3 position, double limit) const {
    Spread spread{.position = position, .limit = limit, .vertices = {}, .distances = {}, .drops = {}};
    const std::vector<Reached> reached = march(surface_, position, limit);
    const glm::dvec3 start = surface_.closest_point(position).position;
    for (const Reached& r : reached) {
        spread.vertices.push_back(r.vertex);
        spread.distances.push_back(static_cast<float>(r.distance));
        spread.drops.push_back(static_cast<float>(glm::dot(surface_.positions[r.vertex] - start, down_)));
    }
    return spread;
}

void BleedField::set(std::span<const Wound> wounds, const BleedingParameters& parameters) {
    const double limit = reach(parameters) + longest_edge_;  // one vertex more, so that the edge is interpolated
    std::vector<Spread> spreads;
    for (const Wound& wound : wounds) {
        const auto known = std::find_if(spreads_.begin(), spreads_.end(), [&](const Spread& s) {
            return s.position == wound.position && s.limit == limit;
        });
        spreads.push_back(known != spreads_.end() ? *known : spread_from(wound.position, limit));
    }
    spreads_ = std::move(spreads);
    wounds_.assign(wounds.begin(), wounds.end());
    parameters_ = parameters;
    if (const float dry = driest(); dry != dry_) {
        std::fill(surface_values_.begin(), surface_values_.end(), dry);
        std::fill(values_.begin(), values_.end(), glm::vec2(dry, 0.0f));
        dry_ = dry;
        told_ = false;
    }
    sources_.assign(wounds.size(), 0.0);
    // What was touched before stays in the list, so that old blood is wiped.
    for (const Spread& spread : spreads_)
        touched_.insert(touched_.end(), spread.vertices.begin(), spread.vertices.end());
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    stale_ = true;
}

Dirty BleedField::update(double time) noexcept {
    bool changed = stale_;
    for (std::size_t w = 0; w < wounds_.size(); ++w) {
        const double source = source_value(wounds_[w], parameters_, time);
        changed = changed || source != sources_[w];
        sources_[w] = source;
    }
    if (!changed) return {};
    stale_ = false;
    for (const std::uint32_t v : touched_) surface_values_[v] = dry_;
    for (std::size_t w = 0; w < wounds_.size(); ++w) {
        const Spread& spread = spreads_[w];
        const auto source = static_cast<float>(sources_[w]);
        const auto bias = static_cast<float>(parameters_.gravity_bias);
        const auto noise = static_cast<float>(parameters_.noise_strength);
        if (source <= 0.0f) continue;
        for (std::size_t i = 0; i < spread.vertices.size(); ++i) {
            float& value = surface_values_[spread.vertices[i]];
            const float inside = source - (spread.distances[i] - bias * spread.drops[i]);
            value = std::max(value, inside >= 0.0f ? inside : outside(-inside, source, noise));
        }
    }
    const Dirty dirty = write_values();
    return std::exchange(told_, true) ? dirty : Dirty{.begin = 0, .end = static_cast<std::uint32_t>(values_.size())};
}

Dirty BleedField::write_values() noexcept {
    Dirty dirty{.begin = static_cast<std::uint32_t>(values_.size()), .end = 0};
    for (const std::uint32_t v : touched_)
        for (std::uint32_t i = copies_of_[v]; i < copies_of_[v + 1]; ++i) {
            const std::uint32_t copy = copies_[i];
            if (values_[copy].x == surface_values_[v]) continue;
            values_[copy].x = surface_values_[v];
            dirty.begin = std::min(dirty.begin, copy);
            dirty.end = std::max(dirty.end, copy + 1);
        }
    return dirty;
}

double BleedField::area() const noexcept {
    double area = 0.0;
    const auto& p = surface_.positions;
    const auto above = [&](std::uint32_t v) { return surface_values_[v] - parameters_.threshold; };
    for (const std::uint32_t v : touched_)
        for (const std::uint32_t t : surface_.triangles_at(v)) {
            const auto& c = surface_.triangles[t];
            const double whole = 0.5 * glm::length(glm::cross(p[c[1]] - p[c[0]], p[c[2]] - p[c[0]]));
            // Each triangle is met once per touched corner; count it at its first touched corner only.
            const auto first = [&] {
                for (int i = 0; i < 3; ++i)
                    if (std::binary_search(touched_.begin(), touched_.end(), c[i])) return c[i];
                return v;
            };
            if (first() == v) area += whole * share_above_zero(above(c[0]), above(c[1]), above(c[2]));
        }
    return area;
}

int BleedField::growing(double time) const noexcept {
    return static_cast<int>(
        std::count_if(wounds_.begin(), wounds_.end(), [&](const Wound& w) { return grows(w, parameters_, time); }));
}

}  // namespace lapfx::bleeding
