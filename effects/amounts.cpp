#include "lapfx/amounts.h"

#include <cmath>

#include "bleeding/bleed_cpu.h"
#include "cautery/cautery.h"
#include "cautery/power.h"
#include "foundation.h"
#include "inputs.h"
#include "organ/refine.h"
#include "smoke/contact_fat.h"
#include "smoke/haze.h"
#include "smoke/touching.h"

namespace lapfx {

struct AmountsModel::State {
    State(std::shared_ptr<const Foundation> shared, glm::dvec3 down)
        : foundation(std::move(shared)),
          tissue(foundation->tissue),
          bleed(foundation->surface, down),
          cautery(foundation->surface, [this](const glm::dvec3& place) { return tissue.wound_strength(place); }) {}

    std::shared_ptr<const Foundation> foundation;
    bleeding::TissueDensity tissue;
    bleeding::BleedField bleed;
    cautery::Cautery cautery;
    cautery::PowerCurve power;
    smoke::Touching touching;
    smoke::ContactFat fat;
    smoke::HazeCurve haze;
    std::vector<smoke::Emission> emissions;
    std::vector<smoke::Suction> suctions;
    Preset preset;
    VesselParameters vessels;  // of the tissue
    std::uint64_t wounds_version = 0;

    void take_wounds() {
        bleed.set(cautery.wounds(), preset.bleeding);
        wounds_version = cautery.wounds_version();
    }
    void set_haze(std::span<const ToolContact> contacts, const FactorCurve& emission) {
        const auto touches = [this](const glm::dvec3& place) { return cautery::touches(foundation->surface, place); };
        const auto fat_at = [this](const glm::dvec3& place) { return tissue.fat(place); };
        const std::span<const ToolContact> burning = touching.update(contacts, touches);
        smoke::list_haze(burning, fat.update(burning, fat_at), preset.smoke.plume, emissions, suctions);
        haze.set(emissions, suctions, preset.smoke.haze, emission);
    }
};

AmountsModel::AmountsModel(const Organ& organ, const AmountsOptions& options)
    : state_(std::make_unique<State>(
          std::make_shared<const Foundation>(organ::FineOrgan(organ).organ(), VesselParameters{}),
          direction_of(options.gravity))) {}
AmountsModel::AmountsModel(const std::shared_ptr<const PreparedOrgan>& organ, const AmountsOptions& options)
    : state_(std::make_unique<State>(organ->state().foundation, direction_of(options.gravity))) {}
AmountsModel::AmountsModel(AmountsModel&&) noexcept = default;
AmountsModel& AmountsModel::operator=(AmountsModel&&) noexcept = default;
AmountsModel::~AmountsModel() = default;

void AmountsModel::set(const Preset& preset, std::span<const ToolContact> contacts, const Curves& curves) {
    require_valid(preset);
    State& s = *state_;
    s.preset = preset;
    if (!(s.vessels == preset.vessels)) {
        s.cautery.strengths_changed();
        s.fat.clear();
    }
    s.vessels = preset.vessels;
    s.tissue.set(preset.vessels);
    if (!(s.power.curve() == FactorCurve(curves.cautery_power, 1.0))) s.power.set(curves.cautery_power);
    const std::span<const ToolContact> acting = s.power.apply(contacts);
    s.cautery.set(acting, preset.cautery);
    s.bleed.set_strength(FactorCurve(curves.bleeding_strength));
    s.bleed.set_clearing(acting, preset.bleeding);
    s.take_wounds();
    s.set_haze(acting, FactorCurve(curves.emission));
}

Amounts AmountsModel::at(double time) noexcept {
    State& s = *state_;
    if (!std::isfinite(time)) time = 0.0;
    s.cautery.update(time);
    if (s.wounds_version != s.cautery.wounds_version()) s.take_wounds();
    s.bleed.update(time);
    const bleeding::BloodAmount blood = s.bleed.amount();
    return {.blood_area = blood.area,
            .blood_volume = blood.volume,
            .wounds = static_cast<int>(s.bleed.wounds().size()) - waiting_wounds(s.bleed.wounds()),
            .bleeding_wounds = s.bleed.bleeding_wounds(),
            .left_out_wounds = static_cast<int>(s.cautery.left_out()),
            .lost_samples = 0,
            .haze = s.preset.smoke.clips.empty() ? 0.0 : s.haze.density(time)};
}

}  // namespace lapfx
