// The part of a clip's frame that may become smoke: the crop, the fade at its edges, and the masks. The shader
// (shaders/window.glsl) and its CPU reference (smoke/keying_pixel.h) both use these constants. Pure functions, any
// thread.
#pragma once

#include <algorithm>
#include <array>
#include <glm/glm.hpp>

#include "lapfx/authoring/clip_roles.h"
#include "lapfx/smoke_parameters.h"

namespace lapfx::smoke {

/// Pixels of the clip, from its upper left corner.
struct Window {
    glm::vec2 low, high;                     ///< the frame after the crop, in whole pixels
    glm::vec4 fades;                         ///< left, top, right, bottom: how far smoke fades inside the edges
    float softness = 0.0f;                   ///< how far smoke fades outside masks
    int masks = 0;                           ///< how many
    bool fills_view = false;                 ///< as ClipRoleRow::fills_view: only the frame after the crop is drawn
    std::array<glm::vec4, most_masks> mask;  ///< xy: upper left, zw: lower right corner
};

/// Fades and steps are at least this wide, pixels.
inline constexpr float least_fade = 1e-3f;

inline bool has_window(const SmokeClip& clip) {
    return clip.crop != ClipCrop{} || clip.edge_fade > 0.0 || !clip.masks.empty();
}

inline Window window_of(const SmokeClip& clip, glm::ivec2 size) {
    const glm::dvec2 whole(size);
    const glm::dvec2 from = glm::round(whole * glm::dvec2(clip.crop.left, clip.crop.top));
    const glm::dvec2 to = whole - glm::round(whole * glm::dvec2(clip.crop.right, clip.crop.bottom));
    const double fade = clip.edge_fade * std::min(whole.x, whole.y);
    Window window{.low = from, .high = glm::max(to, from + 1.0), .fades = glm::vec4(least_fade), .mask = {}};
    window.fills_view = row_of(clip.role).fills_view;
    window.softness = std::max(static_cast<float>(fade), least_fade);
    if (!window.fills_view) {  // smoke is not faded where it starts, however close that is to an edge
        const glm::dvec2 source = whole * glm::dvec2(clip.source_x, clip.source_y);
        const glm::dvec4 room(source - from, to - source);
        window.fades = glm::max(glm::vec4(glm::min(room, glm::dvec4(fade))), least_fade);
    }
    window.masks = static_cast<int>(std::min(clip.masks.size(), most_masks));
    for (int i = 0; i < window.masks; ++i) {
        const ClipMask& m = clip.masks[static_cast<std::size_t>(i)];
        window.mask[static_cast<std::size_t>(i)] =
            glm::dvec4(m.x * whole.x, m.y * whole.y, (m.x + m.width) * whole.x, (m.y + m.height) * whole.y);
    }
    return window;
}

}  // namespace lapfx::smoke
