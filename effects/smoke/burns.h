// Hot contacts joined into burns: what one plume of source smoke comes from. A moving tool is recorded as many short contacts
// (cautery/recorder.h), but it smokes as one. One thread at a time.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "lapfx/tool.h"

namespace lapfx::smoke {

/// A hot contact of a burn.
struct BurnPart {
    ToolContact contact;
    double fat = 0.0;                  ///< 0..1, of the tissue under it
    const BurnPart* before = nullptr;  ///< the part that it goes on from; nullptr: it starts the burn
};

struct Burn {
    double start = 0.0, end = 0.0;   ///< s
    const BurnPart* last = nullptr;  ///< the others by BurnPart::before
    std::size_t number = 0;          ///< what its chance is taken from: a burn keeps it while it goes on

    /// The part at `time`: before and after the burn its first and last one.
    const BurnPart& at(double time) const noexcept {
        const BurnPart* part = last;
        while (part->before != nullptr && time < part->contact.time) part = part->before;
        return *part;
    }
};

class BurnList {
  public:
    BurnList() = default;
    BurnList(BurnList&&) = default;  // parts point at each other: moved, not copied
    BurnList& operator=(BurnList&&) = default;

    /// mm. When only the power changes, the next contact starts where the tip is one sample (1 ms) later; a tip at 500 mm/s gets
    /// this far. No other tool can be there at that very moment.
    static constexpr double joint = 0.5;

    /// In the order of the list; those that are cold or not usable (tool.h) are left out. A contact goes on from a burn of the
    /// same action that ends when (to 1e-6 s) and where it starts. `fat`: 0..1 for each contact.
    void set(std::span<const ToolContact> contacts, std::span<const double> fat);

    /// Those that may still be going on after `time`; older ones cost nothing. Valid until the next set().
    std::span<const Burn> after(double time) const noexcept;

  private:
    void add(const ToolContact& contact, double fat);

    std::vector<BurnPart> parts_;
    std::vector<Burn> burns_;
    std::vector<double> latest_;  // for each burn: when it and all before it have ended, s
};

}  // namespace lapfx::smoke
