// OBJ text as polygons.
//
// OpenMesh 9.0 is not used. Its OBJ reader removes repeated corners from a polygon, so that a ring cut open around a
// hole loses its hole and two triangles. It drops a vertex whose coordinates are not numbers, which shifts all later
// indices, reads past an empty list for "f /1/1", opens any file that mtllib names, and keeps only the texture of a
// material.
//
// tinyobjloader 2.0 is not used either: it refuses a whole file because of one corner whose normal has the number 0, as
// Cinema 4D writes them, loses triangles when it cuts concave polygons, and takes 2.5 times as long.
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

/// Reads v (with colours), vt, vn, vc, f and the statements that group them, and skips everything else. A line that
/// makes no sense never shifts the numbers of others: such a vertex is at infinity, and such a face counts as
/// unreadable.
ObjText read_obj_text(std::string_view source);

/// The character that ends the lines of an OBJ or MTL: LF, perhaps after CR; or CR if the text has no LF, as old
/// programs wrote it.
char line_end(std::string_view text);

/// The names in a whole line if that is the statement mtllib, as read_obj_text() reads them; empty if not. A name may
/// hold spaces: where there are several, each but the last ends in ".mtl".
std::vector<std::string> libraries_of(std::string_view line);

}  // namespace lapfx::organ
