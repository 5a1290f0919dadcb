// Checks the parts of a glTF's JSON that tinygltf accepts although they are wrong, or refuses without saying where.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace lapfx::organ {

/// Checks that counts, offsets and indices are whole numbers and that lists are lists. Throws Error with the JSON
/// pointer of the first that is not.
void check_structure(const nlohmann::json& document, const std::string& file);

/// Removes the parts of materials that are not what they should be, with a warning for each, so that the rest can be
/// read.
void mend_materials(nlohmann::json& document, std::vector<std::string>& warnings);

}  // namespace lapfx::organ
