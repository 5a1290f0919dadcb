// What an instrument does to the organ. Lengths mm in organ space, times s. Plain data.
#pragma once

#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <iterator>
#include <string_view>

#include "lapfx/bleeding_parameters.h"
#include "lapfx/rows.h"

namespace lapfx {

enum class ToolAction { cauterise, cut, coagulate, tear, suction, irrigation, clip };

/// Everything about an action: one row each, in the order of the enumerators. Code that acts asks what the row says
/// that an action does, and for no enumerator: so an action that does what others do is a row alone, here, and a name
/// in lapfx.h and lapfx.py, which tests compare with it.
struct ToolActionRow {
    ToolAction action;
    std::string_view key;    ///< JSON has this name for it: "cauterise"
    std::string_view title;  ///< "Cauterise"
    std::string_view help;   ///< what it does, in a few words for behind a colon
    std::string_view
        reach;  ///< the preset's parameter that says how far around the tip it works, mm: "cautery.tip_radius"
    bool divides = false;   ///< opens wounds, with the strength of the contact
    double strength = 1.0;  ///< factor on that strength
    bool frays = false;     ///< divides with a wide, ragged edge that leaves strands
    bool hot = false;       ///< heats, with the power of the contact, and smokes
    bool gentle = false;    ///< its heat stays below charring
    /// Removes blood within this distance of its way, mm, also where the tip does not touch; null: it removes none.
    double BleedingParameters::*clears = nullptr;
    bool rinses = false;       ///< what it clears runs downhill, so it reaches farther there
    bool takes_smoke = false;  ///< haze leaves while it works
    bool sets_clip = false;    ///< leaves a metal clip where the stroke begins
    char shortcut = 0;         ///< in the editor
    int color = 0;             ///< colour of its track on a timeline: 0 to 7, index into the series of a theme
};

inline constexpr ToolActionRow tool_actions[] = {
    {.action = ToolAction::cauterise,
     .key = "cauterise",
     .title = "Cauterise",
     .help = "heat that closes wounds, chars tissue, and divides it above the cut temperature; smokes",
     .reach = "cautery.tip_radius",
     .divides = true,
     .hot = true,
     .shortcut = '1',
     .color = 0},
    {.action = ToolAction::cut,
     .key = "cut",
     .title = "Cut",
     .help = "divides tissue without heat: bleeds at once, no smoke",
     .reach = "vessels.region",
     .divides = true,
     .shortcut = '2',
     .color = 1},
    {.action = ToolAction::coagulate,
     .key = "coagulate",
     .title = "Coagulate",
     .help = "gentle heat, below charring, that closes wounds; smokes",
     .reach = "cautery.tip_radius",
     .hot = true,
     .gentle = true,
     .shortcut = '3',
     .color = 2},
    {.action = ToolAction::tear,
     .key = "tear",
     .title = "Tear",
     .help = "blunt dissection: bleeds at once, 0.6 times as strongly as a cut, no smoke",
     .reach = "vessels.region",
     .divides = true,
     .strength = 0.6,  // it crushes the vessels that it opens, so they bleed less
     .frays = true,
     .shortcut = '4',
     .color = 3},
    {.action = ToolAction::suction,
     .key = "suction",
     .title = "Suction",
     .help = "removes blood around the tip, which need not touch the tissue, and haze",
     .reach = "bleeding.suction_radius",
     .clears = &BleedingParameters::suction_radius,
     .takes_smoke = true,
     .shortcut = '5',
     .color = 4},
    {.action = ToolAction::irrigation,
     .key = "irrigation",
     .title = "Irrigation",
     .help = "rinses blood away around the tip, which need not touch the tissue, and downhill of it",
     .reach = "bleeding.irrigation_radius",
     .clears = &BleedingParameters::irrigation_radius,
     .rinses = true,
     .shortcut = '6',
     .color = 5},
    {.action = ToolAction::clip,
     .key = "clip",
     .title = "Clip",
     .help = "sets a metal clip where the stroke begins; it stays, and bleeding under it stops at once",
     .reach = "cautery.clip_reach",
     .sets_clip = true,
     .shortcut = '7',
     .color = 6},
};

inline constexpr std::size_t tool_action_count = std::size(tool_actions);
static_assert(rows_follow<&ToolActionRow::action>(tool_actions));

constexpr const ToolActionRow& row_of(ToolAction action) noexcept {
    return tool_actions[static_cast<std::size_t>(action)];
}

/// Whether it divides tissue, so that a wound may open.
constexpr bool divides(ToolAction action) noexcept {
    return row_of(action).divides;
}

/// The tool touches the organ from `time` for `duration`, its tip moving straight from `position` to `to`. Contacts
/// that continue each other (goes_on) form one stroke: what one tool does from press to release, a polyline whose power
/// and strength may change. A tip farther than 5 mm from the organ's surface touches nothing; nearer, it acts as if it
/// were on the surface. A moving tip chars up to about 2 * tip_radius * heat_rate * power / (char_temperature - 37)
/// mm/s, and divides up to the same with cut_temperature: 5.8 and 4.6 mm/s with the defaults of a preset's cautery. A
/// faster one smokes, and may blanch tissue, no more. A contact with values that are not finite or absurd (a path over
/// 1000 mm, a coordinate beyond 1e5 mm, a time beyond 1e7 s, a negative duration) does nothing. Only the first 600 s of
/// a contact count.
struct ToolContact {
    ToolAction action = ToolAction::cauterise;
    double time = 0.0;
    double duration = 1.0;
    glm::dvec3 position{0.0};
    glm::dvec3 to{0.0};     ///< not `position` by default: set both, also for a tip that stands still
    double power = 1.0;     ///< cautery power, 0..1
    double strength = 1.0;  ///< strength of the wound, a factor on the preset's speed

    friend bool operator==(const ToolContact&, const ToolContact&) = default;
    double end() const { return time + duration; }
    /// Where the tip is at `t`; before the contact its first place, after the contact its last.
    glm::dvec3 tip(double t) const {
        const double share = duration > 0.0 ? glm::clamp((t - time) / duration, 0.0, 1.0) : 1.0;
        return glm::mix(position, to, share);
    }
    bool hot() const { return row_of(action).hot; }
};

/// Greatest distance between two contacts of one stroke, mm. When only the power changes, the next contact starts where
/// the tip is one sample (1 ms) later, and a tip at 500 mm/s moves this far. No other tool can be there at that moment.
inline constexpr double stroke_joint = 0.5;

/// Whether `next` continues where `contact` ends, so that both belong to one stroke. Times that were read from a file
/// are rounded.
inline bool goes_on(const ToolContact& contact, const ToolContact& next) noexcept {
    return contact.action == next.action && std::abs(contact.end() - next.time) <= 1e-6 &&
           glm::distance(contact.to, next.position) <= stroke_joint;
}

}  // namespace lapfx
