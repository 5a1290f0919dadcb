// Pixels on their way to textures: any thread writes them into memory of the driver's, and the GPU reads them when it
// comes to it. Sending them so copies nothing on the CPU, beyond what the driver does, and waits for no drawing. The
// context must be current.
#pragma once

#include "gl/objects.h"

namespace lapfx::gl {

class PixelBuffer {
  public:
    PixelBuffer() = default;
    explicit PixelBuffer(std::size_t bytes);

    /// Memory to write to, of the bytes that it was made with, until unmap(); of whatever content, and slow to read.
    /// What the GPU has still to read of what was there, it keeps. Empty when the driver has none.
    std::span<std::uint8_t> map() const noexcept;
    /// What was written is there to be sent. False when the driver has lost it.
    bool unmap() const noexcept;
    /// Level 0 of a layer of an array, from `offset` on: as Texture::upload().
    void upload(const Texture& to, GLenum format, std::size_t offset, int layer) const noexcept;
    bool made() const { return name_.get() != 0; }

  private:
    Name<release_buffer> name_;
    std::size_t size_ = 0;
};

}  // namespace lapfx::gl
