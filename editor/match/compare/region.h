// What a rectangle of a picture looks like, in figures that two pictures can be compared by: that of the reference and
// that of the preview, which need not show the same tissue.
//
//     match::RegionFigures ours = match::figures_of(preview, region, blood), theirs = match::figures_of(frame, ...);
//     double apart = match::distance(ours, theirs);
//
// Pure functions, any thread; they allocate nothing.
#pragma once

#include <glm/glm.hpp>

#include "lapfx/organ.h"
#include "lapfx/scene.h"

namespace lapfx::match {

struct RegionFigures {
    glm::dvec3 color{0.0};  ///< the mean, taken in linear light; sRGB, 0..1
    double contrast = 0.0;  ///< standard deviation of the luma, 0..1
    /// Mean dark channel, 0..1: the least of all channels near by, which clear tissue has dark and smoke lifts (He, Sun
    /// and Tang 2009).
    double veil = 0.0;
    double red = 0.0;  ///< share of the area that is as red, and no brighter, than the qualifier says of blood
};

/// At most some 65,000 pixels are looked at, evenly. All 0 for a picture without pixels.
RegionFigures figures_of(const Image& image, const ComparedRegion& region, const BloodQualifier& blood);

/// Between the mean colours, CIE 1976 (delta E*ab): 2 is just seen, 10 is plain.
double distance(const RegionFigures& a, const RegionFigures& b);

}  // namespace lapfx::match
