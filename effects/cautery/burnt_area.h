// The area of tissue that is at least as brown as at the char temperature, from the highest rise at each point of the
// surface. One thread at a time.
//
// The logarithm of a bell of heat is a paraboloid. On edges as long as the bell is wide, a linear value between the
// points lies below it all over, by as much as the next points show: without that the area would depend on the mesh.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "organ/surface.h"

namespace lapfx::cautery {

class BurntArea {
  public:
    /// Degrees below which a rise counts as this one.
    static constexpr double least_rise = 2.0;

    /// Keeps a reference.
    explicit BurntArea(const Surface& surface) : surface_(surface) {}

    /// The rise of this point has changed.
    void mark(std::uint32_t point);
    /// Takes the rises of all points, degrees above the body; tissue is burnt from `wanted` on, never: nowhere.
    void measure(std::span<const float> rises, double wanted);
    double area() const { return static_cast<double>(sum_) * unit; }  ///< mm2, at rest

  private:
    // In whole units, so that the sum does not depend on the order of changes.
    static constexpr double unit = 1e-6;  // mm2

    double share(std::uint32_t triangle, std::span<const float> rises, double wanted) const;
    double curvature(std::uint32_t triangle, std::span<const float> rises) const;

    const Surface& surface_;
    std::int64_t sum_ = 0;
    std::vector<std::int64_t> parts_;  // per triangle; empty until something is warm
    std::vector<char> is_marked_;      // per triangle
    std::vector<std::uint32_t> marked_;
};

}  // namespace lapfx::cautery
