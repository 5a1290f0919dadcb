// Pictures of one size and format, one above the other in an array texture: linear, clamped to the edge, no mipmaps. The
// context must be current wherever one is made, used or destroyed.
#pragma once

#include "gl/objects.h"

namespace lapfx::gl {

class TextureArray {
  public:
    TextureArray() = default;
    /// All layers are `filled` in every channel, 0..255. `format`: GL_R8, GL_RG8 or GL_RGB8.
    TextureArray(glm::ivec2 size, int layers, GLenum format, std::uint8_t filled);

    /// One layer, rows from the top, tightly packed, 8 bits a channel. The host's way of unpacking pixels is left as it was.
    void upload(int layer, const std::uint8_t* pixels) const;
    GLuint name() const { return name_.get(); }

  private:
    Name<release_texture> name_;
    glm::ivec2 size_{0};
    GLenum channels_ = GL_RED;
};

}  // namespace lapfx::gl
