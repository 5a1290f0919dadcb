// Suction and irrigation: when each place was last cleared of blood, in closed form from the tool contacts. From then on
// only what has flowed since can be there. One thread at a time.
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
    static constexpr double never = -1e300;  // s

    /// Keeps a reference to `surface`. `down`: unit; water runs that way.
    Clearing(const Surface& surface, glm::dvec3 down);

    /// Contacts of any action; those that are not suction or irrigation are passed over. Contacts whose numbers are not finite
    /// clear nothing. True when what has been cleared may have changed.
    bool set(std::span<const ToolContact> contacts, const BleedingParameters& parameters);

    /// When each place was last cleared, as of `time`. True when any has changed.
    bool update(double time) noexcept;

    bool any() const { return !sweeps_.empty(); }
    double latest() const { return latest_; }  ///< s, the latest of all places, as of the last update
    /// s, per surface vertex; `never` where it was not.
    double last(std::uint32_t vertex) const { return last_.empty() ? never : last_[vertex]; }

  private:
    /// From `first` on until `last` the tip has the vertex in its reach.
    struct Cleared {
        std::uint32_t vertex;
        double first, last;
    };
    struct Sweep {
        ToolContact contact;
        std::vector<Cleared> cleared;
    };
    Sweep sweep_of(const ToolContact& contact) const;

    const Surface& surface_;
    glm::dvec3 down_;
    double suction_radius_ = 0.0, irrigation_radius_ = 0.0;
    std::vector<Sweep> sweeps_;
    std::vector<double> last_;
    double updated_ = 0.0, latest_ = never;
    bool stale_ = false;
};

}  // namespace lapfx::bleeding
