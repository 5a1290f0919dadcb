// The model `spread` of bleeding.h.
//
// Bleed value per vertex: b(x, t) = max over wounds of s_w(t) - d_w(x), mm; 0 and below is dry (the paper's animation
// variable). b continues below 0, as far as noise can move the edge and one triangle more. If the vertices cut it off
// at 0, the edge would move outwards, farther on coarser meshes, and noise could only remove blood. Each vertex also
// has a value for how far its blood has clotted.
//
// Where suction or irrigation has cleared a place, the earlier blood is capped (clearing.h) and later flow is added:
// the place fills again from the wound outwards.
//
// Work is proportional to what changes. A wound that has clotted, or whose blood covers its whole extent, is settled:
// its values are kept in a separate layer, and it is examined again only when the tool reaches its blood; not even then
// if it has clotted, since such wounds are one layer (ended_blood.h). While blood grows, only growing wounds are
// written; where blood is removed or draws together, only the wounds that reach there, and a wound that only fills
// again what was cleared is written where something was.
// One thread at a time.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "bleeding/bleeding.h"
#include "bleeding/cleared_places.h"
#include "bleeding/clearing.h"
#include "bleeding/ended_blood.h"
#include "bleeding/front.h"
#include "bleeding/region.h"
#include "bleeding/wound.h"
#include "organ/point_set.h"

namespace lapfx::bleeding {

/// Blood of an organ before it was cut.
struct KeptBlood {
    std::vector<glm::vec2> values;  ///< per surface vertex, bleed value and clot; BleedField::none where there is none
    double time = 0.0;              ///< time from which it exists, s
};

class BleedField final : public Bleeding {
  public:
    static constexpr float none = -1e30f;  ///< for keep(): a vertex where nothing is kept

    /// Keeps a reference to `surface`. `down`: unit, organ space.
    BleedField(const Surface& surface, glm::dvec3 down);

    Model model() const override { return Model::spread; }

    // Values depend, to the last bit, only on what is set and on the time, not on what was set before.

    /// With another gravity_bias, crease_bias or bridge_gap all fronts run again.
    void set_parameters(const BleedingParameters& parameters, unsigned changed) override;
    /// Fronts of wounds that stay at their place are kept.
    void set_wounds(std::span<const Wound> wounds) override;
    /// Both, for callers who do not know what has changed: it is found here.
    void set(std::span<const Wound> wounds, const BleedingParameters& parameters);
    void set_clearing(const tool::Log& log) override;
    void set_strength(const FactorCurve& strength) override;
    void replace(Bleeding& former) override;
    void keep(const Bleeding& former, std::span<const std::uint32_t> sources, double time) override;
    /// Blood that stays until it is cleared, whatever the wounds do. It clots together with the wounds that were open
    /// at its time.
    void keep(KeptBlood kept);

    void update(double time) noexcept override;

    /// Value of places that blood cannot reach, mm: too low for noise to show blood, and high enough that its slope,
    /// which multisampling extends beyond a triangle, does not rise above 0. Changes with noise_strength.
    float dry() const { return dry_; }
    BloodAt at(std::uint32_t vertex) const noexcept override {
        return {.any = values_[vertex].x > dry_, .value = values_[vertex].x, .clot = values_[vertex].y};
    }
    std::span<const glm::vec2> values() const { return values_; }                  ///< per organ vertex: mm; clot 0..1
    std::span<const glm::vec2> surface_values() const { return surface_values_; }  ///< the same per surface vertex
    std::span<const DrawnArray> drawn() const override { return {&drawn_, 1}; }
    ChangedVertices& changed() override { return changed_; }

    BloodAmount amount() const noexcept override;
    std::span<const WoundStatus> wounds() const override { return status_; }

  private:
    using Layer = std::vector<glm::vec2>;  // per surface vertex: bleed value, clot
    /// What is known of a wound besides its record, which is status_[number].
    struct Bleeder {
        std::uint32_t number;
        Front front;
        double source = 0.0;             // mm
        double flowed = 0.0;             // mm, the same without the bound
        double cleared = never_cleared;  // time of the latest clearing that has removed blood of it, s, as written
        float clot = 0.0f;
        // Whether the last look at it changed anything, whether that was more than what fills again, and whether it
        // lowered a value.
        bool writes = false, spreads = false, falls = false;
        bool is_settled = false;
        bool has_ended = false;  // and its blood is in ended_
        std::size_t rings = 0;   // of the front, as written
        Box box{};               // around every place ever written
        std::size_t boxed = 0;   // rings
    };
    class Refills;
    const Wound& wound_of(const Bleeder& bleeder) const { return status_[bleeder.number].wound; }
    void run_again();
    void add_bleeder(const Wound& wound, Front front);
    bool is_clip_on_clotted(const Wound& was, const Wound& now) const noexcept;
    Front new_front(const Wound& wound) { return {room_, metric_of(parameters_), wound.position}; }
    bool has_settled(const Bleeder& bleeder, double time) const noexcept;
    bool refills(const Bleeder& bleeder, double flowed) const noexcept;
    double source_of(const Bleeder& bleeder, double flowed) const noexcept;
    void look(Bleeder& bleeder, double time) noexcept;
    void end_clotted() noexcept;
    void settle_anew(std::uint32_t vertex) noexcept;
    void activate(std::uint32_t bleeder) noexcept;
    void write_anew(double time) noexcept;
    void write_changes(double time) noexcept;
    void unsettle_cleared(double time) noexcept;
    void settle(double time) noexcept;
    bool age_kept(double time) noexcept;
    glm::vec2 kept_at(std::uint32_t vertex) const noexcept;
    void forget() noexcept;
    template <class Visit>
    void for_each_reached(Bleeder& bleeder, Visit visit) noexcept;
    void march(Bleeder& bleeder) noexcept;
    void write(Bleeder& bleeder, Layer& layer) noexcept;
    void write(Bleeder& bleeder, Layer& layer, const Region& within) noexcept;
    void write_refill(Bleeder& bleeder) noexcept;
    std::optional<ClearedPlace> place_at(std::uint32_t vertex) const noexcept;
    bool may_raise(const Bleeder& bleeder, const Reached& at, const ClearedPlace& place,
                   Refills& refills) const noexcept;
    double refilled(const Bleeder& bleeder, double cleared, Refills& refills) const noexcept;
    static float beyond_of(const Bleeder& bleeder, const glm::vec2& there) noexcept;
    void put_value(Bleeder& bleeder, const Reached& at, Layer& layer, Refills& refills) noexcept;
    float value_at(Bleeder& bleeder, const Reached& at, Refills& refills, float beyond, double before) const noexcept;
    void tell(std::uint32_t bleeder, double time) noexcept;
    void publish() noexcept;

    float driest() const noexcept;

    const Surface& surface_;
    BleedingParameters parameters_;
    Strength strength_;    // of parameters_
    double longest_edge_;  // mm
    float dry_;            // driest(): of the members above
    FrontRoom room_;
    Clearing clearing_;
    std::vector<Bleeder> bleeders_;
    std::vector<std::uint32_t> active_;   // bleeders that are not settled
    std::vector<std::uint32_t> clotted_;  // those that have settled by clotting and do not count as ended yet
    double updated_ = 0.0;
    std::vector<WoundStatus> status_;  // per bleeder
    Layer surface_values_;
    Layer settled_values_;           // values of kept blood, and of settled bleeders
    EndedBlood ended_;               // of bleeders that have_ended
    ClearedPlaces places_;           // of surface_values_, in the update that runs
    Region anew_, settled_anew_;     // where surface_values_ and settled_values_ have to be computed again
    std::vector<glm::vec2> values_;  // per organ vertex; always as many
    DrawnArray drawn_{.data = values_.data(), .count = values_.size(), .stride = sizeof(glm::vec2)};
    KeptBlood kept_;  // or empty
    float kept_clot_ = 0.0f;
    bool kept_shown_ = false;
    organ::PointSet touched_;             // vertices that blood has come near
    std::vector<std::uint32_t> written_;  // surface vertices since the last publish, some more than once
    ChangedVertices changed_;
    bool stale_ = true;  // everything has to be written again
    mutable AmountSum amount_;
};

}  // namespace lapfx::bleeding
