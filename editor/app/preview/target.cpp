#include "app/preview/target.h"

#include <glad/gl.h>

#include <algorithm>
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

void Target::read(Image& image) const {
    image.width = size_.x;
    image.height = size_.y;
    const std::size_t row = static_cast<std::size_t>(size_.x) * 4;
    image.pixels.resize(row * static_cast<std::size_t>(size_.y));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(texture_, 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(image.pixels.size()),
                      image.pixels.data());
    // It comes with its rows from the bottom.
    for (std::size_t low = 0, high = image.pixels.size(); low + row < high; low += row) {
        high -= row;
        const auto first = image.pixels.begin() + static_cast<std::ptrdiff_t>(low);
        std::swap_ranges(first, first + static_cast<std::ptrdiff_t>(row),
                         image.pixels.begin() + static_cast<std::ptrdiff_t>(high));
    }
}

}  // namespace lapfx::app
