// glTF materials and the textures that they use.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "organ/gltf_document.h"
#include "organ/raw.h"

namespace lapfx::organ {

/// Which texture coordinates a material wants, and how it moves them (KHR_texture_transform).
struct UvUse {
    int set = 0;  ///< TEXCOORD_n
    glm::vec2 offset{0.0f};
    glm::vec2 scale{1.0f};
    float rotation = 0.0f;  ///< radians, counter-clockwise

    bool operator==(const UvUse&) const = default;
    glm::vec2 apply(glm::vec2 uv) const;
};

/// Appends the materials of the file and the images that they use to `organ`; one UvUse for each material. An image
/// that is missing or broken is a warning; an image that may not be read (a URL, a path out of the folder) throws
/// Error.
std::vector<UvUse> read_materials(GltfDocument& document, RawOrgan& organ);

}  // namespace lapfx::organ
