#include "media/sent_frames.h"

#include <algorithm>

#include "media/schemes.h"

namespace lapfx::media {

SentFrames::SentFrames(const PictureFormat& format, Scheme scheme) : slots_(row_of(scheme).textures) {
    for (Slot& slot : slots_) slot.texture = FrameTextures(format, 1);
}

std::size_t SentFrames::memory(const PictureFormat& format, Scheme scheme) {
    return row_of(scheme).textures * format.bytes();
}

std::size_t SentFrames::find(int index) const {
    if (index < 0) return slots_.size();
    const auto found = std::find_if(slots_.begin(), slots_.end(), [&](const Slot& p) { return p.index == index; });
    return static_cast<std::size_t>(found - slots_.begin());
}

/// The frame that was used longest ago among those that nobody needs; with one texture, that one.
SentFrames::Slot& SentFrames::slot_for(std::span<const int> needed) {
    Slot* best = nullptr;
    for (Slot& slot : slots_) {
        const bool wanted = slot.index >= 0 && (slot.index == shown_ ||
                                                std::find(needed.begin(), needed.end(), slot.index) != needed.end());
        if (!wanted && (best == nullptr || slot.used < best->used)) best = &slot;
    }
    return best != nullptr ? *best : slots_.front();
}

std::size_t SentFrames::send(int index, std::span<const std::uint8_t> bytes, const gl::PixelBuffer* from,
                             std::span<const int> needed) noexcept {
    Slot& slot = slot_for(needed);
    const std::size_t sent = slot.texture.upload(0, bytes, from);
    if (sent == 0) return 0;
    if (slot.index == shown_) shown_ = index;  // pipeline has only one
    slot.index = newest_ = index;
    slot.used = ++clock_;
    return sent;
}

void SentFrames::show(int index) noexcept {
    const std::size_t at = find(index);
    if (at == slots_.size()) return;
    slots_[at].used = ++clock_;
    shown_ = index;
}

void SentFrames::mark(std::span<std::uint8_t> held) const noexcept {
    for (const Slot& slot : slots_)
        if (slot.index >= 0) held[static_cast<std::size_t>(slot.index)] = 1;
}

ClipFrame SentFrames::frame(const ColorMatrix& matrix) const noexcept {
    const std::size_t at = find(shown_);
    return at == slots_.size() ? ClipFrame{} : slots_[at].texture.frame(0, matrix);
}

}  // namespace lapfx::media
