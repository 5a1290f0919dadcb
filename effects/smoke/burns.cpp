#include "smoke/burns.h"

#include <algorithm>
#include <cmath>

namespace lapfx::smoke {

namespace {

constexpr double no_gap = 1e-6;  // s

}  // namespace

BurnList::BurnList(Touches touches, ContactFat::Sample fat_at)
    : touches_(std::move(touches)), fat_at_(std::move(fat_at)) {}

void BurnList::clear() {
    reader_.forget();
    fat_.clear();
}

BurnList::Same BurnList::update(const tool::Log& log) {
    const std::size_t first = reader_.take(log);
    keep(first);
    const Same same{parts_.size(), suctions_.size()};
    for (const tool::Piece& piece : log.pieces().subspan(first)) {
        const ToolContact& contact = piece.contact;
        if (row_of(contact.action).takes_smoke) suctions_.push_back({contact.time, contact.end()});
        if (contact.hot()) {
            // The piece that it continues may have touched nothing.
            const std::size_t end = piece.before == tool::Piece::none ? 0 : ends_[piece.before].parts;
            const std::size_t begin =
                piece.before == tool::Piece::none || piece.before == 0 ? 0 : ends_[piece.before - 1].parts;
            std::uint32_t before = end > begin ? static_cast<std::uint32_t>(end) - 1 : BurnPart::none;
            touching_.clear();
            touching_parts(contact, touches_, touching_);
            for (const ToolContact& part : touching_) {
                add(part, before);
                before = BurnPart::none;  // between two parts the tip touches nothing
            }
        }
        ends_.push_back({parts_.size(), suctions_.size()});
    }
    return same;
}

void BurnList::add(const ToolContact& contact, std::uint32_t before) {
    const auto number = static_cast<std::uint32_t>(parts_.size());
    const double latest = parts_.empty() ? contact.end() : std::max(parts_.back().latest_end, contact.end());
    if (before != BurnPart::none && std::abs(parts_[before].contact.end() - contact.time) > no_gap)
        before = BurnPart::none;
    std::uint32_t burn = static_cast<std::uint32_t>(burns_.size());
    if (before == BurnPart::none) {
        burns_.push_back({contact.time, contact.end(), number, burn});
        latest_.push_back(0.0);
    } else {
        burn = parts_[before].burn;
        burns_[burn].last = number;
        burns_[burn].end = contact.end();
    }
    parts_.push_back({contact, fat_.along(contact, fat_at_), before, burn, latest});
    for (std::size_t i = burn; i < burns_.size(); ++i)
        latest_[i] = i > 0 ? std::max(latest_[i - 1], burns_[i].end) : burns_[i].end;
}

/// What the first pieces gave.
void BurnList::keep(std::size_t pieces) {
    ends_.resize(pieces);
    const Ends end = pieces > 0 ? ends_.back() : Ends{0, 0};
    suctions_.resize(end.suctions);
    std::size_t changed = burns_.size();
    for (; parts_.size() > end.parts; parts_.pop_back()) {
        const BurnPart& part = parts_.back();
        if (part.before == BurnPart::none) {
            burns_.pop_back();
            continue;
        }
        burns_[part.burn].last = part.before;
        burns_[part.burn].end = parts_[part.before].contact.end();
        changed = std::min<std::size_t>(changed, part.burn);
    }
    latest_.resize(burns_.size());
    for (std::size_t i = changed; i < burns_.size(); ++i)
        latest_[i] = i > 0 ? std::max(latest_[i - 1], burns_[i].end) : burns_[i].end;
}

std::size_t BurnList::first_after(double time) const noexcept {
    const auto first = std::lower_bound(parts_.begin(), parts_.end(), time,
                                        [](const BurnPart& part, double t) { return part.latest_end < t; });
    return static_cast<std::size_t>(first - parts_.begin());
}

std::span<const Burn> BurnList::after(double time) const noexcept {
    const auto first = std::lower_bound(latest_.begin(), latest_.end(), time) - latest_.begin();
    return std::span<const Burn>(burns_).subspan(static_cast<std::size_t>(first));
}

}  // namespace lapfx::smoke
