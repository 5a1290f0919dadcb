// Bleed value per vertex: b(x, t) = max over wounds of s_w(t) - d_w(x), mm; 0 and below is dry (the paper's animation
// variable). b is carried on below 0, as far as noise can move the edge and a triangle more: cut off at the vertices,
// the edge would move outwards, the farther the coarser the mesh, and noise could only ever take blood away. Beside it
// goes how far the blood there has clotted.
//
// Where suction or irrigation has cleared a place, what was there is capped (clearing.h), and what has flowed since
// comes on top: the wound fills the place again from the wound outwards.
//
// Work follows what changes: while blood only grows, the wounds that grow are written and nothing else; when nothing
// changes, nothing is done. One thread at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bleeding/clearing.h"
#include "bleeding/front.h"
#include "bleeding/wound.h"
#include "lapfx/preset.h"
#include "lapfx/tool.h"
#include "lapfx/wound.h"
#include "organ/changed_vertices.h"
#include "organ/surface.h"

namespace lapfx::bleeding {

/// Blood on the whole organ.
struct BloodAmount {
    double area = 0.0;  ///< mm2 of surface above the threshold, noise aside
    double volume =
        0.0;  ///< mm3: a layer that rises from its edge to `thickness` where the colour gradient ends (deep_at)
};

class BleedField {
  public:
    static constexpr float none = -1e30f;  ///< for keep(): nothing is kept here

    /// Keeps a reference to `surface`. `down`: unit, organ space.
    BleedField(const Surface& surface, glm::dvec3 down);

    /// Values depend on what is set and on the time, to the last bit, not on what was set before. Fronts of wounds that
    /// stay at their place are kept; a new gravity_bias, crease_bias or bridge_gap lets all run anew.
    void set(std::span<const Wound> wounds, const BleedingParameters& parameters);
    /// Suction and irrigation of the tool, always of the same log.
    void set_clearing(const tool::Log& log, const BleedingParameters& parameters);
    /// The scene's factor on the flow over time (lapfx/curves.h); 1 at first.
    void set_strength(const FactorCurve& strength);
    /// Blood that is there from `time` on, whatever the wounds say, until it is cleared: per surface vertex, bleed
    /// value and clot. It clots on when the wounds have that were open by then.
    void keep(std::vector<glm::vec2> values, double time);

    void update(double time) noexcept;

    /// Value where no blood can come, mm: lower than where noise can show any, and not so low that its slope, carried
    /// on beyond a triangle by multisampling, could come above 0. Changes with noise_strength.
    float dry() const { return dry_; }
    std::span<const glm::vec2> values() const { return values_; }                  ///< per organ vertex: mm; clot 0..1
    std::span<const glm::vec2> surface_values() const { return surface_values_; }  ///< the same per surface vertex
    ChangedVertices& changed() { return changed_; }                                ///< organ vertices; at first, all

    BloodAmount amount() const noexcept;
    int bleeding_wounds() const noexcept;  ///< that bleed (wound.h), as of the last update
    /// Every wound as it was at the last update, in the order in which they were set.
    std::span<const WoundStatus> wounds() const { return status_; }

  private:
    struct Bleeder {
        Wound wound;
        Front front;
        double source = 0.0;             // mm, as written
        double flowed = 0.0;             // mm, the same without the bound
        double cleared = never_cleared;  // s, the latest clearing that has taken blood of it, as written
        float clot = 0.0f;
    };
    struct Touched {
        std::uint32_t triangle;
        float area;  // mm2, at rest
    };
    void replace_wounds(std::span<const Wound> wounds);
    void watch(double time, bool cleared) noexcept;
    bool is_settled(const Bleeder& bleeder, double time) const noexcept;
    bool refills(const Bleeder& bleeder, double flowed) const noexcept;
    double source_of(const Bleeder& bleeder, double flowed) const noexcept;
    bool age_kept(double time) noexcept;
    void wipe() noexcept;
    void forget() noexcept;
    void write(Bleeder& bleeder) noexcept;
    float shown(Bleeder& bleeder, const Reached& at) const noexcept;
    void tell(double time) noexcept;
    void put(std::uint32_t vertex, float value, float clot) noexcept;
    void touch(std::uint32_t vertex) noexcept;
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
    std::vector<std::uint32_t>
        watched_;  // bleeders that were not settled as of watched_at_: later times change only these
    double watched_at_ = 0.0;
    bool watch_all_ = true;  // before the next update
    std::vector<WoundStatus> status_;
    std::vector<std::uint32_t>
        copies_of_;  // organ vertices of surface vertex v: copies_[copies_of_[v] .. copies_of_[v + 1]]
    std::vector<std::uint32_t> copies_;
    std::vector<glm::vec2> surface_values_;  // per surface vertex
    std::vector<glm::vec2> values_;          // per organ vertex
    std::vector<glm::vec2> kept_;            // per surface vertex, or empty
    double kept_at_ = 0.0;
    float kept_clot_ = 0.0f;
    bool kept_shown_ = false;
    std::vector<char> is_touched_;  // per surface vertex: blood has come near
    std::vector<std::uint32_t> touched_;
    std::vector<char> is_counted_;  // per triangle
    mutable std::vector<Touched> touched_triangles_;
    mutable std::size_t sorted_triangles_ = 0;
    std::vector<std::uint32_t> written_;  // surface vertices since the last publish, some more than once
    ChangedVertices changed_;
    bool stale_ = true;  // all has to be written anew
    mutable BloodAmount amount_;
    mutable bool amount_known_ = false;
};

}  // namespace lapfx::bleeding
