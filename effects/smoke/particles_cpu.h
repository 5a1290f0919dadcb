// Specks of burning fat that fly off the tool tip (the paper's future work: "tiny fat particles dislodge from the fat
// tissue and fly around"). In closed form: the place of a speck depends only on the seed, its contact, its number and
// the time, so times may come in any order. Pure functions, any thread.
//
//   born      (n + chance) / rate after the contact's start while it burns; exists if chance < power * fat
//   velocity  v(t) = (v0 + s) exp(-t / drag_time) - s,  s = settling * size^2 down: air slows it, then it sinks
//   position  x(t) = tip + (v0 + s) drag_time (1 - exp(-t / drag_time)) - s t
//
// Power and fat decide whether a speck exists, not when it starts: while a contact continues and its fat is measured
// again, existing specks keep their paths.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "lapfx/smoke_parameters.h"
#include "smoke/burns.h"

namespace lapfx::smoke {

/// s in which air removes 1 - 1/e of a speck's speed: at `speed` 40 mm/s it travels about 12 mm, across the foot of the
/// plume.
constexpr double drag_time = 0.3;
/// final speed at which the largest specks sink, mm/s: that of a droplet of fat of 35 um (Stokes: 900 kg/m3 in air),
/// which is much smaller than it looks while it glows.
constexpr double settling = 35.0;
constexpr double glow_time = 0.15;  ///< s in which a speck's glow falls to 1/e

constexpr std::size_t most_particles = 256;  ///< no more live at a time; older ones are left out

struct Particle {
    glm::vec3 position{0.0f};  ///< mm
    float diameter = 0.0f;     ///< mm
    float opacity = 0.0f;      ///< 0..1: fades at the end of its life
    float glow = 0.0f;         ///< 0..1
    std::uint32_t shape = 0;   ///< random
};

/// Writes the visible specks of `parts` at `time` into `into` (at most most_particles), the newest first, and gives
/// their number. `up`: unit. Parts that started together at one place have the same specks.
std::size_t particles_at(std::span<const BurnPart> parts, const ParticleParameters& parameters, glm::dvec3 up,
                         std::uint32_t seed, double time, std::span<Particle> into) noexcept;

}  // namespace lapfx::smoke
