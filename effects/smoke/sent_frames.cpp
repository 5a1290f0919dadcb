#include "smoke/sent_frames.h"

#include <algorithm>

namespace lapfx::smoke {

namespace {

std::size_t textures_of(Scheme scheme) {
    return scheme == Scheme::resident ? 0u : scheme == Scheme::pipeline ? 1u : 4u;
}

}  // namespace

SentFrames::SentFrames(const PictureFormat& format, Scheme scheme) : places_(textures_of(scheme)) {
    for (Place& place : places_) place.texture = FrameTextures(format, 1);
}

std::size_t SentFrames::memory(const PictureFormat& format, Scheme scheme) {
    return textures_of(scheme) * format.bytes();
}

std::size_t SentFrames::find(int index) const {
    if (index < 0) return places_.size();
    const auto found = std::find_if(places_.begin(), places_.end(), [&](const Place& p) { return p.index == index; });
    return static_cast<std::size_t>(found - places_.begin());
}

/// The one that was used longest ago of those that nobody wants; with one texture, that one.
SentFrames::Place& SentFrames::place_for(std::span<const int> needed) {
    Place* best = nullptr;
    for (Place& place : places_) {
        const bool wanted = place.index >= 0 && (place.index == shown_ ||
                                                 std::find(needed.begin(), needed.end(), place.index) != needed.end());
        if (!wanted && (best == nullptr || place.used < best->used)) best = &place;
    }
    return best != nullptr ? *best : places_.front();
}

std::size_t SentFrames::send(int index, std::span<const std::uint8_t> bytes, const gl::PixelBuffer* from,
                             std::span<const int> needed) noexcept {
    Place& place = place_for(needed);
    const std::size_t sent = place.texture.upload(0, bytes, from);
    if (sent == 0) return 0;
    if (place.index == shown_) shown_ = index;  // pipeline has no other one
    place.index = newest_ = index;
    place.used = ++clock_;
    return sent;
}

void SentFrames::show(int index) noexcept {
    const std::size_t at = find(index);
    if (at == places_.size()) return;
    places_[at].used = ++clock_;
    shown_ = index;
}

void SentFrames::mark(std::span<std::uint8_t> held) const noexcept {
    for (const Place& place : places_)
        if (place.index >= 0) held[static_cast<std::size_t>(place.index)] = 1;
}

ClipFrame SentFrames::frame(const ColorMatrix& matrix) const noexcept {
    const std::size_t at = find(shown_);
    return at == places_.size() ? ClipFrame{} : places_[at].texture.frame(0, matrix);
}

}  // namespace lapfx::smoke
