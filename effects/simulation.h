// What happens on an organ, without OpenGL: the tool's log, the tissue, heat, wounds, blood, burns and haze, over time.
// Effects draws it and AmountsModel asks it for amounts, so both agree to the last bit.
//
//     Simulation simulation(foundation, down);
//     simulation.set_parameters(preset, changed);  // redo bits; or without them: it compares
//     simulation.set_contacts(contacts);           // or take_samples(queue, moved) of a tool
//     simulation.seek(time);                       // any time, any order
//     draw(simulation.blood());
//
// Callers check presets and directions first (inputs.h). Lengths mm, times s. One thread at a time.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "bleeding/bleeding.h"
#include "bleeding/tissue_density.h"
#include "cautery/cautery.h"
#include "foundation.h"
#include "lapfx/amounts.h"
#include "lapfx/curves.h"
#include "lapfx/preset.h"
#include "lapfx/tool_queue.h"
#include "organ/moved_surface.h"
#include "smoke/burns.h"
#include "smoke/haze.h"
#include "tool/log.h"
#include "tool/recorder.h"

namespace lapfx {

/// What the simulation takes of a preset: numbers alone. It does not know the clips.
struct SimulationParameters {
    SimulationParameters() = default;
    SimulationParameters(const Preset& preset)
        : bleeding(preset.bleeding),
          vessels(preset.vessels),
          cautery(preset.cautery),
          plume(preset.smoke.plume),
          haze(preset.smoke.haze) {}

    BleedingParameters bleeding;
    VesselParameters vessels;
    CauteryParameters cautery;
    PlumeParameters plume;
    HazeParameters haze;
};
/// The redo bits (lapfx/parameter.h) of what differs.
unsigned difference(const SimulationParameters& a, const SimulationParameters& b);

class Simulation {
  public:
    /// `down`: unit, organ space.
    Simulation(std::shared_ptr<const Foundation> foundation, const glm::dvec3& down);
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    /// Each change takes effect immediately, also on what has already happened; amounts of blood and wounds follow at
    /// the next seek().
    void set(const SimulationParameters& parameters, std::span<const ToolContact> contacts, const Curves& curves);
    /// `changed`: the redo bits of what differs from the parameters before; too many are right, too few are not.
    void set_parameters(const SimulationParameters& parameters, unsigned changed);
    void set_parameters(const SimulationParameters& parameters);
    void set_curves(const Curves& curves);
    void set_down(const glm::dvec3& down);
    /// Replaces all contacts. On a plate they are where the camera sees them: an organ's own are not at its depth.
    void set_contacts(std::span<const ToolContact> contacts);
    /// Takes what a haptic thread has pushed. A tool touches the organ as it is moved, contacts refer to its shape at
    /// rest.
    void take_samples(ToolQueue& queue, const MovedSurface& moved);
    /// Cuts the organ (Effects::set_topology). `origin` has an entry for every vertex of the new organ, as there.
    void set_surface(std::shared_ptr<const Foundation> foundation, std::span<const std::uint32_t> origin);

    void seek(double time) noexcept;

    double time() const { return time_; }
    /// Smoke is that of any preset, but one without clips makes none: their owner says `smokes`.
    Amounts amounts(bool smokes = true) const noexcept;
    /// Of any time, without seeking it.
    SmokeAmounts smoke(double time, bool smokes = true) const noexcept;
    /// Whether a tip at a place of the rest shape touches tissue.
    bool touches(const glm::dvec3& place) const { return cautery::touches(tissue_->foundation->surface, place); }

    const SimulationParameters& parameters() const { return parameters_; }
    const glm::dvec3& down() const { return down_; }
    std::span<const ToolContact> contacts() const { return recorder_.contacts(); }
    const Foundation& foundation() const { return *tissue_->foundation; }
    const bleeding::TissueDensity& density() const { return tissue_->density; }
    const FactorCurve& emission_factor() const { return emission_factor_; }
    const smoke::BurnList& burns() const { return tissue_->burns; }
    bleeding::Bleeding& blood() { return *tissue_->blood; }
    const bleeding::Bleeding& blood() const { return *tissue_->blood; }
    cautery::Cautery& cautery() { return tissue_->cautery; }

  private:
    /// Everything that depends on the surface.
    struct Tissue {
        Tissue(std::shared_ptr<const Foundation> of, bleeding::Model model, const glm::dvec3& down);
        Tissue(const Tissue&) = delete;

        std::shared_ptr<const Foundation> foundation;
        bleeding::TissueDensity density;
        std::unique_ptr<bleeding::Bleeding> blood;
        cautery::Cautery cautery;
        smoke::BurnList burns;
        std::uint64_t wounds_version = 0;
    };
    std::span<const ToolContact> placed(std::span<const ToolContact> contacts);
    void put(const SimulationParameters& parameters, unsigned changed);
    void put(const Curves& curves);
    unsigned changed_to(const SimulationParameters& parameters) const;
    void renew_blood();
    void follow_log();
    void take_pieces(unsigned changed = 0);
    void take_wounds();

    glm::dvec3 down_;
    SimulationParameters parameters_;
    bool any_set_ = false;  // they have been set by somebody
    std::vector<ToolContact> placed_;
    tool::Recorder recorder_;
    tool::Log log_;
    FactorCurve bleeding_factor_, emission_factor_;
    std::unique_ptr<Tissue> tissue_;
    std::vector<smoke::Emission> emissions_;  // each part of the burns has one
    smoke::HazeCurve haze_;
    double time_ = 0.0;
};

}  // namespace lapfx
