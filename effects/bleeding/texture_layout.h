// How a base-colour texture lies on the organ: its texels per mm, and which texels are on the surface at all.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "lapfx/organ.h"

namespace lapfx::bleeding {

/// What lies beyond the edges of a texture.
struct Beyond {
    bool any = false;  ///< texture coordinates leave 0..1; else nothing does, whatever the modes say
    Wrap u = Wrap::repeat, v = Wrap::repeat;
};

struct TextureLayout {
    glm::dvec2 texels_per_mm{0.0};  ///< along u and v: means over the surface by area; 0 if unknown
    Beyond beyond;
    std::vector<std::uint8_t> used;  ///< per texel, row by row from the top: 255 on the surface, else 0
};

/// `image`: index into organ.images. Triangles with NaN, infinite or huge (beyond 1e6) coordinates are left out.
TextureLayout layout_of(const Organ& organ, int image);

}  // namespace lapfx::bleeding
