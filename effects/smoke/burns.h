// What makes smoke of all that the tool does: hot pieces of its log while the tip touches tissue, and suction, which
// clears it. Heat in the air burns nothing; where a path leaves the tissue its piece is divided. Parts of one stroke
// that follow without a gap are one burn: what one plume of source smoke comes from.
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

/// A hot contact of a burn, over tissue all along.
struct BurnPart {
    static constexpr std::uint32_t none = 0xffffffff;

    ToolContact contact;
    double fat = 0.0;             ///< 0..1, of the tissue under it
    std::uint32_t before = none;  ///< the part that it goes on from; none: it starts the burn
    std::uint32_t burn = 0;
    double latest_end = 0.0;  ///< s, of this one and all before
};

struct Burn {
    double start = 0.0, end = 0.0;  ///< s
    std::uint32_t last = 0;         ///< its last part; the others by BurnPart::before
    std::uint32_t number = 0;       ///< what its chance is taken from: a burn keeps it while it goes on

    /// The part at `time`, of all parts: before and after the burn its first and last one.
    const BurnPart& at(std::span<const BurnPart> parts, double time) const noexcept {
        const BurnPart* part = &parts[last];
        while (part->before != BurnPart::none && time < part->contact.time) part = &parts[part->before];
        return *part;
    }
};

class BurnList {
  public:
    /// What is the same as before an update.
    struct Same {
        std::size_t parts = 0, suctions = 0;
    };

    /// Asks both of the tissue as it is then.
    BurnList(Touches touches, ContactFat::Sample fat_at);

    /// Takes what was written to the log since the call before; always the same log.
    Same update(const tool::Log& log);
    /// The tissue is another.
    void clear();

    std::span<const BurnPart> parts() const { return parts_; }
    std::span<const Suction> suctions() const { return suctions_; }
    /// The number of the first part that may still be going on after `time`; older ones cost nothing.
    std::size_t first_after(double time) const noexcept;
    /// Burns that may still be going on after `time`. Valid until the next update().
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
    std::uint64_t known_ = 0;  // revision of the log
    std::vector<Ends> ends_;   // of what each of its pieces gives
    std::vector<BurnPart> parts_;
    std::vector<Suction> suctions_;
    std::vector<Burn> burns_;
    std::vector<double> latest_;         // for each burn: when it and all before it have ended, s
    std::vector<ToolContact> touching_;  // kept for its memory
};

}  // namespace lapfx::smoke
