#include "tool/log.h"

#include <algorithm>
#include <tuple>

#include "tool/usable_contact.h"

namespace lapfx::tool {

namespace {

/// Few tools work at once: what a contact goes on from is among the last.
constexpr std::uint32_t looked_at = 16;

}  // namespace

void Log::set_power(std::span<const CurvePoint> points) {
    if (FactorCurve(points, 1.0) == power_.curve()) return;
    power_ = PowerCurve(points);
    write(choose_steps(0, true));
}

void Log::update(std::span<const ToolContact> contacts, std::size_t same) {
    const std::size_t former = entries_.size();
    std::size_t first = 0;
    bool anew = true;
    if (keep(std::min(same, contacts.size()))) {
        first = entries_.size();
        anew = first < former;
        if (!append(contacts)) first = 0;
    } else {
        entries_.clear();
        usable_before_.clear();
        append(contacts);
    }
    if (first == 0)
        std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
            return std::tie(a.contact.time, a.given) < std::tie(b.contact.time, b.given);
        });
    for (std::size_t i = first; i < entries_.size(); ++i) join(static_cast<std::uint32_t>(i));
    write(choose_steps(first, anew || first == 0));
}

/// Takes away what is not of the first `same` contacts; false when some of it lies before these in time.
bool Log::keep(std::size_t same) {
    if (same < usable_before_.size()) {
        const std::size_t kept = usable_before_[same];
        for (; entries_.size() > kept && entries_.back().given >= same; entries_.pop_back())
            if (const std::uint32_t before = entries_.back().before; before != Piece::none)
                entries_[before].is_continued = false;
        if (entries_.size() > kept) return false;
        usable_before_.resize(same);
    }
    return true;
}

/// Those that are not there yet; false when one comes before what is there.
bool Log::append(std::span<const ToolContact> contacts) {
    bool in_order = true;
    for (std::size_t i = usable_before_.size(); i < contacts.size(); ++i) {
        usable_before_.push_back(static_cast<std::uint32_t>(entries_.size()));
        const auto contact = usable(contacts[i]);
        if (!contact) continue;
        in_order = in_order && (entries_.empty() || entries_.back().contact.time <= contact->time);
        entries_.push_back({.contact = *contact, .given = static_cast<std::uint32_t>(i)});
    }
    return in_order;
}

void Log::join(std::uint32_t number) {
    Entry& entry = entries_[number];
    entry.before = Piece::none;
    entry.is_continued = false;
    for (std::uint32_t back = 1; back <= std::min(number, looked_at); ++back) {
        Entry& before = entries_[number - back];
        if (before.is_continued || !goes_on(before.contact, entry.contact)) continue;
        before.is_continued = true;
        entry.before = number - back;
        return;
    }
}

/// Steps of the curve with which all pieces have room; gives the first entry that they change. Where `anew`, the finest
/// that do: what they are follows from the contacts, not from what was there before.
std::size_t Log::choose_steps(std::size_t first, bool anew) {
    const auto set = [&](int coarser) {
        if (coarser == power_.coarser()) return;
        power_.make_steps(coarser);
        first = 0;
    };
    const std::size_t room = std::max(most_pieces, 2 * entries_.size());
    const auto has_room = [&] {
        std::size_t count = end_before(first);
        for (std::size_t i = first; i < entries_.size() && count <= room; ++i)
            count += power_.count(entries_[i].contact);
        return count <= room;
    };
    if (anew) set(1);
    while (!has_room()) set(2 * power_.coarser());
    return first;
}

/// The pieces of the entries from `first` on. Those that are what they were keep their revision.
void Log::write(std::size_t first) {
    const std::size_t begin = end_before(first);
    written_.clear();
    for (std::size_t i = first; i < entries_.size(); ++i) {
        Entry& entry = entries_[i];
        std::uint32_t before =
            entry.before == Piece::none ? Piece::none : static_cast<std::uint32_t>(entries_[entry.before].end) - 1;
        parts_.clear();
        power_.cut(entry.contact, parts_);
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
