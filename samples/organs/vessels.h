// Vessel networks, grown over a patch by space colonisation: points scattered over the tissue need blood, and the
// nearest vessel grows towards them. The points come in waves, few and far apart at first, so that stems and branches
// form before twigs. Radii follow Murray's law (the cubes of the branches add up to the cube of the stem).
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "patch.h"

namespace organs {

struct VesselNode {
    dvec2 uv{0.0};
    dvec3 position{0.0};
    int parent = -1;  ///< comes before its children
    double radius = 0.1;
};
using VesselTree = std::vector<VesselNode>;

struct Growth {
    std::vector<std::vector<dvec2>> stems;  ///< where the network starts: lines over the patch, uv
    int waves = 4;
    int demands = 14;         ///< number of points in the first wave; each next wave has three times as many
    double step = 1.3;        ///< mm
    double satisfied = 2.4;   ///< mm: in the last wave, a point this close to a vessel has enough blood
    double capillary = 0.10;  ///< radius at the ends, mm
    double thickest = 0.9;    ///< mm
    double winding = 1.6;     ///< how far vessels deviate from a straight line, mm
    std::uint32_t seed = 1;
    std::function<double(const SurfacePoint&)> demand;  ///< 0..1, where points are wanted; none = everywhere
};
VesselTree grow(const Patch& patch, const Growth& growth);

}  // namespace organs
