// Area and volume of the blood on a surface. An update costs only the triangles whose values have changed since the
// last one. One thread at a time.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "lapfx/bleeding_parameters.h"
#include "organ/point_set.h"
#include "organ/surface.h"
#include "organ/triangle_sums.h"

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
        : surface_(surface), down_(down), changed_(surface.positions.size()), sums_(surface.triangles.size()) {}

    /// The value of a surface vertex has changed. Its triangles are looked up when somebody measures, for those who
    /// never ask.
    void mark(std::uint32_t vertex) noexcept { changed_.add(vertex); }
    /// A parameter other than those of the values has changed.
    void mark_all() noexcept { sums_.mark_all(); }
    /// No vertex has blood any more.
    void clear() noexcept;
    /// `values`: per surface vertex, bleed value and clot.
    BloodAmount measure(std::span<const glm::vec2> values, const BleedingParameters& parameters) noexcept;

  private:
    struct Shape {
        double area = 0.0;  ///< mm2
        double steepness = 0.0;
    };

    void mark_triangles() noexcept;
    double steepness(std::uint32_t triangle) const noexcept;

    const Surface& surface_;
    glm::dvec3 down_;
    organ::PointSet changed_;      // vertices since the last measure()
    organ::TriangleSums<2> sums_;  // area, volume
    std::vector<Shape> shapes_;    // the index is the triangle's number in sums_
};

}  // namespace lapfx::bleeding
