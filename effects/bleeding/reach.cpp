#include "lapfx/authoring/reach.h"

#include <algorithm>

#include "bleeding/front.h"
#include "bleeding/terrain.h"

namespace lapfx {

BloodReach blood_reach(const BleedingParameters& p) {
    const double all = p.max_extent <= 0.0 ? 0.0 : std::max(0.0, p.max_extent + p.noise_strength - p.threshold);
    const double crease = 1.0 - bleeding::Terrain::most_drawn * p.crease_bias;
    // The front has the same: gravity alone drives no blood.
    const double steep = std::max(crease, std::min(1.0, p.gravity_bias + bleeding::least_cost));
    return {.level = all,
            .downhill = all / (1.0 - p.gravity_bias),
            .fold = all / (p.crease_bias > 0.0 ? steep : 1.0),
            .down_fold = all / ((p.crease_bias > 0.0 ? steep : 1.0) - p.gravity_bias)};
}

}  // namespace lapfx
