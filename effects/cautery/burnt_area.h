// The area of tissue that is at least as brown as at the char temperature, from the highest rise at each point of the
// surface. One thread at a time.
//
// The logarithm of a bell of heat is a paraboloid. On edges as long as the bell is wide, a linear value between the
// points lies below it all over, by as much as the next points show: without that the area would depend on the mesh.
#pragma once

#include <cstdint>
#include <span>

#include "organ/point_set.h"
#include "organ/surface.h"
#include "organ/triangle_sums.h"

namespace lapfx::cautery {

class BurntArea {
  public:
    /// Degrees below which a rise counts as this one.
    static constexpr double least_rise = 2.0;

    /// Keeps a reference.
    explicit BurntArea(const Surface& surface)
        : surface_(surface), changed_(surface.positions.size()), sum_(surface.triangles.size()) {}

    /// The rise of this point has changed. Its triangles are looked up when somebody measures.
    void mark(std::uint32_t point) { changed_.add(point); }
    /// Takes the rises of all points, degrees above the body; tissue is burnt from `wanted` on, never: nowhere.
    void measure(std::span<const float> rises, double wanted);
    double area() const { return sum_.sum(); }  ///< mm2, at rest

  private:
    void mark_triangles();
    double share(std::uint32_t triangle, std::span<const float> rises, double wanted) const;
    double curvature(std::uint32_t triangle, std::span<const float> rises) const;

    const Surface& surface_;
    organ::PointSet changed_;  // since the last measure()
    organ::TriangleSums<1> sum_;
};

}  // namespace lapfx::cautery
