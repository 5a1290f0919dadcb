// How different two colours look: CIE Delta E 2000, and the CIE L*a*b* that it is told from.
//
//     const double difference = delta_e_2000(lab_of({0.57, 0.03, 0.04}), lab_of({0.62, 0.05, 0.05}));
//
// About 1 is just seen where two patches touch; 5 is plain; black and white are 100 apart. Formula and the pairs that
// test it: Sharma, Wu and Dalal, "The CIEDE2000 color-difference formula: implementation notes, supplementary test
// data, and mathematical observations", Color Research and Application 30(1), 2005. All weights k are 1.
// Pure functions, any thread; nothing throws.
#pragma once

#include <glm/glm.hpp>

namespace lapfx::match {

/// L* 0..100, a* (green to red) and b* (blue to yellow) of an sRGB colour, 0..1, white D65. What is outside is clamped.
glm::dvec3 lab_of(const glm::dvec3& srgb);
/// The same of linear light, 0..1, red, green, blue.
glm::dvec3 lab_of_linear(const glm::dvec3& linear);

/// Of two colours in L*a*b*; 0 or more, the same in both orders. Beyond some 20 it orders colours, but is no measure.
double delta_e_2000(const glm::dvec3& a, const glm::dvec3& b);

}  // namespace lapfx::match
