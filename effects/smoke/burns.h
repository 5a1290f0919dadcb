// The parts of the tool's log that concern smoke: hot pieces while the tip touches tissue, and suction, which clears
// smoke. Heat in the air burns nothing, so a piece is divided where its path leaves the tissue. Parts of one stroke
// without a gap are one burn, and each burn has one plume.
//
// A function of the log and the tissue. One thread at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lapfx/tool.h"
#include "smoke/contact_fat.h"
#include "smoke/haze.h"
#include "smoke/touching.h"
#include "tool/log.h"

namespace lapfx::smoke {

/// A hot contact of a burn that is over tissue all the time.
struct BurnPart {
    static constexpr std::uint32_t none = 0xffffffff;

    ToolContact contact;
    double fat = 0.0;             ///< 0..1, of the tissue under it
    std::uint32_t before = none;  ///< the part that it continues; none: it starts the burn
    std::uint32_t burn = 0;
    double latest_end = 0.0;  ///< latest end of this one and all before, s
};

struct Burn {
    double start = 0.0, end = 0.0;  ///< s
    std::uint32_t last = 0;         ///< its last part; the others by BurnPart::before
    std::uint32_t number = 0;       ///< key of its random numbers, which a burn keeps while it continues

    /// The part of the burn at `time`; before and after the burn, its first and last part.
    const BurnPart& at(std::span<const BurnPart> parts, double time) const noexcept {
        const BurnPart* part = &parts[last];
        while (part->before != BurnPart::none && time < part->contact.time) part = &parts[part->before];
        return *part;
    }
};

class BurnList {
  public:
    /// What an update has not changed.
    struct Same {
        std::size_t parts = 0, suctions = 0;
    };

    /// Both functions are asked about the tissue at the time of an update.
    BurnList(Touches touches, ContactFat::Sample fat_at);

    /// Takes what was written to the log since the last call; it must always be the same log.
    Same update(const tool::Log& log);
    /// Call this when the tissue has changed.
    void clear();

    std::span<const BurnPart> parts() const { return parts_; }
    std::span<const Suction> suctions() const { return suctions_; }
    /// The number of the first part that may still run after `time`; older parts cost nothing.
    std::size_t first_after(double time) const noexcept;
    /// Burns that may still run after `time`. Valid until the next update().
    std::span<const Burn> after(double time) const noexcept;

  private:
    struct Ends {
        std::size_t parts, suctions;
    };
    void keep(std::size_t pieces);
    void add(const ToolContact& contact, std::uint32_t before);

    Touches touches_;
    ContactFat::Sample fat_at_;
    ContactFat fat_;
    tool::Reader reader_;
    std::vector<Ends> ends_;  // what each of its pieces gives
    std::vector<BurnPart> parts_;
    std::vector<Suction> suctions_;
    std::vector<Burn> burns_;
    std::vector<double> latest_;         // when each burn and all before it have ended, s
    std::vector<ToolContact> touching_;  // kept for its memory
};

}  // namespace lapfx::smoke
