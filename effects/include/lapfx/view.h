// Where a frame is seen from, and the lamp beside the camera. Plain data; lengths mm.
#pragma once

#include <glm/glm.hpp>
#include <string_view>

#include "lapfx/camera.h"
#include "lapfx/rows.h"

namespace lapfx {

/// The endoscope's lamp, at the camera.
struct Lamp {
    double intensity = 1.0;         ///< a white surface that faces the lamp at the focus distance is lit to this
    double focus_distance = 100.0;  ///< mm
    double beam_angle = 75.0;       ///< degrees; whole angle within which the light is above half
    double ambient = 0.02;          ///< light from all around, as a share of the lamp's
    glm::dvec3 color{1.0};          ///< sRGB
};

/// False colour over the tissue, for tuning: what the effects use but the picture does not show.
enum class Overlay { none, vessels, fat, bleed };

/// One row for each overlay, in the order of the enumerators. The shader overlay.glsl draws them, and calls
/// them OVERLAY_NONE and so on.
struct OverlayRow {
    Overlay overlay;
    std::string_view key;           ///< `lapfx render --overlay` takes this name: "vessels"
    std::string_view title;         ///< "Vessels"
    std::string_view command = {};  ///< command of the editor that turns it on and off: "Vessel overlay"; empty: none
    std::string_view help;          ///< what its colours mean
    bool densities = false;         ///< shows the densities of vessels and fat, so these are sent to the GPU
    char shortcut = 0;              ///< in the editor
};

inline constexpr OverlayRow overlays[] = {
    {.overlay = Overlay::none, .key = "none", .title = "No overlay", .help = "The tissue as it is"},
    {.overlay = Overlay::vessels,
     .key = "vessels",
     .title = "Vessels",
     .command = "Vessel overlay",
     .help = "Density of vessels, blue",
     .densities = true,
     .shortcut = 'V'},
    {.overlay = Overlay::fat,
     .key = "fat",
     .title = "Fat",
     .command = "Fat overlay",
     .help = "Density of fat, yellow",
     .densities = true,
     .shortcut = 'T'},
    {.overlay = Overlay::bleed,
     .key = "bleed",
     .title = "Bleed value",
     .command = "Bleed value overlay",
     .help = "The bleed value: lines every 2 mm, from blue at 0 to red at 20 mm",
     .shortcut = 'G'},
};

static_assert(rows_follow<&OverlayRow::overlay>(overlays));

constexpr const OverlayRow& row_of(Overlay overlay) noexcept {
    return overlays[static_cast<std::size_t>(overlay)];
}

/// Where the frame is seen from.
struct View {
    // As GLM has them, column by column: an engine that keeps matrices row by row transposes them.
    glm::mat4 view{1.0f};        ///< organ space to camera space, rigid
    glm::mat4 projection{1.0f};  ///< OpenGL clip space, z in -1..1, perspective
    Lamp lamp;
    bool haze = true;              ///< false: left out, as of a look from far away
    CameraResponse response = {};  ///< with which the finished frame is shown; only a plate needs it (lapfx/scene.h)
};

}  // namespace lapfx
