// What of a glTF's JSON tinygltf takes without a word, or refuses without saying where.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace lapfx::organ {

/// Counts, offsets and indices are whole numbers, lists are lists: throws Error with the JSON pointer of what is not.
void check_structure(const nlohmann::json& document, const std::string& file);

/// Takes out what of the materials cannot be what it should be, so that the rest is read; a warning for each.
void mend_materials(nlohmann::json& document, std::vector<std::string>& warnings);

}  // namespace lapfx::organ
