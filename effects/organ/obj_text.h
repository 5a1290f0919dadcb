// OBJ text as OpenMesh can take it.
//
// OpenMesh's reader forgets a vertex whose coordinates are no numbers and so shifts all indices after it,
// reads past an empty list for "f /1/1", opens whatever file mtllib names, and keeps of a material only its
// texture. So its text is gone over first: such lines are put right or left out, and mtllib, usemtl, o and g
// are taken down here.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lapfx::organ {

struct ObjText {
    std::string text;  ///< v, vt, vn and f lines only

    /// Faces from `first_face` on belong to a material and an object.
    struct Run {
        std::size_t first_face = 0;
        std::string material;
        std::string name;
    };
    std::vector<Run> runs;
    std::vector<std::string> libraries;  ///< mtllib
    std::size_t faces = 0;
    std::size_t bad_faces = 0;   ///< malformed or with less than 3 corners; left out
    std::size_t flat_faces = 0;  ///< with less than 3 different corners; left out
};

ObjText clean_obj(std::string_view source);

}  // namespace lapfx::organ
