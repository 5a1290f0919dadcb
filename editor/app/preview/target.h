// A picture that is drawn into and shown or read: a texture of sRGB-encoded RGBA8 with its framebuffer. Context
// current.
#pragma once

#include <glm/glm.hpp>

#include "lapfx/organ.h"

namespace lapfx::app {

class Target {
  public:
    Target() = default;
    explicit Target(glm::ivec2 size) { resize(size); }
    ~Target() { release(); }
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

    /// `size` is at least 1x1 (assert). A new size makes new GL objects, in which nothing has been drawn yet.
    void resize(glm::ivec2 size);
    glm::ivec2 size() const { return size_; }
    unsigned texture() const { return texture_; }  ///< GL name; 0 before the first resize()
    unsigned framebuffer() const { return framebuffer_; }
    /// Bytes on the GPU.
    std::size_t memory() const {
        return texture_ == 0 ? 0 : 4 * static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y);
    }
    /// Rows from the top. Waits for the GPU. Into an image that has been read before it allocates nothing, if the size
    /// is the same.
    void read(Image& image) const;
    Image read() const {
        Image image;
        read(image);
        return image;
    }

  private:
    void release();
    glm::ivec2 size_{0};
    unsigned texture_ = 0, framebuffer_ = 0;
};

}  // namespace lapfx::app
