// Suction and irrigation: what they leave of the blood at each place, in closed form from the tool contacts. A clearing
// lays a cap on the bleed value: below 0 inside its reach, rising outside it, so that the edge of what is left is as
// smooth as any other edge of blood; and it starts the flow anew, for what flows afterwards is not held by it. One
// thread at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lapfx/preset.h"
#include "lapfx/tool.h"
#include "organ/surface.h"
#include "tool/log.h"

namespace lapfx::bleeding {

class Clearing {
  public:
    static constexpr double never = -1e300;   // s
    static constexpr double cap_slope = 3.0;  // mm of cap per mm outside the reach
    static constexpr double rim = 6.0;        // mm outside the reach up to which there is a cap

    /// A clearing at one place. Of several at a place the earlier come first, and each later one has a higher cap: what
    /// a later and lower one has overruled is left out.
    struct Cap {
        double time;        ///< s, until when it held
        float cap;          ///< mm, the highest bleed value of what was there by then
        std::int32_t next;  ///< of the same place, in the list of its layer; -1: none
    };

    /// Keeps a reference to `surface`. `down`: unit; water runs that way.
    Clearing(const Surface& surface, glm::dvec3 down);

    /// Suction and irrigation of the log, always the same one: what was written since the call before. True when what
    /// has been cleared may have changed.
    bool set(const tool::Log& log, const BleedingParameters& parameters);

    /// The caps as of `time`. True when any has changed.
    bool update(double time) noexcept;

    bool any() const { return !sweeps_.empty(); }
    /// Calls visit(cap) for each cap of a place: of what is over in order of time, then of what still runs.
    template <class Visit>
    void for_each(std::uint32_t vertex, Visit visit) const {
        for (const Layer* layer : {&over_, &running_}) {
            if (layer->heads.empty()) continue;
            for (std::int32_t i = layer->heads[vertex]; i >= 0; i = layer->caps[static_cast<std::size_t>(i)].next)
                visit(layer->caps[static_cast<std::size_t>(i)]);
        }
    }

  private:
    /// The tip's way past a vertex, the rim included.
    struct Passed {
        std::uint32_t vertex;
        float stretch;        // of the reach, 1..1.5: water runs downhill
        double enter, leave;  // s
    };
    struct Sweep {
        ToolContact contact;
        std::size_t piece;  // of the log
        double reach;       // mm
        std::vector<Passed> passed;
        bool is_over = false;  // and lies in the layer over_
    };
    struct Layer {
        std::vector<std::int32_t> heads;  // per surface vertex, into caps; empty until there is a sweep
        std::vector<Cap> caps;
        std::vector<std::uint32_t> vertices;  // that have a cap
        void clear() noexcept;
        void insert(std::uint32_t vertex, double time, float cap);
    };
    Sweep sweep_of(const ToolContact& contact, std::size_t piece) const;
    double over_at(const Sweep& sweep) const noexcept;  // s
    void lay(const Sweep& sweep, double time, Layer& layer);

    const Surface& surface_;
    glm::dvec3 down_;
    double suction_radius_ = 0.0, irrigation_radius_ = 0.0;
    std::uint64_t known_ = 0;  // revision of the log
    std::vector<Sweep> sweeps_;
    // Sweeps that are over stay where they are while time goes on: a frame costs the sweep that runs, not all that
    // were.
    Layer over_, running_;
    double updated_ = 0.0;
    bool stale_ = false, all_stale_ = false;
};

}  // namespace lapfx::bleeding
