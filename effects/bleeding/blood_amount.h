// Area and volume of the blood on a surface, kept up with what changes: it costs the triangles whose values have
// changed since it was last asked for. In whole units, so that the sum is the same in whatever order it came to be. One
// thread at a time.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "lapfx/preset.h"
#include "organ/surface.h"

namespace lapfx::bleeding {

/// Blood on the whole organ.
struct BloodAmount {
    double area = 0.0;  ///< mm2 of surface above the threshold, noise aside
    /// mm3: a layer that rises from its edge to `thickness` where the colour gradient ends (deep_at).
    double volume = 0.0;
};

class AmountSum {
  public:
    /// Keeps a reference to `surface`, on which there is no blood yet.
    explicit AmountSum(const Surface& surface) : surface_(surface), state_(surface.triangles.size(), untouched) {}

    /// The value of a surface vertex has changed.
    void mark(std::uint32_t vertex) noexcept;
    /// threshold, thickness or deep_at has changed.
    void mark_all() noexcept;
    /// No vertex has blood any more.
    void clear() noexcept;
    /// `values`: per surface vertex, bleed value and clot.
    BloodAmount measure(std::span<const glm::vec2> values, const BleedingParameters& parameters) noexcept;

  private:
    enum State : char { untouched, measured, marked };
    struct Part {
        std::int64_t area = 0, volume = 0;
    };
    static constexpr double unit = 1e-6;  // mm2, mm3

    const Surface& surface_;
    std::vector<char> state_;             // per triangle
    std::vector<Part> parts_;             // per triangle; empty until there is blood
    std::vector<std::uint32_t> touched_;  // triangles that have had blood
    std::vector<std::uint32_t> marked_;
    Part sum_;
};

}  // namespace lapfx::bleeding
