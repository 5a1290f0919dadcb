// Turns the contents of a file into an organ that can be drawn.
#pragma once

#include "organ/raw.h"

namespace lapfx::organ {

/// The attributes that complete() has to make.
struct Missing {
    std::vector<char> uvs;  ///< for each part: it has no texture coordinates that could be used
};

/// Joins the parts into one organ and leaves out what cannot be drawn: triangles with NaN, with indices out of range,
/// without area or given twice, and vertices without a triangle. It also sews torn seams. Each kind is counted in
/// Organ::counts and named in a warning. This happens in the file's units, before scaling, because having an area does
/// not depend on the unit. `scale` is mm per unit. Throws Error when no triangle is left, with the reason for most of
/// them. Attributes that the file lacks are zero; colours are white.
Organ mend(RawOrgan&& raw, const std::string& file, double scale, Missing& missing);

/// Makes missing normals (smooth), texture coordinates and tangents; existing normals and tangents become unit length.
/// A texture that has to repeat for made coordinates, and not for those of another part, is there twice from then on;
/// `encoded`, if given, has the file of each image, and gets that of the copy.
void complete(Organ& organ, const Missing& missing, std::vector<Encoded>* encoded = nullptr);

}  // namespace lapfx::organ
