#include "simulation.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "inputs.h"
#include "smoke/plume.h"

namespace lapfx {

namespace {

/// For each vertex of the new organ, the vertex of the previous one that it was, or a number beyond all. `origin` has
/// only the vertices that the host gave; a midpoint was the previous midpoint between the same two vertices, if their
/// edge was split.
std::vector<std::uint32_t> sources_of(const Foundation& former, const Foundation& now,
                                      std::span<const std::uint32_t> origin) {
    constexpr std::uint32_t gone = 0xffffffff;
    std::vector<std::uint32_t> sources(origin.begin(), origin.end());
    if (sources.size() == now.vertices()) return sources;
    const auto edge = [](std::uint32_t a, std::uint32_t b) {
        return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    };
    std::unordered_map<std::uint64_t, std::uint32_t> known;
    auto next = static_cast<std::uint32_t>(former.given_vertices());
    for (const glm::uvec2& between : former.unsplit.midpoints) known.emplace(edge(between.x, between.y), next++);
    for (const glm::uvec2& between : now.unsplit.midpoints) {
        const auto found = known.find(edge(sources[between.x], sources[between.y]));
        sources.push_back(found == known.end() ? gone : found->second);
    }
    return sources;
}

}  // namespace

Simulation::Tissue::Tissue(std::shared_ptr<const Foundation> of, const glm::dvec3& down)
    : foundation(std::move(of)),
      density(foundation->tissue),
      bleed(std::in_place, foundation->surface, down),
      cautery(foundation->surface, [this](const glm::dvec3& place) { return density.wound_strength(place); }),
      burns([this](const glm::dvec3& place) { return cautery::touches(foundation->surface, place); },
            [this](const glm::dvec3& place) { return density.fat(place); }) {}

Simulation::Simulation(std::shared_ptr<const Foundation> foundation, const glm::dvec3& down)
    : down_(down), tissue_(std::make_unique<Tissue>(std::move(foundation), down)) {}

void Simulation::put(const Preset& preset) {
    if (!(preset.vessels == preset_.vessels)) {
        tissue_->cautery.strengths_changed();
        tissue_->burns.clear();
    }
    tissue_->density.set(preset.vessels);
    preset_ = preset;
}

void Simulation::put(const Curves& curves) {
    bleeding_factor_ = FactorCurve(curves.bleeding_strength);
    emission_factor_ = FactorCurve(curves.emission);
    tissue_->bleed->set_strength(bleeding_factor_);
    log_.set_power(curves.cautery_power);
}

void Simulation::update_log() {
    if (recorder_.changed()) log_.update(recorder_.contacts(), recorder_.take_same());
}

std::span<const ToolContact> Simulation::placed(std::span<const ToolContact> contacts) {
    const std::optional<organ::Plate>& plate = tissue_->foundation->plate;
    if (!plate) return contacts;
    placed_.assign(contacts.begin(), contacts.end());
    for (ToolContact& contact : placed_) {
        contact.position = plate->below(contact.position);
        contact.to = plate->below(contact.to);
    }
    return placed_;
}

void Simulation::set(const Preset& preset, std::span<const ToolContact> contacts, const Curves& curves) {
    put(preset);
    put(curves);
    recorder_.set(placed(contacts));
    update_log();
    take_pieces();
    take_wounds();
}

void Simulation::set_preset(const Preset& preset) {
    put(preset);
    take_pieces();
    take_wounds();
}

void Simulation::set_curves(const Curves& curves) {
    put(curves);
    take_pieces();
}

void Simulation::set_down(const glm::dvec3& down) {
    down_ = down;
    bleeding::KeptBlood kept = tissue_->bleed->take_kept();
    tissue_->bleed.emplace(tissue_->foundation->surface, down);
    tissue_->bleed->set_strength(bleeding_factor_);
    take_pieces();
    take_wounds();
    tissue_->bleed->keep(std::move(kept));
    tissue_->bleed->update(time_);
}

void Simulation::set_contacts(std::span<const ToolContact> contacts) {
    recorder_.set(placed(contacts));
    take_samples();
}

void Simulation::take_samples() {
    if (!recorder_.changed()) return;
    update_log();
    take_pieces();
}

void Simulation::set_surface(std::shared_ptr<const Foundation> foundation, std::span<const std::uint32_t> origin) {
    auto tissue = std::make_unique<Tissue>(std::move(foundation), down_);
    const bleeding::BleedField& former = *tissue_->bleed;
    std::vector<glm::vec2> kept(tissue->foundation->surface.positions.size(),
                                glm::vec2(bleeding::BleedField::none, 0.0f));
    const std::vector<std::uint32_t> sources = sources_of(*tissue_->foundation, *tissue->foundation, origin);
    for (std::size_t v = 0; v < sources.size(); ++v) {
        if (sources[v] >= former.values().size()) continue;
        const glm::vec2 value = former.values()[sources[v]];
        glm::vec2& at = kept[tissue->foundation->surface.weld[v]];
        if (value.x > std::max(at.x, former.dry())) at = value;
    }
    tissue->bleed->set_strength(bleeding_factor_);
    tissue->density.set(preset_.vessels);
    tissue_ = std::move(tissue);
    take_pieces();
    take_wounds();
    tissue_->bleed->keep({.values = std::move(kept), .time = time_});
}

/// Brings the tissue up to date with what was written to the log since the last call.
void Simulation::take_pieces() {
    tissue_->cautery.set(log_, preset_.cautery);
    tissue_->bleed->set_clearing(log_, preset_.bleeding);
    smoke::BurnList::Same same = tissue_->burns.update(log_);
    if (fat_gain_ != preset_.smoke.plume.fat_gain) same.parts = 0;
    fat_gain_ = preset_.smoke.plume.fat_gain;
    emissions_.resize(same.parts);
    for (const smoke::BurnPart& part : tissue_->burns.parts().subspan(same.parts))
        emissions_.push_back({.start = part.contact.time,
                              .end = part.contact.end(),
                              .power = smoke::emission(part.contact, part.fat, preset_.smoke.plume)});
    haze_.set(emissions_, tissue_->burns.suctions(), preset_.smoke.haze, emission_factor_, same.parts, same.suctions);
}

void Simulation::take_wounds() {
    tissue_->bleed->set(tissue_->cautery.wounds(), preset_.bleeding);
    tissue_->wounds_version = tissue_->cautery.wounds_version();
}

void Simulation::seek(double time) noexcept {
    time_ = time;
    tissue_->cautery.update(time);
    if (tissue_->wounds_version != tissue_->cautery.wounds_version()) take_wounds();
    tissue_->bleed->update(time);
}

SmokeAmounts Simulation::smoke(double time) const noexcept {
    if (preset_.smoke.clips.empty()) return {};
    return {.haze = haze_.density(time), .emission = haze_.emission(recorder_.acting(time))};
}

Amounts Simulation::amounts() const noexcept {
    const SmokeAmounts smoke = this->smoke(time_);
    const bleeding::BleedField& bleed = *tissue_->bleed;
    const bleeding::BloodAmount blood = bleed.amount();
    return {.blood_area = blood.area,
            .blood_volume = blood.volume,
            .wounds = static_cast<int>(bleed.wounds().size()) - waiting_wounds(bleed.wounds()),
            .bleeding_wounds = bleed.bleeding_wounds(),
            .left_out_wounds = static_cast<int>(tissue_->cautery.left_out()),
            .lost_samples = recorder_.dropped(),
            .haze = smoke.haze,
            .emission = smoke.emission,
            .burnt_area = tissue_->cautery.burnt_area()};
}

}  // namespace lapfx
