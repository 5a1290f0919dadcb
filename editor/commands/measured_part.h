// The parts of a picture that `lapfx measure` is told to look at, to leave out, or to take for blood. Each is in
// pixels, or in fractions of the picture if none of its numbers is above 1. All throw Error (bad_input).
#pragma once

#include <string>
#include <vector>

#include "match/frame/blood_strokes.h"
#include "match/picture/view.h"

namespace lapfx::commands {

/// --mask: the corners of a polygon, "x,y,x,y,x,y", or a JSON file of polygons, [[[x,y],...],...].
std::vector<match::MaskPolygon> masks_of(const std::string& text, glm::ivec2 size);
/// --roi: "x,y,width,height" as fractions of the picture.
glm::dvec4 region_of(const std::string& text, glm::ivec2 size);
/// --view: "x,y,r" as fractions of width, height and height; fractions if neither x nor y is above 1.
glm::dvec3 round_view_of(const std::string& text, glm::ivec2 size);
/// --blood: a file of strokes (match/frame/blood_strokes.h).
match::BloodStrokes strokes_of(const std::string& file, glm::ivec2 size);

}  // namespace lapfx::commands
