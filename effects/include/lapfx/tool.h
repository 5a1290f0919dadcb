// What an instrument does to the organ. Lengths mm in organ space, times s. Plain data.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace lapfx {

enum class ToolAction {
    cauterise,   ///< heats; above the cut temperature the tissue divides and may bleed; smokes
    cut,         ///< divides cold: bleeds at once, no smoke
    coagulate,   ///< heats gently, below charring: wounds near it close; smokes
    tear,        ///< blunt dissection: bleeds at once, 0.6 times as strongly, no heat, no smoke
    suction,     ///< takes blood away around the tip, which need not touch
    irrigation,  ///< rinses blood away around the tip, which need not touch, and downhill of it
};

/// Whether it divides tissue, so that a wound may open.
inline bool divides(ToolAction action) noexcept {
    return action == ToolAction::cauterise || action == ToolAction::cut || action == ToolAction::tear;
}

/// The tool touches the organ from `time` for `duration`, its tip moving straight from `position` to `to`. Contacts
/// that go on from each other (goes_on) are one stroke: what one tool does from press to release, a polyline whose
/// power and strength may change. Where the tip is farther than 5 mm from the organ's surface it touches nothing. What
/// is not finite, or absurd (a path over 1000 mm, a coordinate beyond 1e5 mm, a time beyond 1e7 s, less than nothing),
/// does nothing; of one longer than 600 s the beginning counts.
struct ToolContact {
    ToolAction action = ToolAction::cauterise;
    double time = 0.0;
    double duration = 1.0;
    glm::dvec3 position{0.0};
    glm::dvec3 to{0.0};
    double power = 1.0;     ///< cautery power, 0..1
    double strength = 1.0;  ///< of the wound, times the preset's speed

    friend bool operator==(const ToolContact&, const ToolContact&) = default;
    double end() const { return time + duration; }
    /// Where the tip is at `t`; before and after the contact, its first and last place.
    glm::dvec3 tip(double t) const {
        const double share = duration > 0.0 ? glm::clamp((t - time) / duration, 0.0, 1.0) : 1.0;
        return glm::mix(position, to, share);
    }
    bool hot() const { return action == ToolAction::cauterise || action == ToolAction::coagulate; }
};

/// mm between two contacts of one stroke: where only the power changes, the next one starts where the tip is a sample
/// (1 ms) later, and a tip at 500 mm/s gets this far. No other tool can be there at that very moment.
inline constexpr double stroke_joint = 0.5;

/// Whether `next` goes on where `contact` ends, so that both are of one stroke. Times that went through a file are
/// rounded.
inline bool goes_on(const ToolContact& contact, const ToolContact& next) noexcept {
    return contact.action == next.action && std::abs(contact.end() - next.time) <= 1e-6 &&
           glm::distance(contact.to, next.position) <= stroke_joint;
}

}  // namespace lapfx
