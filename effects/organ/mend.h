// From what a file holds to what can be drawn.
#pragma once

#include "organ/raw.h"

namespace lapfx::organ {

/// What complete() has to make.
struct Missing {
    std::vector<char> uvs;  ///< for each part: it has no texture coordinates that could be used
};

/// Joins the parts into one organ without what cannot be drawn: triangles with NaN, with indices out of range, without
/// area or given twice, and vertices that belong to no triangle; sews torn seams. Each kind is counted in Organ::counts
/// and named in a warning. Done in the file's units, before anything is scaled: what has no area does not depend on the
/// unit. `scale` is mm per unit. Throws Error when no triangle is left, with the reason for most of them. Attributes
/// that the file lacks are zero; colours are white.
Organ mend(RawOrgan&& raw, const std::string& file, double scale, Missing& missing);

/// Makes what is missing: smooth normals, texture coordinates, tangents; all others become unit length.
void complete(Organ& organ, const Missing& missing);

}  // namespace lapfx::organ
