// The wounds that explain a measured area of blood, without drawing: the core's own amounts (lapfx/amounts.h) say what
// wounds would bleed, and the ones that are told apart by the data are looked for, one after another.
//
//     const WoundsFound found = wounds_of(points, {.scene = scene, .preset = preset, .organ = organ,
//                                                  .share_per_mm2 = share, .elsewhere = places});
//     scene.events = found.events;
//     preset.bleeding.speed = found.speed, preset.bleeding.max_extent = found.max_extent;
//
// How far blood has travelled is closed in time, and how large an area it then has depends only on the place. So the
// area of each place is tabulated once; the tables are fitted to the curve, and the core's own area of what was found
// corrects them (wounds run into one another, are coagulated, pulse), until both agree.
//
// Blood that becomes less is explained only by what the scene has: suction, irrigation, coagulation.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "lapfx/prepared_organ.h"
#include "lapfx/scene.h"

namespace lapfx::match {

/// A measured amount of blood at one time.
struct BloodPoint {
    double time = 0.0;    ///< s of the scene, ascending
    double blood = 0.0;   ///< share of the valid view, 0..1
    double error = 0.02;  ///< its standard error, above 0
};

/// More wounds are not looked for.
inline constexpr std::size_t most_wounds = 6;

/// Where and with what wounds are looked for. Refers to what it was given.
struct WoundSearch {
    const Scene& scene;  ///< its events, curves and gravity
    const Preset& preset;
    std::shared_ptr<const PreparedOrgan> organ;  ///< the scene's
    double share_per_mm2 = 0.0;                  ///< of the view, that 1 mm2 of blood covers (view_share.h)
    /// Where cuts may be added, mm, in the order in which they are taken, when the scene's own strokes are too few.
    std::span<const glm::dvec3> elsewhere = {};
    /// s over which errors of the measurement hang together: more points within count as one. Errors of neighbouring
    /// frames are alike, which is no evidence for a wound.
    double error_lasts = 1.0;
};

struct WoundFound {
    double start = 0.0;           ///< s, when it opens: under heat later than the event begins
    double strength = 1.0;        ///< of its event, factor on the preset's speed
    glm::dvec3 position{0.0};     ///< mm, of its event
    std::size_t event = 0;        ///< number of its first contact in WoundsFound::events
    bool added = false;           ///< a cut at one of the places `elsewhere`
    double start_error = 0.0;     ///< s, standard error
    bool start_is_known = false;  ///< within 0.5 s; not where its blood does not grow within the points
};

/// What the core would need for the curve. Speed and strength are in the data only as a product: the speed is found,
/// and strengths stay as the scene has them, unless wounds differ. Then that of the first wound stays.
struct WoundsFound {
    std::vector<WoundFound> wounds;  ///< in the order of their start; empty: the curve does not leave its error
    double speed = 0.0;              ///< bleeding.speed, mm/s, within the bounds of its row
    double max_extent = 0.0;         ///< bleeding.max_extent, mm, within the bounds of its row
    double speed_error = 0.0;        ///< its standard error, as a share of it
    bool speed_is_known = false;     ///< within 0.3 of it; else it is about the preset's
    /// Blood was seen to stop. Else max_extent is only known to be not less than at_least, and is the preset's where
    /// that is enough.
    bool max_extent_is_known = false;
    double at_least = 0.0;          ///< mm, how far the blood has travelled at the end
    bool strengths_differ = false;  ///< the wounds are not explained by the strengths of the scene
    /// The scene's events: those that divide tissue (whole strokes) have the times and strengths of the wounds, in the
    /// order of time; those that are too many have the strength 0, so that they still heat and smoke; cuts are added at
    /// the end. As they were where there are less than two points.
    std::vector<ToolContact> events;
    /// Numbers of the first contacts of strokes of the scene that divide but open no wound that lasts (no vessel is
    /// there, too little heat, a clip or another tool's heat closes it at once); they are as they were. Only of those
    /// that were tried: no more than the curve asks for.
    std::vector<std::size_t> open_nothing;
    double error = 0.0;   ///< root mean square of what is left, in standard errors of the points
    int evaluations = 0;  ///< curves that the core has worked out
};

/// Points that are not finite, whose error is not above 0, or whose time is not after that of the last one that counts
/// are left out. Below two points, or without a share_per_mm2 above 0, nothing is found. Takes tenths of a second to
/// two. Throws Error (bad_input) for a preset whose values are not allowed. Any thread.
WoundsFound wounds_of(std::span<const BloodPoint> points, const WoundSearch& search);

}  // namespace lapfx::match
