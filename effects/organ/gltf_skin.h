// Skins of a glTF: a skinned mesh lies where its joints are, whatever its own node says.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "organ/gltf_document.h"
#include "organ/raw.h"

namespace lapfx::organ {

class Skins {
  public:
    explicit Skins(GltfDocument& document) : document_(document), poses_(document.skins.size()) {}

    /// Moves a part of a mesh with that skin to the pose that the joints have in the file: each vertex by the sum of
    /// weight * place of the joint * inverse bind matrix. False when the primitive has no joints and weights. Throws
    /// Error for what is not in the file or does not fit together.
    bool pose(int skin, const tinygltf::Primitive& primitive, const std::string& place, RawPart& part);

    bool any() const { return any_; }      ///< a part was posed
    bool moved() const { return moved_; }  ///< and its pose is not the one that it was modelled in

  private:
    /// The matrix of each joint.
    const std::vector<glm::dmat4>& matrices(int skin, const std::string& place);

    GltfDocument& document_;
    std::vector<glm::dmat4> places_;                             // of the nodes
    std::vector<std::optional<std::vector<glm::dmat4>>> poses_;  // the index is the skin
    bool any_ = false, moved_ = false;
};

}  // namespace lapfx::organ
