#include "smoke/touching.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "preset/usable_contact.h"

namespace lapfx::smoke {

namespace {

constexpr int halvings = 12;  // of the step in which a tip leaves the tissue

/// The share of the path between `on`, which touches, and `off`, which does not, where it stops touching.
double edge_between(const ToolContact& contact, double on, double off, const Touching::Touches& touches) {
    for (int i = 0; i < halvings; ++i) {
        const double half = 0.5 * (on + off);
        (touches(glm::mix(contact.position, contact.to, half)) ? on : off) = half;
    }
    return on;
}

}  // namespace

std::span<const ToolContact> Touching::update(std::span<const ToolContact> contacts, const Touches& touches) {
    std::size_t same = 0;
    while (same < contacts_.size() && same < contacts.size() && contacts_[same] == contacts[same]) ++same;
    ends_.resize(same);
    parts_.resize(same > 0 ? ends_.back() : 0);
    for (const ToolContact& contact : contacts.subspan(same)) {
        add(contact, touches);
        ends_.push_back(parts_.size());
    }
    contacts_.assign(contacts.begin(), contacts.end());
    return parts_;
}

void Touching::add(const ToolContact& contact, const Touches& touches) {
    if (!contact.hot()) {
        parts_.push_back(contact);
        return;
    }
    const std::optional<ToolContact> sound = usable(contact);
    if (!sound) return;
    const double length = glm::distance(sound->position, sound->to);
    const int steps = std::min(static_cast<int>(std::ceil(length / spacing)), most_places - 1);
    // Shares of the path; `entered` is where the part that is touching now has begun.
    double last = 0.0, entered = 0.0;
    bool touching = touches(sound->position);
    if (touching && steps == 0) return parts_.push_back(contact);
    for (int i = 1; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        const bool now = touches(glm::mix(sound->position, sound->to, share));
        if (now && !touching) entered = edge_between(*sound, share, last, touches);
        if (!now && touching) add_part(*sound, entered, edge_between(*sound, last, share, touches));
        touching = now;
        last = share;
    }
    if (!touching) return;
    if (entered == 0.0)
        parts_.push_back(contact);
    else
        add_part(*sound, entered, 1.0);
}

/// The contact from one share of its path to another.
void Touching::add_part(const ToolContact& contact, double from, double to) {
    ToolContact part = contact;
    part.time = contact.time + from * contact.duration;
    part.duration = (to - from) * contact.duration;
    part.position = glm::mix(contact.position, contact.to, from);
    part.to = glm::mix(contact.position, contact.to, to);
    parts_.push_back(part);
}

}  // namespace lapfx::smoke
