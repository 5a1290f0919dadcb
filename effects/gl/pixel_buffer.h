// Pixels that will be sent to textures: any thread writes them into memory of the driver, and the GPU reads them later.
// Sending them copies nothing on the CPU, except in the driver, and does not wait for drawing. The context must be
// current.
#pragma once

#include "gl/objects.h"

namespace lapfx::gl {

class PixelBuffer {
  public:
    PixelBuffer() = default;
    explicit PixelBuffer(std::size_t bytes);

    /// Memory to write to until unmap(), of the size at construction. Its content is undefined, and reading it is slow.
    /// Data that the GPU has not read yet is kept. Empty when the driver has no memory.
    std::span<std::uint8_t> map() const noexcept;
    /// Makes the written data ready to be sent. False when the driver has lost it.
    bool unmap() const noexcept;
    /// Level 0 of a layer of an array, from `offset` on: as Texture::upload().
    void upload(const Texture& to, GLenum format, std::size_t offset, int layer) const noexcept;
    bool made() const { return name_.get() != 0; }

  private:
    Name<release_buffer> name_;
    std::size_t size_ = 0;
};

}  // namespace lapfx::gl
