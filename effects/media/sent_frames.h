// The few frames around one place of a clip that are on the GPU while the paper's schemes stream them. Render thread,
// context current.
#pragma once

#include <span>
#include <vector>

#include "lapfx/streaming.h"
#include "media/frame_textures.h"

namespace lapfx::media {

/// Pipeline has one texture, buffering four: the frame that is shown, the two after it, and one that the GPU may still
/// be drawing. Each has its own texture, because drivers make a write to a texture wait until the last drawing with it
/// is done.
class SentFrames {
  public:
    SentFrames() = default;
    SentFrames(const PictureFormat& format, Scheme scheme);

    bool holds(int index) const { return find(index) < slots_.size(); }
    /// Sends frame `index`, which it does not have yet, instead of one that is neither shown nor `needed`. `from` is as
    /// in FrameTextures::upload(). Gives the bytes sent; 0: nothing has changed.
    std::size_t send(int index, std::span<const std::uint8_t> bytes, const gl::PixelBuffer* from,
                     std::span<const int> needed) noexcept;
    /// Shows this frame from now on; it must be here.
    void show(int index) noexcept;
    /// Shows the frame that was sent last; there must be one.
    void show_newest() noexcept { show(newest_); }
    /// Sets the bytes of the frames that are here.
    void mark(std::span<std::uint8_t> held) const noexcept;
    int shown() const { return shown_; }  ///< frame number; -1: nothing yet

    /// What is shown.
    ClipFrame frame(const ColorMatrix& matrix) const noexcept;

    /// Bytes that it takes.
    static std::size_t memory(const PictureFormat& format, Scheme scheme);

  private:
    struct Slot {
        FrameTextures texture;
        int index = -1;          ///< frame number
        std::uint64_t used = 0;  ///< when it was sent or shown last
    };
    std::size_t find(int index) const;  ///< as many as there are: none
    Slot& slot_for(std::span<const int> needed);

    std::vector<Slot> slots_;
    std::uint64_t clock_ = 0;
    int shown_ = -1, newest_ = -1;
};

}  // namespace lapfx::media
