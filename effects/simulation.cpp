#include "simulation.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "inputs.h"
#include "lapfx/authoring/compare.h"
#include "smoke/plume.h"

namespace lapfx {

namespace {

constexpr unsigned all_bits = ~0U;

/// For each vertex of the new organ, the vertex of the previous one that it was, or Bleeding::gone. `origin` has only
/// the vertices that the host gave; a midpoint was the previous midpoint between the same two vertices, if their edge
/// was split.
std::vector<std::uint32_t> sources_of(const Foundation& former, const Foundation& now,
                                      std::span<const std::uint32_t> origin) {
    constexpr std::uint32_t gone = bleeding::Bleeding::gone;
    std::vector<std::uint32_t> sources(origin.begin(), origin.end());
    for (std::uint32_t& source : sources)
        if (source >= former.vertices()) source = gone;
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

Simulation::Tissue::Tissue(std::shared_ptr<const Foundation> of, bleeding::Model model, const glm::dvec3& down)
    : foundation(std::move(of)),
      density(foundation->tissue),
      blood(bleeding::make_bleeding(model, foundation->surface, down)),
      cautery(foundation->surface, [this](const glm::dvec3& place) { return density.wound_strength(place); }),
      burns([this](const glm::dvec3& place) { return cautery::touches(foundation->surface, place); },
            [this](const glm::dvec3& place) { return density.fat(place); }) {}

Simulation::Simulation(std::shared_ptr<const Foundation> foundation, const glm::dvec3& down)
    : down_(down),
      tissue_(std::make_unique<Tissue>(std::move(foundation), bleeding::model_of(parameters_.bleeding), down)) {}

unsigned difference(const SimulationParameters& a, const SimulationParameters& b) {
    static const Table &smoke = *preset_table().find("smoke"), &bleeding = *preset_table().find("bleeding"),
                       &vessels = *preset_table().find("vessels"), &cautery = *preset_table().find("cautery"),
                       &plume = *smoke.find("plume"), &haze = *smoke.find("haze");
    return difference(bleeding, &a.bleeding, &b.bleeding) | difference(vessels, &a.vessels, &b.vessels) |
           difference(cautery, &a.cautery, &b.cautery) | difference(plume, &a.plume, &b.plume) |
           difference(haze, &a.haze, &b.haze);
}

void Simulation::put(const SimulationParameters& parameters, unsigned changed) {
    if (changed & redo::densities) {
        tissue_->density.set(parameters.vessels);  // may throw
        tissue_->burns.clear();
        changed |= redo::heat;  // wounds are as strong as vessels are dense
    }
    parameters_ = parameters;
    any_set_ = true;
    tissue_->cautery.set_parameters(parameters_.cautery, changed);
    if (bleeding::model_of(parameters_.bleeding) == tissue_->blood->model())
        tissue_->blood->set_parameters(parameters_.bleeding, changed);
    else
        renew_blood();
    if (changed & redo::haze) haze_.set_parameters(parameters_.haze);
}

void Simulation::put(const Curves& curves) {
    bleeding_factor_ = FactorCurve(curves.bleeding_strength);
    emission_factor_ = FactorCurve(curves.emission);
    tissue_->blood->set_strength(bleeding_factor_);
    haze_.set_factor(emission_factor_);
    log_.set_power(curves.cautery_power);
}

/// Another gravity or model needs it. What the tool has done is to be taken again.
void Simulation::renew_blood() {
    auto renewed =
        bleeding::make_bleeding(bleeding::model_of(parameters_.bleeding), tissue_->foundation->surface, down_);
    renewed->set_parameters(parameters_.bleeding, all_bits);
    renewed->set_strength(bleeding_factor_);
    renewed->replace(*tissue_->blood);
    tissue_->blood = std::move(renewed);
}

/// Heat, clearing, burns and haze follow what was added to the log.
void Simulation::follow_log() {
    if (!recorder_.changed()) return;
    log_.update(recorder_.contacts(), recorder_.take_same());
    take_pieces();
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

/// Bits of what differs from the parameters in use. At first nothing has been made of any.
unsigned Simulation::changed_to(const SimulationParameters& parameters) const {
    return any_set_ ? difference(parameters_, parameters) : all_bits;
}

void Simulation::set(const SimulationParameters& parameters, std::span<const ToolContact> contacts,
                     const Curves& curves) {
    const unsigned changed = changed_to(parameters);
    put(parameters, changed);
    put(curves);
    recorder_.set(placed(contacts));
    if (recorder_.changed()) log_.update(recorder_.contacts(), recorder_.take_same());
    take_pieces(changed);
    take_wounds();
}

void Simulation::set_parameters(const SimulationParameters& parameters, unsigned changed) {
    if (!any_set_) changed = all_bits;
    put(parameters, changed);
    take_pieces(changed);
    take_wounds();
}

void Simulation::set_parameters(const SimulationParameters& parameters) {
    set_parameters(parameters, changed_to(parameters));
}

void Simulation::set_curves(const Curves& curves) {
    put(curves);
    take_pieces();
}

void Simulation::set_down(const glm::dvec3& down) {
    down_ = down;
    renew_blood();
    take_pieces();
    take_wounds();
    tissue_->blood->update(time_);
}

void Simulation::set_contacts(std::span<const ToolContact> contacts) {
    recorder_.set(placed(contacts));
    follow_log();
}

void Simulation::take_samples(ToolQueue& queue, const MovedSurface& moved) {
    ToolSample sample;
    // Takes no more samples than there were at the beginning: the haptic thread continues.
    for (std::size_t i = 0; i < queue.capacity() && queue.pop(sample); ++i) {
        if (sample.touching) sample.position = moved.to_rest(sample.position);
        recorder_.add(sample);
    }
    follow_log();
}

void Simulation::set_surface(std::shared_ptr<const Foundation> foundation, std::span<const std::uint32_t> origin) {
    auto tissue = std::make_unique<Tissue>(std::move(foundation), tissue_->blood->model(), down_);
    tissue->blood->set_parameters(parameters_.bleeding, all_bits);
    tissue->blood->set_strength(bleeding_factor_);
    tissue->blood->keep(*tissue_->blood, sources_of(*tissue_->foundation, *tissue->foundation, origin), time_);
    tissue->cautery.set_parameters(parameters_.cautery, all_bits);
    tissue->density.set(parameters_.vessels);
    tissue_ = std::move(tissue);
    take_pieces();
    take_wounds();
}

/// Brings the tissue up to date with what was written to the log since the last call.
void Simulation::take_pieces(unsigned changed) {
    tissue_->cautery.set(log_);
    tissue_->blood->set_clearing(log_);
    smoke::BurnList::Same same = tissue_->burns.update(log_);
    if (changed & redo::emission) same.parts = 0;
    emissions_.resize(same.parts);
    for (const smoke::BurnPart& part : tissue_->burns.parts().subspan(same.parts))
        emissions_.push_back({.start = part.contact.time,
                              .end = part.contact.end(),
                              .power = smoke::emission(part.contact, part.fat, parameters_.plume)});
    haze_.set(emissions_, tissue_->burns.suctions(), same.parts, same.suctions);
}

void Simulation::take_wounds() {
    tissue_->blood->set_wounds(tissue_->cautery.wounds());
    tissue_->wounds_version = tissue_->cautery.wounds_version();
}

void Simulation::seek(double time) noexcept {
    time_ = time;
    tissue_->cautery.update(time);
    if (tissue_->wounds_version != tissue_->cautery.wounds_version()) take_wounds();
    tissue_->blood->update(time);
}

SmokeAmounts Simulation::smoke(double time, bool smokes) const noexcept {
    if (!smokes) return {};
    return {.haze = haze_.density(time), .emission = haze_.emission(recorder_.acting(time))};
}

Amounts Simulation::amounts(bool smokes) const noexcept {
    const bleeding::BloodAmount blood = tissue_->blood->amount();
    const std::span<const WoundStatus> wounds = tissue_->blood->wounds();
    Amounts amounts{.blood_area = blood.area,
                    .blood_volume = blood.volume,
                    .wounds = static_cast<int>(wounds.size()) - waiting_wounds(wounds),
                    .bleeding_wounds = bleeding::bleeding_wounds(wounds),
                    .left_out_wounds = static_cast<int>(tissue_->cautery.left_out()),
                    .lost_samples = recorder_.dropped(),
                    .burnt_area = tissue_->cautery.burnt_area()};
    smoke(time_, smokes).put_into(amounts);
    return amounts;
}

}  // namespace lapfx
