#include "cautery/track.h"

#include <algorithm>
#include <cmath>

namespace lapfx::cautery {

namespace {

/// The time up to which two contacts that differ only in their ends agree exactly, so only where both stand still or
/// share a path.
double same_until(const ToolContact& a, const ToolContact& b) {
    ToolContact longer = a;
    longer.duration = b.duration;
    longer.to = b.to;
    const bool still = a.position == a.to && b.position == b.to;
    if (longer == b && still) return std::min(a.end(), b.end());
    return std::min(a.time, b.time);
}

}  // namespace

void Track::set_parameters(const CauteryParameters& parameters) {
    per_wound_ = static_cast<std::uint32_t>(std::ceil(3.0 * wound_spacing / parameters.tip_radius));
    spacing_ = wound_spacing / per_wound_;
    reader_.forget();
}

std::size_t Track::set(const tool::Log& log) {
    const std::span<const tool::Piece> pieces = log.pieces();
    const std::size_t first = reader_.take(log);
    same_until_ = never;
    if (first < stays_.size()) same_until_ = stays_[first].contact.time;
    if (first < pieces.size()) same_until_ = std::min(same_until_, pieces[first].contact.time);
    if (first + 1 == stays_.size() && first < pieces.size()) {
        same_until_ = cautery::same_until(stays_[first].contact, pieces[first].contact);
        if (first + 1 < pieces.size()) same_until_ = std::min(same_until_, pieces[first + 1].contact.time);
    }
    stays_.resize(first);
    places_.resize(first > 0 ? stays_.back().end_place : 0);
    for (const tool::Piece& piece : pieces.subspan(first)) append(piece);
    return first;
}

bool Track::is_near(std::uint32_t chain, double time, const glm::dvec3& tip, double radius) const {
    auto i = std::partition_point(stays_.begin(), stays_.end(), [&](const Stay& s) { return s.contact.time <= time; });
    while (i != stays_.begin() && (i - 1)->latest_end >= time) {
        --i;
        if (i->chain == chain && i->contact.end() >= time && glm::distance(i->contact.tip(time), tip) <= radius)
            return true;
    }
    return false;
}

void Track::append(const tool::Piece& piece) {
    const ToolContact& contact = piece.contact;
    const auto number = static_cast<std::uint32_t>(stays_.size());
    Stay stay{.contact = contact,
              .chain = number,
              .first_place = static_cast<std::uint32_t>(places_.size()),
              .latest_end = contact.end(),
              .latest_hot = contact.hot() ? contact.end() : -never};
    if (number > 0) {
        stay.latest_end = std::max(stay.latest_end, stays_.back().latest_end);
        stay.latest_hot = std::max(stay.latest_hot, stays_.back().latest_hot);
    }
    if (piece.before != tool::Piece::none) {
        const Stay& before = stays_[piece.before];
        stay.chain = before.chain;
        stay.length = before.length;
        stay.next_place = before.next_place;
    }
    const double length = glm::distance(contact.position, contact.to), from = stay.length;
    stay.length += length;
    ++work_;
    for (;; ++stay.next_place) {
        const double along = static_cast<double>(stay.next_place) * spacing_;
        if (along > stay.length + 1e-9) break;
        ++work_;
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
