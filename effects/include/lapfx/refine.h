// Coarse organs made fine enough for blood.
//
// Blood, burns and densities are carried by an organ's vertices: on triangles larger than a pool there would be none to
// carry it. So Effects, PreparedOrgan and AmountsModel split long triangles for themselves. A host that draws a coarse
// organ with a shader of its own splits it first, so as to draw the vertices that Effects::bleed_buffer() has:
//
//     const lapfx::Organ organ = lapfx::refine(lapfx::load_organ("liver.obj")).organ;
//     lapfx::Effects effects(organ, preset);                    // finds nothing left to split
//
// Any thread.
#pragma once

#include "lapfx/organ.h"

namespace lapfx {

/// An organ whose long triangles have been split, without a change of its shape.
struct RefinedOrgan {
    Organ organ;  ///< the vertices of the given organ come first, in their order
    /// Of each vertex after those: the two that it lies midway between, which come before it. Empty: nothing was too
    /// long.
    std::vector<glm::uvec2> midpoints;
};

/// Splits edges longer than 4.5 mm, conforming: no cracks, also along texture seams. It adds at most 400,000 triangles;
/// where that is not enough (a room, a wrong unit) only longer edges are split.
RefinedOrgan refine(Organ organ);

}  // namespace lapfx
