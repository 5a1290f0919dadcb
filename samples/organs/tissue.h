// The look of tissues: colour and relief at a point. Colours are sRGB albedos, somewhat lighter than an endoscope shows
// them.
#pragma once

#include "canvas.h"

namespace organs {

Texel stomach_tissue(const SurfacePoint& at, const VesselCover& vessels);
Texel fat_tissue(const SurfacePoint& at, const VesselCover& vessels);
Texel liver_tissue(const SurfacePoint& at, const VesselCover& vessels);
/// The lesser omentum; mask = how fatty.
Texel membrane_tissue(const SurfacePoint& at, const VesselCover& vessels);
/// The gastrohepatic ligament: pale strands along it.
Texel ligament_tissue(const SurfacePoint& at, const VesselCover& vessels);
/// Diaphragm and abdominal wall; mask = how tendinous.
Texel wall_tissue(const SurfacePoint& at, const VesselCover& vessels);

/// Lobules of fat: `height` 0 in the creases to 1 on the domes, `crease` 1 in the creases.
struct Lobules {
    double height = 0.0;
    double crease = 0.0;
    std::uint32_t id = 0;
};
Lobules lobules(const dvec3& p, double size, std::uint32_t seed);

}  // namespace organs
