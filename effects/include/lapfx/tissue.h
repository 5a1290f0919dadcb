// What the organ's colours tell of its tissue: where vessels run and where there is fat (paper: figure 9).
// Formulas and what they were measured on: effects/bleeding/vessel_parameters.cpp. Plain data; any thread.
#pragma once

#include "lapfx/organ.h"
#include "lapfx/preset.h"

namespace lapfx {

/// The tissue around a place: means over the tool tip's region of influence (`region`, mm).
struct TissueSample {
    double vessels = 0.0;  ///< 0..1, share of the region that is vessel; 1 where the organ has no colour
    double fat = 0.0;      ///< 0..1, share of the region that is fat; 0 where the organ has no colour
};

/// What `lapfx inspect` tells of the tissue.
struct TissueReport {
    double known = 0.0;          ///< share of the surface that has colour, 0..1; the shares below are of this
    double vessels = 0.0;        ///< share that is vessel, 0..1
    double fat = 0.0;            ///< share that is fat, 0..1
    double texels_per_mm = 0.0;  ///< of the finest texture that was looked at; 0: vertex colours, or none
};

/// Throws nothing but std::bad_alloc. `parameters` must be in range (they are when they come from a preset).
TissueReport report_tissue(const Organ& organ, const VesselParameters& parameters = {});

}  // namespace lapfx
