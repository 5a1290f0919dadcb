// Frames of one clip on the GPU. Render thread, context current.
#pragma once

#include <vector>

#include "gl/objects.h"
#include "gl/pixel_buffer.h"
#include "media/clip_frame.h"

namespace lapfx::media {

/// A few frames in array textures, black until they are sent.
class FrameTextures {
  public:
    FrameTextures() = default;
    FrameTextures(const PictureFormat& format, int layers);

    /// Does not send a picture whose size differs from the format's bytes. `from`, unless null, is the unmapped buffer
    /// whose memory `bytes` are. Gives the bytes sent.
    std::size_t upload(int layer, std::span<const std::uint8_t> bytes,
                       const gl::PixelBuffer* from = nullptr) const noexcept;
    ClipFrame frame(int layer, const ColorMatrix& matrix) const noexcept;
    bool made() const { return color_.name() != 0; }

  private:
    PictureFormat format_;
    gl::Texture color_, chroma_, alpha_;
};

/// The frames of a whole clip, which stay once they are sent.
class FrameStore {
  public:
    FrameStore(const PictureFormat& format, int frame_count);

    bool has(int index) const { return present_[static_cast<std::size_t>(index)] != 0; }
    /// Gives the bytes sent; call mark() afterwards.
    std::size_t upload(int index, std::span<const std::uint8_t> bytes);
    void mark(int index);
    /// Black while has(index) is false.
    ClipFrame frame(int index, const ColorMatrix& matrix);
    int count() const { return count_; }
    /// GPU memory, bytes.
    std::size_t memory() const;
    /// The bytes that the frames first..last would take.
    static std::size_t memory_for(const PictureFormat& format, int frame_count, int first, int last);
    /// One byte per frame, not 0 if the frame is here. A worker reads it under a lock, so call mark(), clear() and
    /// trim() under the same lock.
    const std::vector<std::uint8_t>& present() const { return present_; }
    void clear();
    /// Frees the memory of frames outside first..last.
    void trim(int first, int last);

  private:
    static constexpr int layers =
        32;  // layers of one array texture: memory grows in steps while a clip plays for the first time
    FrameTextures& chunk(int index);

    PictureFormat format_;
    std::vector<FrameTextures> chunks_;
    std::vector<std::uint8_t> present_;
    int count_ = 0;
};

}  // namespace lapfx::media
