#include "tool/log.h"

#include <algorithm>
#include <tuple>

#include "lapfx/authoring/strokes.h"
#include "tool/usable_contact.h"

namespace lapfx::tool {

namespace {

/// By time; what begins at the same time by what it does, so that the order of a file means nothing.
auto order_of(const ToolContact& c) {
    return std::tuple(c.time, c.action, c.duration, -c.power, -c.strength, c.position.x, c.position.y, c.position.z,
                      c.to.x, c.to.y, c.to.z);
}

}  // namespace

void Log::set_power(std::span<const CurvePoint> points) {
    if (FactorCurve(points, 1.0) == power_.curve()) return;
    power_ = PowerCurve(points);
    parts_of_all_ = {};
    for (Entry& entry : entries_) count(entry);
    level_ = level_with_room();
    write(0);
}

void Log::update(std::span<const ToolContact> contacts, std::size_t same) {
    const std::size_t kept = keep(std::min(same, contacts.size()));
    const std::size_t first = std::min(kept, append(contacts));
    for (std::size_t i = first; i < entries_.size(); ++i) join(i);
    const int level = level_with_room();
    const bool same_steps = level == level_;
    level_ = level;
    write(same_steps ? first : 0);
}

/// Removes the entries that do not belong to the first `same` contacts; gives the number of the first one removed.
std::size_t Log::keep(std::size_t same) {
    if (same >= usable_before_.size()) return entries_.size();
    const std::size_t kept = usable_before_[same];
    usable_before_.resize(same);
    const auto goes = [&](const Entry& entry) { return entry.given >= same; };
    auto first = entries_.end();
    while (first != entries_.begin() && goes(*(first - 1))) --first;
    // Nearly always they are the last.
    if (static_cast<std::size_t>(first - entries_.begin()) > kept) first = std::find_if(entries_.begin(), first, goes);
    loosen(static_cast<std::size_t>(first - entries_.begin()));
    for (auto entry = first; entry != entries_.end(); ++entry)
        if (goes(*entry))
            for (std::size_t k = 0; k < entry->parts.size(); ++k) parts_of_all_[k] -= entry->parts[k];
    const auto number = static_cast<std::size_t>(first - entries_.begin());
    entries_.erase(std::remove_if(first, entries_.end(), goes), entries_.end());
    return number;
}

/// Adds the entries that are missing; gives the number of the first entry whose place has changed.
std::size_t Log::append(std::span<const ToolContact> contacts) {
    const std::size_t former = entries_.size();
    const auto earlier = [](const Entry& a, const Entry& b) { return order_of(a.contact) < order_of(b.contact); };
    for (std::size_t i = usable_before_.size(); i < contacts.size(); ++i) {
        usable_before_.push_back(static_cast<std::uint32_t>(entries_.size()));
        const auto contact = usable(contacts[i]);
        if (!contact) continue;
        entries_.push_back({.contact = *contact, .given = static_cast<std::uint32_t>(i)});
        count(entries_.back());
    }
    const auto begin = entries_.begin(), middle = begin + static_cast<std::ptrdiff_t>(former), end = entries_.end();
    if (middle == end) return former;
    if (!std::is_sorted(middle, end, earlier)) std::sort(middle, end, earlier);
    const auto first = std::upper_bound(begin, middle, *middle, earlier);
    loosen(static_cast<std::size_t>(first - begin));
    if (first != middle) std::inplace_merge(first, middle, end, earlier);
    return static_cast<std::size_t>(first - begin);
}

/// Entries from this one on continue none of those before.
void Log::loosen(std::size_t first) {
    for (std::size_t i = first; i < entries_.size(); ++i) {
        if (entries_[i].before != Piece::none) entries_[entries_[i].before].is_continued = false;
        entries_[i].before = Piece::none;
    }
}

void Log::join(std::size_t number) {
    entries_[number].is_continued = false;
    const auto before = goes_on_from(
        number, [&](std::size_t i) -> const ToolContact& { return entries_[i].contact; },
        [&](std::size_t i) { return entries_[i].is_continued; });
    if (!before) return;
    entries_[*before].is_continued = true;
    entries_[number].before = static_cast<std::uint32_t>(*before);
}

void Log::count(Entry& entry) {
    for (int level = 0; level < PowerCurve::levels; ++level) {
        const auto k = static_cast<std::size_t>(level);
        entry.parts[k] = power_.count(entry.contact, level);
        parts_of_all_[k] += entry.parts[k];
    }
}

/// The finest steps with which all pieces have room. They depend on the contacts, not on what happened before.
int Log::level_with_room() const {
    const std::size_t room = std::max(most_pieces, 2 * entries_.size());
    int level = 0;
    while (level + 1 < PowerCurve::levels && parts_of_all_[static_cast<std::size_t>(level)] > room) ++level;
    return level;
}

/// Makes the pieces of the entries from `first` on. Pieces that have not changed keep their revision.
void Log::write(std::size_t first) {
    const std::size_t begin = end_before(first);
    written_.clear();
    for (std::size_t i = first; i < entries_.size(); ++i) {
        Entry& entry = entries_[i];
        std::uint32_t before =
            entry.before == Piece::none ? Piece::none : static_cast<std::uint32_t>(entries_[entry.before].end) - 1;
        parts_.clear();
        power_.cut(entry.contact, level_, parts_);
        for (const ToolContact& part : parts_) {
            written_.push_back({.contact = part, .before = before});
            before = static_cast<std::uint32_t>(begin + written_.size()) - 1;
        }
        entry.end = begin + written_.size();
    }
    const auto differ =
        std::mismatch(written_.begin(), written_.end(), pieces_.begin() + static_cast<std::ptrdiff_t>(begin),
                      pieces_.end(), [](const Piece& a, const Piece& b) { return a.same_as(b); });
    if (differ.first == written_.end() && differ.second == pieces_.end()) return;
    pieces_.erase(differ.second, pieces_.end());
    ++revision_;
    for (auto piece = differ.first; piece != written_.end(); ++piece) {
        piece->revision = revision_;
        pieces_.push_back(*piece);
    }
}

std::size_t Log::first_after(std::uint64_t revision) const {
    const auto first = std::upper_bound(pieces_.begin(), pieces_.end(), revision,
                                        [](std::uint64_t known, const Piece& piece) { return known < piece.revision; });
    return static_cast<std::size_t>(first - pieces_.begin());
}

}  // namespace lapfx::tool
