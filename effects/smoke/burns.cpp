#include "smoke/burns.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "preset/usable_contact.h"

namespace lapfx::smoke {

namespace {

/// Tools that burn at the same time: as far back as a burn is looked for that a contact goes on from.
constexpr std::size_t most_tools = 8;

bool continues(const Burn& burn, const ToolContact& next) {
    const ToolContact& contact = burn.last->contact;
    // Times that went through a file are rounded.
    return contact.action == next.action && std::abs(contact.end() - next.time) <= 1e-6 &&
           glm::distance(contact.to, next.position) <= BurnList::joint;
}

}  // namespace

void BurnList::add(const ToolContact& contact, double fat) {
    parts_.push_back({contact, fat, nullptr});
    BurnPart& part = parts_.back();
    const auto recent = static_cast<std::ptrdiff_t>(std::min(burns_.size(), most_tools));
    const auto found =
        std::find_if(burns_.rbegin(), burns_.rbegin() + recent, [&](const Burn& b) { return continues(b, contact); });
    if (found == burns_.rbegin() + recent) {
        burns_.push_back({contact.time, contact.end(), &part, burns_.size()});
        return;
    }
    part.before = found->last;
    found->last = &part;
    found->end = contact.end();
}

void BurnList::set(std::span<const ToolContact> contacts, std::span<const double> fat) {
    assert(fat.size() == contacts.size());
    parts_.clear();
    burns_.clear();
    latest_.clear();
    if (parts_.capacity() < contacts.size()) parts_.reserve(2 * contacts.size());  // parts point at each other
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const std::optional<ToolContact> contact = contacts[i].hot() ? usable(contacts[i]) : std::nullopt;
        if (contact) add(*contact, fat[i]);
    }
    for (const Burn& burn : burns_) latest_.push_back(latest_.empty() ? burn.end : std::max(latest_.back(), burn.end));
}

std::span<const Burn> BurnList::after(double time) const noexcept {
    const auto first = std::lower_bound(latest_.begin(), latest_.end(), time) - latest_.begin();
    return std::span<const Burn>(burns_).subspan(static_cast<std::size_t>(first));
}

}  // namespace lapfx::smoke
