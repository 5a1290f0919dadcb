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

    /// A picture of other bytes than the format's is not sent. `from`: unless null, `bytes` are its memory, and it is
    /// unmapped. Gives the bytes sent.
    std::size_t upload(int layer, std::span<const std::uint8_t> bytes,
                       const gl::PixelBuffer* from = nullptr) const noexcept;
    ClipFrame frame(int layer, const ColorMatrix& matrix) const noexcept;
    bool made() const { return color_.name() != 0; }

  private:
    PictureFormat format_;
    gl::Texture color_, chroma_, alpha_;
};

/// Frames that stay: those of a whole clip, as they come.
class FrameStore {
  public:
    FrameStore(const PictureFormat& format, int frame_count);

    bool has(int index) const { return present_[static_cast<std::size_t>(index)] != 0; }
    /// Bytes sent; mark() it then.
    std::size_t upload(int index, std::span<const std::uint8_t> bytes);
    void mark(int index);
    /// Black while has(index) is false.
    ClipFrame frame(int index, const ColorMatrix& matrix);
    int count() const { return count_; }
    /// GPU memory, bytes.
    std::size_t memory() const;
    /// What it would take for the frames first..last.
    static std::size_t memory_for(const PictureFormat& format, int frame_count, int first, int last);
    /// One byte a frame, not 0 where it is there. A worker reads it: mark(), clear() and trim() are called under the
    /// lock that the worker holds then.
    const std::vector<std::uint8_t>& present() const { return present_; }
    void clear();
    /// Gives back the memory of what lies outside frames first..last.
    void trim(int first, int last);

  private:
    static constexpr int layers = 32;  // of one array texture: memory comes in steps as a clip plays in
    FrameTextures& chunk(int index);

    PictureFormat format_;
    std::vector<FrameTextures> chunks_;
    std::vector<std::uint8_t> present_;
    int count_ = 0;
};

}  // namespace lapfx::media
