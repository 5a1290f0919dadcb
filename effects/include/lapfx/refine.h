// Coarse organs made fine enough for blood.
//
// The vertices of an organ carry blood, burns and densities. A triangle larger than a pool would have no vertex inside
// the pool, so Effects, PreparedOrgan and AmountsModel split long triangles. A host that draws a coarse organ with its
// own shader splits it first, so that it draws the vertices of Effects::bleed_buffer():
//
//     const lapfx::Organ organ = lapfx::refine(lapfx::load_organ("liver.obj")).organ;
//     lapfx::Effects effects(organ, preset);                    // finds nothing left to split
//
// Any thread.
#pragma once

#include "lapfx/api.h"
#include "lapfx/organ.h"

namespace lapfx {

/// An organ whose long triangles are split; its shape is the same.
struct RefinedOrgan {
    Organ organ;  ///< the vertices of the given organ come first, in their order
    /// For each further vertex, the two vertices that it is midway between; both come before it. Empty when no edge was
    /// too long.
    std::vector<glm::uvec2> midpoints;
};

/// Splits edges longer than 2 mm without making cracks, also along texture seams. It adds at most 300,000 triangles;
/// where that is not enough (a whole abdomen, a room, a wrong unit), edges that are long in the file stay longer.
/// Throws Error (bad_input) for an organ that is not complete (organ.h).
LAPFX_API RefinedOrgan refine(Organ organ);

}  // namespace lapfx
