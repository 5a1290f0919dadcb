#include "smoke/touching.h"

#include <algorithm>
#include <cmath>

namespace lapfx::smoke {

namespace {

constexpr int halvings = 12;  // number of halvings of the step in which a tip leaves the tissue

/// The share of the path between `on`, which touches, and `off`, which does not, where it stops touching.
double edge_between(const ToolContact& contact, double on, double off, const Touches& touches) {
    for (int i = 0; i < halvings; ++i) {
        const double half = 0.5 * (on + off);
        (touches(glm::mix(contact.position, contact.to, half)) ? on : off) = half;
    }
    return on;
}

/// The contact from one share of its path to another.
ToolContact part_of(const ToolContact& contact, double from, double to) {
    ToolContact part = contact;
    part.time = contact.time + from * contact.duration;
    part.duration = (to - from) * contact.duration;
    part.position = glm::mix(contact.position, contact.to, from);
    part.to = glm::mix(contact.position, contact.to, to);
    return part;
}

}  // namespace

void touching_parts(const ToolContact& contact, const Touches& touches, std::vector<ToolContact>& parts) {
    const double length = glm::distance(contact.position, contact.to);
    const int steps = std::min(static_cast<int>(std::ceil(length / touching_spacing)), most_touching_places - 1);
    // Shares of the path; the part that touches now began at `entered`.
    double last = 0.0, entered = 0.0;
    bool touching = touches(contact.position);
    if (touching && steps == 0) return parts.push_back(contact);
    for (int i = 1; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps;
        const bool now = touches(glm::mix(contact.position, contact.to, share));
        if (now && !touching) entered = edge_between(contact, share, last, touches);
        if (!now && touching) parts.push_back(part_of(contact, entered, edge_between(contact, last, share, touches)));
        touching = now;
        last = share;
    }
    if (touching) parts.push_back(entered == 0.0 ? contact : part_of(contact, entered, 1.0));
}

}  // namespace lapfx::smoke
