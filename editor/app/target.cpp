#include "app/target.h"

#include <glad/gl.h>

#include <cassert>

namespace lapfx::app {

void Target::release() {
    if (texture_ == 0) return;
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteTextures(1, &texture_);
    texture_ = framebuffer_ = 0;
}

void Target::resize(glm::ivec2 size) {
    assert(size.x > 0 && size.y > 0);
    if (size == size_ && texture_ != 0) return;
    release();
    size_ = size;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture_);
    glTextureStorage2D(texture_, 1, GL_RGBA8, size.x, size.y);
    glCreateFramebuffers(1, &framebuffer_);
    glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, texture_, 0);
}

Image Target::read() const {
    Image image{.width = size_.x, .height = size_.y, .pixels = {}, .name = ""};
    const std::size_t row = static_cast<std::size_t>(size_.x) * 4;
    std::vector<std::uint8_t> upward(row * static_cast<std::size_t>(size_.y));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(texture_, 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(upward.size()), upward.data());
    image.pixels.reserve(upward.size());
    for (std::size_t y = upward.size(); y > 0; y -= row)
        image.pixels.insert(image.pixels.end(), upward.begin() + static_cast<std::ptrdiff_t>(y - row),
                            upward.begin() + static_cast<std::ptrdiff_t>(y));
    return image;
}

}  // namespace lapfx::app
