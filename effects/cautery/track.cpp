#include "cautery/track.h"

#include <algorithm>
#include <cmath>

namespace lapfx::cautery {

namespace {

/// Up to when two contacts are the same but for their ends: exactly, so only where both stand still or share a path.
double same_until(const ToolContact& a, const ToolContact& b) {
    ToolContact longer = a;
    longer.duration = b.duration;
    longer.to = b.to;
    const bool still = a.position == a.to && b.position == b.to;
    if (longer == b && still) return std::min(a.end(), b.end());
    return std::min(a.time, b.time);
}

}  // namespace

std::size_t Track::set(std::span<const ToolContact> contacts, const CauteryParameters& parameters) {
    const auto per_wound = static_cast<std::uint32_t>(std::ceil(3.0 * wound_spacing / parameters.tip_radius));
    if (per_wound != per_wound_ || spacing_ == 0.0) stays_.clear();
    per_wound_ = per_wound;
    spacing_ = wound_spacing / per_wound;

    std::size_t first = 0;  // what is like before, mostly all but the end
    while (first < stays_.size() && first < contacts.size() && stays_[first].contact == contacts[first]) ++first;
    const auto earlier = [](const ToolContact& a, const ToolContact& b) { return a.time < b.time; };
    const auto want_from = [&](std::size_t begin) {
        wanted_.clear();
        for (const ToolContact& given : contacts.subspan(begin))
            if (const auto contact = usable(given)) wanted_.push_back(*contact);
        return std::is_sorted(wanted_.begin(), wanted_.end(), earlier);
    };
    const bool sorted = want_from(first);
    if (!sorted || (first > 0 && !wanted_.empty() && wanted_.front().time < stays_[first - 1].contact.time)) {
        if (!want_from(0)) std::stable_sort(wanted_.begin(), wanted_.end(), earlier);
        first = 0;
    }
    std::size_t next = 0;
    for (; first < stays_.size() && next < wanted_.size() && stays_[first].contact == wanted_[next]; ++next) ++first;

    same_until_ = never;
    if (first < stays_.size()) same_until_ = stays_[first].contact.time;
    if (next < wanted_.size()) same_until_ = std::min(same_until_, wanted_[next].time);
    if (first + 1 == stays_.size() && next < wanted_.size()) {
        same_until_ = cautery::same_until(stays_[first].contact, wanted_[next]);
        if (next + 1 < wanted_.size()) same_until_ = std::min(same_until_, wanted_[next + 1].time);
    }
    stays_.resize(first);
    places_.resize(first > 0 ? stays_.back().end_place : 0);
    for (; next < wanted_.size(); ++next) append(wanted_[next]);
    return first;
}

void Track::append(const ToolContact& contact) {
    const auto number = static_cast<std::uint32_t>(stays_.size());
    Stay stay{.contact = contact,
              .chain = number,
              .chain_start = contact.time,
              .first_place = static_cast<std::uint32_t>(places_.size()),
              .latest_end = contact.end(),
              .latest_hot = contact.hot() ? contact.end() : -never};
    if (number > 0) {
        stay.latest_end = std::max(stay.latest_end, stays_.back().latest_end);
        stay.latest_hot = std::max(stay.latest_hot, stays_.back().latest_hot);
    }
    // Few tools work at once: the contact before is among the last.
    for (std::uint32_t back = 1; back <= std::min(number, 8u); ++back) {
        const Stay& before = stays_[number - back];
        if (!continues(before.contact, contact)) continue;
        stay.chain = before.chain;
        stay.chain_start = before.chain_start;
        stay.length = before.length;
        stay.next_place = before.next_place;
        break;
    }
    const double length = glm::distance(contact.position, contact.to), from = stay.length;
    stay.length += length;
    for (;; ++stay.next_place) {
        const double along = static_cast<double>(stay.next_place) * spacing_;
        if (along > stay.length + 1e-9) break;
        const double share = length > 0.0 ? std::clamp((along - from) / length, 0.0, 1.0) : 0.0;
        Place place{.tip = glm::mix(contact.position, contact.to, share),
                    .point = {},
                    .arrival = contact.time + share * contact.duration,
                    .wound = stay.next_place % per_wound_ == 0};
        if (surface_.triangles.empty()) continue;
        place.point = surface_.closest_point(place.tip);
        if (place.point.distance <= farthest_touch) places_.push_back(place);
    }
    stay.end_place = static_cast<std::uint32_t>(places_.size());
    stays_.push_back(stay);
}

}  // namespace lapfx::cautery
