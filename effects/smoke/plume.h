// Where and how dense the source smoke of one burn is at a time. Closed form; pure functions, any thread.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "lapfx/smoke_parameters.h"
#include "lapfx/tool.h"
#include "preset/factor_curve.h"
#include "smoke/burns.h"

namespace lapfx::smoke {

struct PlumeState {
    double density = 0.0;    ///< 0 = nothing to draw
    glm::dvec3 anchor{0.0};  ///< mm, where the source of the clip is
    double size = 0.0;       ///< mm, height that the whole clip would have in its own shape: its width follows
    double height = 0.0;     ///< mm, of the whole clip as drawn: it is longer the further its smoke has risen
    double widening = 1.0;   ///< width at the top, where smoke is oldest, as a part of that at the tip
};

/// s over which moving smoke comes to rest in the gas: smoke that the tool feeds rises and widens for about so long.
constexpr double carried_time = 2.0;

/// How much smoke a hot contact gives to plume and haze: its power, and more where the tissue is fat (0..1).
inline double emission(const ToolContact& contact, double fat, const PlumeParameters& plume) {
    return contact.power * (1.0 + plume.fat_gain * fat);
}

/// `parts`: of all burns. The plume stands on the tip while the tool burns. Smoke at its top is as old as the burn, but
/// slows down: age = carried_time * (1 - exp(-burning / carried_time)). So far it has risen and widened; smoke at the
/// tip is new. When the tool stops, all of it rises along `up` (unit), grows and fades. After a touch shorter than
/// `fade_in`, it never gets denser than at the end of the touch. Power and fat count as their mean over the last
/// `fade_in`: smoke follows them that slowly, so it does not flicker where one contact continues another. `factor`: on
/// the smoke over time.
PlumeState plume_state(const Burn& burn, std::span<const BurnPart> parts, const PlumeParameters& plume, glm::dvec3 up,
                       double time, const FactorCurve& factor = {}) noexcept;

/// How a clip is placed: the same for every frame with one random number.
struct ClipTurn {
    bool mirrored = false;  ///< left and right exchanged
    float angle = 0.0f;     ///< radians, counter-clockwise
};
ClipTurn clip_turn(const SmokeClip& clip, std::uint32_t chance) noexcept;

/// Where drawn coordinates lie in the clip of a plume that widens upwards, and how much thinner its smoke is there: as
/// much as it is wider, so that widening adds none. `source`: where the smoke starts, drawn coordinates (0..1, origin
/// top left). Mirrored by shaders/plume.glsl.
struct PlumePlace {
    glm::vec2 uv{0.0f};
    float thickness = 1.0f;
};
PlumePlace plume_place(glm::vec2 drawn, glm::vec2 source, float widening) noexcept;

/// The quad that shows a plume's clip; lengths mm.
struct PlumeQuad {
    glm::vec3 anchor{0.0f};        ///< camera space, where the smoke starts
    glm::vec2 extent{1.0f};        ///< width and height of the whole clip
    glm::vec2 source{0.5f, 1.0f};  ///< where in the clip as filmed the smoke starts, 0..1, origin top left
    glm::vec2 up{0.0f, 1.0f};      ///< unit, camera plane: where smoke rises to
    float lean = 0.0f;             ///< mm towards the camera per mm of rise; less near the lens
    ClipTurn turn{};
};

/// Camera space: top left, top right, bottom left, bottom right of the clip as drawn.
std::array<glm::vec3, 4> plume_corners(const PlumeQuad& quad) noexcept;

/// The part of the view (0..1, origin bottom left) that a quad covers: lower left, upper right corner. It is the whole
/// view when some of the quad is beside or behind the camera, and empty (upper right below lower left) when all of it
/// is or when it is outside the view.
glm::vec4 view_bounds(const std::array<glm::vec3, 4>& corners, const glm::mat4& projection) noexcept;

}  // namespace lapfx::smoke
