// Pixels on their way to textures. Written by the CPU at once and read by the GPU when it comes to it, so that sending them waits
// for no drawing. The context must be current.
#pragma once

#include "gl/objects.h"

namespace lapfx::gl {

class PixelBuffer {
  public:
    PixelBuffer() = default;
    explicit PixelBuffer(std::size_t bytes);

    /// Takes the place of all that it held; what the GPU has still to read of that, it keeps. At most as many bytes as it was made
    /// with. False when the driver has no memory for it: then it holds nothing that can be uploaded.
    bool write(std::span<const std::uint8_t> bytes) const noexcept;
    /// Level 0 of a layer of an array, from `offset` on: as Texture::upload().
    void upload(const Texture& to, GLenum format, std::size_t offset, int layer) const noexcept;
    bool made() const { return name_.get() != 0; }

  private:
    Name<release_buffer> name_;
    std::size_t size_ = 0;
};

}  // namespace lapfx::gl
