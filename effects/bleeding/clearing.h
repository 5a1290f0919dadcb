// Suction, irrigation and whatever else clears (ToolActionRow::clears): how much blood they leave at each place, in
// closed form from the tool contacts. A clearing puts a cap on the bleed value: below 0 inside its reach and rising
// outside it, so that the edge of the remaining blood is as smooth as any other. Blood that flows later is not capped.
// One thread at a time.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "lapfx/bleeding_parameters.h"
#include "lapfx/tool.h"
#include "organ/surface.h"
#include "organ/zeroed.h"
#include "tool/log.h"

namespace lapfx::bleeding {

class Clearing {
  public:
    static constexpr double cap_slope = 3.0;  // mm of cap per mm outside the reach
    static constexpr double rim = 6.0;        // mm outside the reach up to which there is a cap

    /// A clearing at one place. Several at one place are in order of time, the latest first, with falling caps: a cap
    /// is left out when a later one is lower.
    struct Cap {
        double time;         ///< time at which it ended, s
        float cap;           ///< highest bleed value that earlier blood keeps, mm
        std::uint32_t next;  ///< link to the cap before it of the same place, in the list of its layer
    };

    /// Keeps a reference to `surface`. `down`: unit; water runs that way.
    Clearing(const Surface& surface, glm::dvec3 down);

    /// `changed`: the redo bits (lapfx/parameter.h) of what differs from the parameters before, at first those of
    /// BleedingParameters{}. It counts with the next set().
    void set_parameters(const BleedingParameters& parameters, unsigned changed);
    /// Takes what clears of that which was written to the log since the last call; it must always be the same log.
    /// True when the cleared places may have changed.
    bool set(const tool::Log& log);

    /// The caps as of `time`. True when any may have changed: at the places of changed(), or anywhere.
    bool update(double time) noexcept;
    /// Surface vertices that the last update() changed, some more than once.
    std::span<const std::uint32_t> changed() const { return changed_; }
    /// Whether the last update() removed caps of finished sweeps; then everything has to be looked at again.
    bool changed_anywhere() const { return anew_; }

    /// s; no sweep that is not over, or that was set since the last update(), begins before.
    double unfinished_since() const noexcept;

    bool any() const { return !sweeps_.empty(); }
    bool is_capped(std::uint32_t vertex) const { return over_.heads[vertex] != 0 || running_.heads[vertex] != 0; }
    /// Surface vertices with caps of finished sweeps.
    std::span<const std::uint32_t> finished_places() const { return over_.vertices; }
    /// Calls visit(cap) for each cap of a place from the latest back: first those of running sweeps, then those of
    /// finished ones. Of either, the rest is left out once visit() has answered false.
    template <class Visit>
    void from_latest(std::uint32_t vertex, Visit visit) const {
        for (const Layer* layer : {&running_, &over_})
            for (std::uint32_t link = layer->heads[vertex]; link != 0; link = layer->caps[link - 1].next)
                if (!visit(layer->caps[link - 1])) break;
    }
    /// The same, all of them.
    template <class Visit>
    void for_each(std::uint32_t vertex, Visit visit) const {
        from_latest(vertex, [&](const Cap& cap) { return visit(cap), true; });
    }

  private:
    /// How the tip passes a vertex, including the rim.
    struct Passed {
        std::uint32_t vertex;
        float stretch;        // factor on the reach, 1..1.5: water runs downhill
        double enter, leave;  // s
    };
    struct Sweep {
        ToolContact contact;
        std::size_t piece;  // of the log
        double reach;       // mm
        std::vector<Passed> passed;
        double latest_end = 0.0;  // the latest end of this sweep and all before, s
        bool is_over = false;     // and is in the layer over_
    };
    /// A link is 1 + an index into caps, or 0: none.
    struct Layer {
        organ::Zeroed<std::uint32_t> heads;  // per surface vertex, a link
        std::vector<Cap> caps;
        std::vector<std::uint32_t> vertices;  // places that have a cap
        void clear() noexcept;
        void insert(std::uint32_t vertex, double time, float cap);
    };
    Sweep sweep_of(const ToolContact& contact, std::size_t piece) const;
    double over_at(const Sweep& sweep) const noexcept;  // s
    std::span<Sweep> between(double from, double to) noexcept;
    void lay(const Sweep& sweep, double time, Layer& layer);

    const Surface& surface_;
    glm::dvec3 down_;
    std::array<double, tool_action_count> reaches_;  // each action has its reach, mm; 0: it clears nothing
    tool::Reader reader_;
    std::vector<Sweep> sweeps_;
    // Finished sweeps keep their caps as time advances: a frame costs only the running sweep.
    Layer over_, running_;
    double updated_ = 0.0;
    double stale_from_ = std::numeric_limits<double>::infinity();  // start of the first new sweep, s
    bool stale_ = false, all_stale_ = false, anew_ = false;
    std::vector<std::uint32_t> changed_;
};

}  // namespace lapfx::bleeding
