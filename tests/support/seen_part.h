// The part of an organ that a scene's camera sees. An organ is drawn whole and its triangles are split for blood, so
// that without a GPU most of a small picture's time goes to what nobody sees in it.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

namespace lapfx::test {

/// Takes the triangles out of a .glb that the camera of `scene` does not see from its place, and their vertices;
/// pictures of that camera stay the same within a code value. Parts and their materials stay, with one triangle at
/// least. The organ is in metres, each accessor has a buffer view of its own, and nodes have no transform, as the
/// generator of the samples writes them: throws std::runtime_error where that is not so. `views`: the bytes of each
/// buffer view.
void keep_seen_part(nlohmann::json& glb, std::vector<std::vector<std::uint8_t>>& views, const nlohmann::json& scene);

}  // namespace lapfx::test
