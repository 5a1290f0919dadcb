// A place that bleeds. Plain data; closed form in time.
#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace lapfx {

struct Wound {
    glm::dvec3 position{0.0};                               ///< mm, organ space, on or near the surface
    double start = 0.0;                                     ///< s
    double strength = 1.0;                                  ///< times the preset's speed
    double stop = std::numeric_limits<double>::infinity();  ///< s, when coagulation begins

    friend bool operator==(const Wound&, const Wound&) = default;
};

}  // namespace lapfx
