// A scene's events as a person sees them: contacts that continue each other (lapfx/tool.h) are one stroke and are
// moved, stretched and erased together. Pure functions.
//
//     for (const app::Stroke& stroke : app::strokes_of(scene.events))
//         show(row_of(stroke.action).title, stroke.start, stroke.end);
//     document.change("Move event", [&](Content& c) { app::move_stroke(c.scene.events, stroke, 3.5); });
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "lapfx/tool.h"

namespace lapfx::app {

inline constexpr std::size_t most_events = 4096;  ///< a scene has no more
inline constexpr double last_event_time = 3600;   ///< s, also the longest duration

/// Contacts that continue each other, from press to release.
struct Stroke {
    std::vector<std::size_t> events;  ///< indices, in the order of their times
    ToolAction action = ToolAction::cauterise;
    double start = 0, end = 0;  ///< s
};

/// In the order of the first event of each. Contacts are joined as the core joins them, except those that it takes only
/// in part or not at all (longer than 600 s, or with absurd values; lapfx/tool.h).
std::vector<Stroke> strokes_of(std::span<const ToolContact> events);

/// The stroke begins at `start` s; its length stays.
void move_stroke(std::span<ToolContact> events, const Stroke& stroke, double start);
/// The stroke lasts from `start` to `end` s; the path stays, quicker or slower.
void stretch_stroke(std::span<ToolContact> events, const Stroke& stroke, double start, double end);
/// The whole path is shifted by so many mm.
void shift_stroke(std::span<ToolContact> events, const Stroke& stroke, const glm::dvec3& by);
void erase_events(std::vector<ToolContact>& events, std::span<const std::size_t> erased);

/// What was recorded, with as few contacts as keep the tip within `tolerance` mm of where it was; times to 0.1 ms,
/// places to 1 um.
std::vector<ToolContact> simplified(std::span<const ToolContact> recorded, double tolerance = 0.2);

}  // namespace lapfx::app
