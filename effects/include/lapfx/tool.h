// What an instrument does to the organ. Lengths mm in organ space, times s. Plain data.
#pragma once

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

/// The tool touches the organ from `time` for `duration`, its tip moving straight from `position` to `to`. Contacts of one
/// action that follow each other without a gap, in time and place, are one stay: a curved path. Where the tip is farther
/// than 5 mm from the organ's surface it touches nothing. What is not finite, or absurd (a path over 1000 mm, a coordinate
/// beyond 1e5 mm, a time beyond 1e7 s, less than nothing), does nothing; of one longer than 600 s the beginning counts.
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

}  // namespace lapfx
