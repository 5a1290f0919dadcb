// How far blood can get from its wound. Bleeding's `max_extent` is a distance over level, smooth tissue: downhill and
// along folds a mm counts as less, so blood gets farther there.
//
//     const lapfx::BloodReach reach = lapfx::blood_reach(preset.bleeding);   // mm
//
// Any thread.
#pragma once

#include "lapfx/bleeding_parameters.h"

namespace lapfx {

/// mm over the surface, with the lobes of the noise; none is exceeded.
struct BloodReach {
    double level = 0.0;      ///< over level, smooth tissue
    double downhill = 0.0;   ///< straight down a smooth wall
    double fold = 0.0;       ///< along a level crease
    double down_fold = 0.0;  ///< straight down a crease
};
BloodReach blood_reach(const BleedingParameters& parameters);

}  // namespace lapfx
