// OBJ text as polygons.
//
// Not through OpenMesh 9.0: its OBJ reader takes repeated corners out of a polygon, so that a ring cut open around a
// hole loses its hole and two triangles, forgets a vertex whose coordinates are no numbers and so shifts all indices
// after it, reads past an empty list for "f /1/1", opens whatever file mtllib names, and keeps of a material only its
// texture.
//
// Not through tinyobjloader 2.0 either: it refuses a whole file for one corner whose normal has the number 0, as Cinema
// 4D writes them, loses triangles when it cuts concave polygons, and takes 2.5 times as long.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "organ/soup.h"

namespace lapfx::organ {

struct ObjText {
    Soup soup;

    /// Faces from `first_face` on belong to a material and an object.
    struct Run {
        std::size_t first_face = 0;
        std::string material;
        std::string name;
    };
    std::vector<Run> runs;
    std::vector<std::string> libraries;  ///< mtllib
};

/// v (with colours), vt, vn, vc, f and what groups them; all else is skipped. A line that makes no sense never shifts
/// the numbers of others: such a vertex lies at infinity, such a face is counted as unreadable.
ObjText read_obj_text(std::string_view source);

/// What ends the lines of an OBJ or MTL: LF, also with CR before it; CR where the text has no LF, as old programs wrote
/// it.
char line_end(std::string_view text);

/// What a whole line names if it is the statement mtllib, as read_obj_text() takes it; empty: it names none.
std::string_view library_of(std::string_view line);

}  // namespace lapfx::organ
