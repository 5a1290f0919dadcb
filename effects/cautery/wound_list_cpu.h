// Wounds as they open and close, with a way back: every event carries a key (the number of a contact, or of a time
// step), keys only grow, and what happened from a key on can be undone. One thread at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cautery/grid_cpu.h"
#include "lapfx/wound.h"

namespace lapfx::cautery {

class WoundList {
  public:
    static constexpr std::size_t most = 4096;
    static constexpr double closest = 1.0;  ///< mm

    /// Wounds in the order in which they were added.
    std::span<const Wound> wounds() const { return wounds_; }
    /// How many were left out because there were `most` of them already. The first ones stay.
    std::size_t left_out() const { return left_out_.size(); }
    /// Changes whenever the wounds do.
    std::uint64_t version() const { return version_; }

    /// False when the wound is left out: no strength; closer than `closest` to one that is open at its start and at least
    /// as strong; or too many.
    bool add(const Wound& wound, std::int64_t key);
    /// Closes a wound at `stop` unless it closes earlier.
    void close(std::uint32_t wound, double stop, std::int64_t key);
    /// Undoes all from `key` on.
    void truncate(std::int64_t key);

    /// Numbers of the wounds in the cells around a box.
    void find(const glm::dvec3& low, const glm::dvec3& high, std::vector<std::uint32_t>& out) const {
        grid_.find(low, high, out);
    }

  private:
    struct Closing {
        std::int64_t key;
        std::uint32_t wound;
        double before;
    };
    std::vector<Wound> wounds_;
    std::vector<std::int64_t> added_;  // key per wound
    std::vector<Closing> closings_;
    std::vector<std::int64_t> left_out_;
    Grid grid_{4.0};
    std::vector<std::uint32_t> near_;
    std::uint64_t version_ = 0;
};

}  // namespace lapfx::cautery
