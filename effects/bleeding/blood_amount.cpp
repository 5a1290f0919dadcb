#include "bleeding/blood_amount.h"

#include <algorithm>

#include "organ/above_zero.h"

namespace lapfx::bleeding {

void AmountSum::mark(std::uint32_t vertex) noexcept {
    if (parts_.empty()) parts_.resize(surface_.triangles.size());
    for (const std::uint32_t t : surface_.triangles_at(vertex)) {
        if (state_[t] == marked) continue;
        if (state_[t] == untouched) touched_.push_back(t);
        state_[t] = marked;
        marked_.push_back(t);
    }
}

void AmountSum::mark_all() noexcept {
    for (const std::uint32_t t : touched_) state_[t] = marked;
    marked_ = touched_;
}

void AmountSum::clear() noexcept {
    for (const std::uint32_t t : touched_) {
        state_[t] = untouched;
        parts_[t] = {};
    }
    touched_.clear();
    marked_.clear();
    sum_ = {};
}

BloodAmount AmountSum::measure(std::span<const glm::vec2> values, const BleedingParameters& parameters) noexcept {
    const auto above = [&](std::uint32_t v) { return values[v].x - parameters.threshold; };
    for (const std::uint32_t t : marked_) {
        const auto& c = surface_.triangles[t];
        const organ::AboveZero wet = organ::above_zero(above(c[0]), above(c[1]), above(c[2]));
        const double area = wet.share * surface_.area(t);
        const double depth = parameters.thickness * std::min(1.0, wet.mean / parameters.deep_at);
        const Part now{.area = organ::whole_units(area, unit), .volume = organ::whole_units(area * depth, unit)};
        sum_.area += now.area - parts_[t].area;
        sum_.volume += now.volume - parts_[t].volume;
        parts_[t] = now;
        state_[t] = measured;
    }
    marked_.clear();
    return {.area = static_cast<double>(sum_.area) * unit, .volume = static_cast<double>(sum_.volume) * unit};
}

}  // namespace lapfx::bleeding
