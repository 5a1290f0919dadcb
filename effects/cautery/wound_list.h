// Wounds as they open and close, with undo: every event has a key (the number of an event, or of a time step), keys
// only grow, and everything from a key on can be undone. One thread at a time.
//
// The result of a division does not depend on earlier wounds: an open wound that is at least as strong counts for a new
// one at its place, and then bleeds as long as the new one would have. Therefore events are added in the order of time,
// and at one time in the order of opens_before; a wound that heat has closed, or that a clip holds, does not count for
// later ones.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "cautery/grid.h"
#include "cautery/heat.h"
#include "lapfx/wound.h"

namespace lapfx::cautery {

/// A wound as a tool opens it.
struct Division {
    Wound wound;
    glm::dvec3 tip{0.0};  ///< where the tool's tip is then
    bool by_heat = false;
};
/// In the order of their start; of several at one time the strongest first, since it stands for the others. No two
/// different ones are equal, so that the order does not depend on that of a file.
bool opens_before(const Division& a, const Division& b);
/// The time, s, from which a clip holds a place of the surface; never: none does.
using SealedAt = std::function<double(const glm::dvec3& place)>;

class WoundList {
  public:
    static constexpr std::size_t most = 4096;
    static constexpr double closest = 1.0;  ///< mm
    static constexpr std::uint32_t none = 0xffffffff;

    /// `sealed_at` may be empty: there are no clips. Where it answers otherwise than before, seal() is to be called,
    /// and what was added afterwards may be another: it is to be truncated.
    explicit WoundList(SealedAt sealed_at = {}) : sealed_at_(std::move(sealed_at)) {}

    /// Wounds in the order in which they were added, with what clips do to them.
    std::span<const Wound> wounds() const { return wounds_; }
    /// How many were left out because there were already `most` of them. The first ones stay.
    std::size_t left_out() const { return left_out_.size(); }
    /// Changes whenever add() or truncating changes the wounds; what seal() does to them shows in the clips' version.
    std::uint64_t version() const { return version_; }

    /// False when there is no new wound: it has no strength, there are too many, or it is closer than `closest` to a
    /// wound that is open at its start and at least as strong. That wound counts for it: if heat has divided the
    /// tissue, burn_of() is this burn from now on, and stands_for() its number.
    bool add(const Division& division, std::int64_t key);
    /// The wound that counts for the last one that was not added because of it; none: another reason.
    std::uint32_t stands_for() const { return stands_for_; }
    Burn burn_of(std::uint32_t wound) const { return beside_[wound].burn; }
    /// Whether heat closes the wound at some time, whatever a clip does to it.
    bool is_closed(std::uint32_t wound) const { return beside_[wound].closed < never; }
    /// Asks again which clips hold the wounds.
    void seal();
    /// Closes a wound at `stop`. False if heat closes it earlier.
    bool close(std::uint32_t wound, double stop, std::int64_t key);
    /// Undoes everything from `key` on.
    void truncate(std::int64_t key);

    /// Numbers of the wounds in the cells around a box.
    void find(const glm::dvec3& low, const glm::dvec3& high, std::vector<std::uint32_t>& out) const {
        grid_.find(low, high, out);
    }

  private:
    /// What else there is to know of a wound.
    struct Beside {
        Burn burn;
        std::int64_t key;       ///< with which it was added
        double closed = never;  ///< s, by heat
    };
    struct Closing {
        std::int64_t key;
        std::uint32_t wound;
        double before;
    };
    struct Burning {
        std::int64_t key;
        std::uint32_t wound;
        Burn before;
    };
    void settle(std::uint32_t wound);

    SealedAt sealed_at_;
    std::vector<Wound> wounds_;
    std::vector<Beside> beside_;  // per wound
    std::vector<Closing> closings_;
    std::vector<Burning> burnings_;
    std::vector<std::int64_t> left_out_;
    Grid grid_{4.0};
    std::vector<std::uint32_t> near_;
    std::uint32_t stands_for_ = none;
    std::uint64_t version_ = 0;
};

}  // namespace lapfx::cautery
