// How the shape of an organ affects blood that runs over it: the depth of each point, creases that guide blood, and
// places where another part is so close that blood runs across. Each value is computed when blood first comes near, and
// kept, so the cost depends on the blood and not on the organ. One thread at a time.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "organ/surface.h"

namespace lapfx::bleeding {

class Terrain {
  public:
    /// Keeps a reference to `surface`. `down`: unit, organ space.
    Terrain(const Surface& surface, glm::dvec3 down);

    /// Depth of a point below the origin, mm.
    double drop(std::uint32_t point) const { return glm::dot(surface_.positions[point], down_); }

    /// How deep a point is in a crease, mm: above 0 where the surface around it rises more than in a smooth fold, below
    /// 0 on a ridge; 0 on a plane, a cylinder and a sphere. It is the mean height of the surface 2.5 mm around the
    /// point over its tangent plane, without the part that the curvature 5 mm around it explains.
    double crease(std::uint32_t point);

    /// Cost of one mm at a point for blood that creases attract by `crease_bias` (0..1): 1 on smooth tissue, down to
    /// 0.35 in a crease and where two parts meet, up to 1.33 across a ridge.
    double slowness(std::uint32_t point, double crease_bias);

    /// The nearest place on another component within `bridge_longest` mm of a point; null when there is none.
    const SurfacePoint* bridge(std::uint32_t point);

    static constexpr double bridge_longest = 5.0;  // mm
    static constexpr double most_drawn = 0.65;     // share of a mm that a crease saves at crease_bias 1

  private:
    bool section_heights(std::uint32_t point, const glm::dvec3& normal, const glm::dvec3& direction, double& near,
                         double& far) const;

    const Surface& surface_;
    glm::dvec3 down_;
    std::vector<float> crease_;          // per point, NaN: not yet known
    std::vector<std::int32_t> bridges_;  // per point, into places_; see bridge()
    std::vector<SurfacePoint> places_;
};

}  // namespace lapfx::bleeding
