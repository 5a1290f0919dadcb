// Vessel networks, grown over a patch by space colonisation: points scattered over the tissue ask for blood,
// the nearest vessel grows towards them. Radii follow Murray's law (the cubes of the branches add up to the
// cube of the stem).
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "patch.h"

namespace organs {

struct VesselNode {
    dvec2 uv{0.0};
    dvec3 position{0.0};
    int parent = -1;  ///< lies before its children
    double radius = 0.1;
};
using VesselTree = std::vector<VesselNode>;

struct Growth {
    std::vector<std::vector<dvec2>> stems;  ///< where the network starts: lines over the patch, uv
    int demands = 800;                      ///< how many points ask for blood
    double step = 1.3;                      ///< mm
    double satisfied = 2.6;                 ///< mm: a point this near to a vessel is content
    double capillary = 0.11;                ///< radius at the ends, mm
    double thickest = 1.0;                  ///< mm
    double winding = 0.8;                   ///< how far vessels wander off the straight way, mm
    std::uint32_t seed = 1;
    std::function<double(const SurfacePoint&)> demand;  ///< 0..1, where points are wanted; none = everywhere
};
VesselTree grow(const Patch& patch, const Growth& growth);

}  // namespace organs
