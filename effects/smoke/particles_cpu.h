// Specks of burning fat that fly off the tool tip (the paper's future work: "tiny fat particles dislodge from the fat
// tissue and fly around"). Closed form: where a speck is follows from the seed, its contact, its number and the time
// alone, so any time can be asked for in any order. Pure functions, any thread.
//
//   born      (n + chance) / rate after the contact's start while it burns; comes to be if chance < power * fat
//   velocity  v(t) = (v0 + s) exp(-t / drag_time) - s,  s = settling * size^2 down: air slows it, then it sinks
//   position  x(t) = tip + (v0 + s) drag_time (1 - exp(-t / drag_time)) - s t
//
// Power and fat decide whether a speck comes to be, not when: while a contact goes on and its fat is measured anew,
// specks that are there stay on their way.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "lapfx/preset.h"
#include "smoke/burns.h"

namespace lapfx::smoke {

/// s in which air takes 1 - 1/e of a speck's speed: with `speed` 40 mm/s it gets about 12 mm far, across the plume's
/// foot.
constexpr double drag_time = 0.3;
/// mm/s at which the largest specks sink in the end: a droplet of fat of 35 um (Stokes: 900 kg/m3 in air), which is far
/// smaller than it looks while it glows.
constexpr double settling = 35.0;
constexpr double glow_time = 0.15;  ///< s in which a speck's glow falls to 1/e

constexpr std::size_t most_particles = 256;  ///< at a time; older ones are left out

struct Particle {
    glm::vec3 position{0.0f};  ///< mm
    float diameter = 0.0f;     ///< mm
    float opacity = 0.0f;      ///< 0..1: fades at the end of its life
    float glow = 0.0f;         ///< 0..1
    std::uint32_t shape = 0;   ///< by chance
};

/// Those of `parts` that are seen at `time`, into `into` (most_particles at most), the newest first; gives how many.
/// `up`: unit. Parts that started together at one place have the same specks.
std::size_t particles_at(std::span<const BurnPart> parts, const ParticleParameters& parameters, glm::dvec3 up,
                         std::uint32_t seed, double time, std::span<Particle> into) noexcept;

}  // namespace lapfx::smoke
