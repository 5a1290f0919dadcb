// What the tool has done: one log of strokes, in the order of their times, that heat, wounds, blood and smoke are
// worked out from.
//
//     log.update(contacts, same);                        // the first `same` of them are as they were
//     ...
//     for (std::size_t i = log.first_after(known_); i < log.pieces().size(); ++i) take(log.pieces()[i]);
//     known_ = log.revision();
//
// A stroke is what one tool does from press to release: contacts that go on from each other (goes_on, lapfx/tool.h). It
// is kept as pieces, each straight, of one power and strength; cautery power over time (lapfx/curves.h) cuts hot ones
// finer. Contacts that cannot be (usable_contact.h) are left out.
//
// Who reads the log keeps the revision that it knows, and takes what was written after it: a sample of a held stroke
// costs the end of that stroke, however much happened before. A contact that comes before others in time writes all
// anew. One thread at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lapfx/tool.h"
#include "tool/power_curve.h"

namespace lapfx::tool {

/// A stroke, or a part of one.
struct Piece {
    static constexpr std::uint32_t none = 0xffffffff;

    ToolContact contact;          ///< usable, with the power of its time
    std::uint32_t before = none;  ///< the piece of its stroke that it goes on from; none: it begins the stroke
    std::uint64_t revision = 0;   ///< of the log, when it was written

    bool same_as(const Piece& other) const { return contact == other.contact && before == other.before; }
};

class Log {
  public:
    /// At most this many pieces, or twice as many as contacts; where curves would cut more, their steps are larger.
    static constexpr std::size_t most_pieces = 1u << 16;

    /// The scene's factor on cautery power over time.
    void set_power(std::span<const CurvePoint> points);
    /// All contacts, in any order. The first `same` are as they were in the call before: they cost nothing, as long as
    /// none of the others comes earlier.
    void update(std::span<const ToolContact> contacts, std::size_t same = 0);

    /// In the order of their times. Valid until the next call that is not const.
    std::span<const Piece> pieces() const { return pieces_; }
    /// Grows when pieces change.
    std::uint64_t revision() const { return revision_; }
    /// Number of the first piece that is not what it was at that revision, and with it all that follow; 0 is older than
    /// any.
    std::size_t first_after(std::uint64_t revision) const;

  private:
    /// A usable contact, in the order of time.
    struct Entry {
        ToolContact contact;
        std::uint32_t given = 0;             // its number in the list
        std::uint32_t before = Piece::none;  // the entry that it goes on from
        bool is_continued = false;           // another one goes on from it
        std::size_t end = 0;                 // of its pieces
    };
    bool keep(std::size_t same);
    bool append(std::span<const ToolContact> contacts);
    void join(std::uint32_t entry);
    std::size_t choose_steps(std::size_t first, bool anew);
    std::size_t end_before(std::size_t entry) const { return entry > 0 ? entries_[entry - 1].end : 0; }
    void write(std::size_t first);

    PowerCurve power_;
    std::vector<std::uint32_t> usable_before_;  // per contact of the list: how many of those before it are usable
    std::vector<Entry> entries_;
    std::vector<Piece> pieces_, written_;  // the latter is kept for its memory, as is parts_
    std::vector<ToolContact> parts_;
    std::uint64_t revision_ = 0;
};

}  // namespace lapfx::tool
