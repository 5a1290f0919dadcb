// What the tool has done: one log of strokes in the order of their times, and of their values where times are equal, so
// that the order in which contacts are given means nothing. Heat, wounds, blood and smoke are computed from it.
//
//     log.update(contacts, same);  // the first `same` of them are as they were
//     ...
//     const std::size_t first = reader_.take(log);
//     drop what was made of pieces from `first` on;
//     for (const Piece& piece : log.pieces().subspan(first)) take(piece);
//
// A stroke is what one tool does from press to release: contacts that continue each other (goes_on, lapfx/tool.h). It
// is kept as pieces, each straight and of one power and strength; cautery power over time (lapfx/curves.h) cuts hot
// pieces finer. Contacts that are not usable (usable_contact.h) are left out.
//
// A reader of the log knows how far it has read and takes what was written since. So a sample of a running
// stroke costs the end of that stroke, however much happened before, and a contact that is earlier than others costs
// these others. One thread at a time.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lapfx/tool.h"
#include "tool/power_curve.h"

namespace lapfx::tool {

/// A stroke, or a part of one.
struct Piece {
    static constexpr std::uint32_t none = 0xffffffff;

    ToolContact contact;          ///< usable, with the cautery power of its time
    std::uint32_t before = none;  ///< the piece of its stroke that it continues; none: it begins the stroke
    std::uint64_t revision = 0;   ///< revision of the log when it was written

    bool same_as(const Piece& other) const { return contact == other.contact && before == other.before; }
};

class Log {
  public:
    /// The log has at most this many pieces, or twice as many as contacts; where curves would cut more, their steps are
    /// larger.
    static constexpr std::size_t most_pieces = 1u << 16;

    /// The scene's factor on cautery power over time.
    void set_power(std::span<const CurvePoint> points);
    /// All contacts, in any order. The first `same` of them are unchanged since the last call; those that are earlier
    /// than all others cost nothing.
    void update(std::span<const ToolContact> contacts, std::size_t same = 0);

    /// In the order of their times. Valid until the next call that is not const.
    std::span<const Piece> pieces() const { return pieces_; }
    /// Grows when pieces change.
    std::uint64_t revision() const { return revision_; }
    /// Number of the first piece that has changed since that revision; all later ones count as changed. Revision 0 is
    /// older than any.
    std::size_t first_after(std::uint64_t revision) const;

  private:
    /// A usable contact, in the order of time.
    struct Entry {
        ToolContact contact;
        std::uint32_t given = 0;                                // its number in the list
        std::uint32_t before = Piece::none;                     // the entry that it continues
        bool is_continued = false;                              // another entry continues it
        std::size_t end = 0;                                    // of its pieces
        std::array<std::uint32_t, PowerCurve::levels> parts{};  // each level of the curve has its number
    };
    std::size_t keep(std::size_t same);
    std::size_t append(std::span<const ToolContact> contacts);
    void loosen(std::size_t first);
    void join(std::size_t entry);
    void count(Entry& entry);
    int level_with_room() const;
    std::size_t end_before(std::size_t entry) const { return entry > 0 ? entries_[entry - 1].end : 0; }
    void write(std::size_t first);

    PowerCurve power_;
    int level_ = 0;                                                 // of its steps
    std::array<std::uint64_t, PowerCurve::levels> parts_of_all_{};  // at each level
    std::vector<std::uint32_t> usable_before_;  // for each contact of the list, how many of those before it are usable
    std::vector<Entry> entries_;
    std::vector<Piece> pieces_, written_;  // the latter and parts_ are kept for their memory
    std::vector<ToolContact> parts_;
    std::uint64_t revision_ = 0;
};

/// What somebody who makes something of each piece of a log knows of it. It must always be the same log.
class Reader {
  public:
    /// The number of the first piece that is not as it was at the last call, at most how many there were then: what was
    /// made of it and of later ones is stale.
    std::size_t take(const Log& log) {
        const std::size_t first = std::min(log.first_after(known_), read_);
        known_ = log.revision();
        read_ = log.pieces().size();
        return first;
    }
    /// The next take() gives 0: all has to be made again.
    void forget() { known_ = 0; }

  private:
    std::uint64_t known_ = 0;  // revision
    std::size_t read_ = 0;     // pieces
};

}  // namespace lapfx::tool
