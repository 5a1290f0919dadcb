// Suction and irrigation: what they leave of the blood at each place, in closed form from the tool contacts. A clearing
// lays a cap on the bleed value: below 0 inside its reach, rising outside it, so that the edge of what is left is as smooth
// as any other edge of blood; and it starts the flow anew, for what flows afterwards is not held by it. One thread at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lapfx/preset.h"
#include "lapfx/tool.h"
#include "organ/surface.h"

namespace lapfx::bleeding {

class Clearing {
  public:
    static constexpr double never = -1e300;   // s
    static constexpr double cap_slope = 3.0;  // mm of cap per mm outside the reach
    static constexpr double rim = 6.0;        // mm outside the reach up to which there is a cap

    /// A clearing at one place. Of several at a place the earlier come first, and each later one has a higher cap: what a
    /// later and lower one has overruled is left out.
    struct Cap {
        double time;        ///< s, until when it held
        float cap;          ///< mm, the highest bleed value of what was there by then
        std::int32_t next;  ///< see next()
    };

    /// Keeps a reference to `surface`. `down`: unit; water runs that way.
    Clearing(const Surface& surface, glm::dvec3 down);

    /// Contacts of any action; those that are not suction or irrigation are passed over. Contacts whose numbers are not finite
    /// clear nothing. True when what has been cleared may have changed.
    bool set(std::span<const ToolContact> contacts, const BleedingParameters& parameters);

    /// The caps as of `time`. True when any has changed.
    bool update(double time) noexcept;

    bool any() const { return !sweeps_.empty(); }
    double latest() const { return latest_; }  ///< s, of all caps, as of the last update
    /// Null where nothing has been cleared.
    const Cap* first(std::uint32_t vertex) const {
        return heads_.empty() || heads_[vertex] < 0 ? nullptr : &caps_[static_cast<std::size_t>(heads_[vertex])];
    }
    const Cap* next(const Cap& cap) const {
        return cap.next < 0 ? nullptr : &caps_[static_cast<std::size_t>(cap.next)];
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
        double reach;  // mm
        std::vector<Passed> passed;
    };
    Sweep sweep_of(const ToolContact& contact) const;
    void lay(const Sweep& sweep, double time);
    void insert(std::uint32_t vertex, double time, float cap);

    const Surface& surface_;
    glm::dvec3 down_;
    double suction_radius_ = 0.0, irrigation_radius_ = 0.0;
    std::vector<Sweep> sweeps_;
    std::vector<std::int32_t> heads_;  // per surface vertex, into caps_; empty until there is a sweep
    std::vector<Cap> caps_;
    double updated_ = 0.0, latest_ = never;
    bool stale_ = false;
};

}  // namespace lapfx::bleeding
