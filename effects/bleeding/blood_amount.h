// Area and volume of the blood on a surface. An update costs only the triangles whose values have changed since the
// last one. Sums are in whole units, so that they do not depend on the order of updates. One thread at a time.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "lapfx/bleeding_parameters.h"
#include "organ/surface.h"

namespace lapfx::bleeding {

/// Blood on the whole organ.
struct BloodAmount {
    /// mm2 of surface above the threshold, which noise moves: its mean over all noise of this strength.
    double area = 0.0;
    /// mm3: a layer that rises from its edge to `thickness` where the colour gradient ends (deep_at).
    double volume = 0.0;
};

class AmountSum {
  public:
    /// Keeps a reference to `surface`, which has no blood yet. `down`: unit, or 0 without gravity.
    AmountSum(const Surface& surface, const glm::dvec3& down)
        : surface_(surface), down_(down), state_(surface.triangles.size(), untouched) {}

    /// The value of a surface vertex has changed.
    void mark(std::uint32_t vertex) noexcept;
    /// A parameter other than those of the values has changed.
    void mark_all() noexcept;
    /// No vertex has blood any more.
    void clear() noexcept;
    /// `values`: per surface vertex, bleed value and clot.
    BloodAmount measure(std::span<const glm::vec2> values, const BleedingParameters& parameters) noexcept;

  private:
    enum State : char { untouched, measured, marked };
    struct Part {
        std::int64_t area = 0, volume = 0;  ///< of the blood
        double whole = 0.0;                 ///< mm2, of the triangle
        double steepness = 0.0;
    };
    static constexpr double unit = 1e-6;  // mm2, mm3

    double steepness(std::uint32_t triangle) const noexcept;

    const Surface& surface_;
    glm::dvec3 down_;
    std::vector<char> state_;             // per triangle
    std::vector<Part> parts_;             // per triangle; empty until there is blood
    std::vector<std::uint32_t> touched_;  // triangles that have had blood
    std::vector<std::uint32_t> marked_;
    std::int64_t area_ = 0, volume_ = 0;  // of all parts
};

}  // namespace lapfx::bleeding
