// What clearings leave for blood to fill again, place by place. It is looked up once in an update, by the first wound
// that comes to the place, and answers for all others: where many wounds fill the same places, most are not asked.
// Allocates only to grow. One thread at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "organ/zeroed.h"

namespace lapfx::bleeding {

/// Of the clearings at a place, those that matter: an earlier one can raise nothing above what lies there.
struct ClearedPlace {
    double earliest = std::numeric_limits<double>::infinity();  ///< of those that matter, s; most has flowed since
    double latest = -std::numeric_limits<double>::infinity();   ///< of all, s
    float limit = std::numeric_limits<float>::max();            ///< the least cap of those that matter, mm
};

class ClearedPlaces {
  public:
    explicit ClearedPlaces(std::size_t points) : slots_(points) {}

    /// Another update: all is looked up again.
    void forget() {
        ++update_;
        places_.clear();
    }
    /// `look_up()`: the ClearedPlace, or nothing where the place is as it was. Null for that. Valid until the next
    /// call.
    template <class LookUp>
    const ClearedPlace* at(std::uint32_t point, const LookUp& look_up) {
        std::uint64_t& slot = slots_[point];
        if (slot >> 32 != update_) {
            const std::optional<ClearedPlace> place = look_up();
            if (place) places_.push_back(*place);
            slot = update_ << 32 | (place ? places_.size() : 0);
        }
        const auto number = static_cast<std::uint32_t>(slot);
        return number == 0 ? nullptr : &places_[number - 1];
    }

  private:
    std::uint64_t update_ = 1;
    organ::Zeroed<std::uint64_t> slots_;  // per point: the update, and 1 + an index into places_, or 0
    std::vector<ClearedPlace> places_;
};

}  // namespace lapfx::bleeding
