#include "gl/texture_array.h"

#include "gl/unpack_guard.h"

namespace lapfx::gl {

TextureArray::TextureArray(glm::ivec2 size, int layers, GLenum format, std::uint8_t filled)
    : size_(size),
      channels_(format == GL_RGB8  ? GL_RGB
                : format == GL_RG8 ? GL_RG
                                   : GL_RED) {
    GLuint made = 0;
    glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &made);
    name_ = Name<release_texture>(made);
    glTextureStorage3D(made, 1, format, size.x, size.y, layers);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTextureParameteri(made, filter, GL_LINEAR);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) glTextureParameteri(made, wrap, GL_CLAMP_TO_EDGE);
    const std::uint8_t value[3] = {filled, filled, filled};
    glClearTexImage(made, 0, channels_, GL_UNSIGNED_BYTE, value);
}

void TextureArray::upload(int layer, const std::uint8_t* pixels) const {
    const UnpackGuard guard;
    glTextureSubImage3D(name(), 0, 0, 0, layer, size_.x, size_.y, 1, channels_, GL_UNSIGNED_BYTE, pixels);
}

}  // namespace lapfx::gl
