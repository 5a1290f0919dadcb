#include "media/frame_textures.h"

#include <algorithm>

namespace lapfx::media {

namespace {

constexpr std::uint8_t no_chroma = 128;

/// Layers of bytes, all `filled`.
gl::Texture planes(glm::ivec2 size, int layers, GLenum format, GLenum channels, std::uint8_t filled) {
    gl::Texture made({.size = size, .format = format, .layers = layers});
    const std::uint8_t value[3] = {filled, filled, filled};
    glClearTexImage(made.name(), 0, channels, GL_UNSIGNED_BYTE, value);
    return made;
}

}  // namespace

FrameTextures::FrameTextures(const PictureFormat& format, int layers) : format_(format) {
    const bool planar = format.layout == Layout::planar;
    color_ = planes(format.size, layers, planar ? GL_R8 : GL_RGB8, planar ? GL_RED : GL_RGB, 0);
    if (planar) chroma_ = planes(format.chroma_size(), layers, GL_RG8, GL_RG, no_chroma);
    if (format.alpha) alpha_ = planes(format.size, layers, GL_R8, GL_RED, 0);
}

std::size_t FrameTextures::upload(int layer, std::span<const std::uint8_t> bytes,
                                  const gl::PixelBuffer* from) const noexcept {
    if (from != nullptr && !from->unmap()) return 0;
    if (bytes.size() != format_.bytes()) return 0;
    const auto send = [&](const gl::Texture& plane, GLenum channels, std::size_t offset) {
        if (plane.name() == 0) return;
        if (from != nullptr)
            from->upload(plane, channels, offset, layer);
        else
            plane.upload(channels, bytes.data() + offset, layer);
    };
    send(color_, format_.layout == Layout::planar ? GL_RED : GL_RGB, 0);
    send(chroma_, GL_RG, format_.color_bytes());
    send(alpha_, GL_RED, format_.color_bytes() + format_.chroma_bytes());
    return format_.bytes();
}

ClipFrame FrameTextures::frame(int layer, const ColorMatrix& matrix) const noexcept {
    return {.format = format_,
            .color = color_.name(),
            .chroma = chroma_.name(),
            .alpha = alpha_.name(),
            .layer = layer,
            .matrix = &matrix};
}

FrameStore::FrameStore(const PictureFormat& format, int frame_count)
    : format_(format),
      chunks_(static_cast<std::size_t>((frame_count + layers - 1) / layers)),
      present_(static_cast<std::size_t>(frame_count)) {}

FrameTextures& FrameStore::chunk(int index) {
    FrameTextures& chunk = chunks_[static_cast<std::size_t>(index / layers)];
    const int last = static_cast<int>(present_.size()) - index / layers * layers;
    if (!chunk.made()) chunk = FrameTextures(format_, std::min(layers, last));
    return chunk;
}

std::size_t FrameStore::upload(int index, std::span<const std::uint8_t> bytes) {
    return chunk(index).upload(index % layers, bytes);
}

void FrameStore::mark(int index) {
    std::uint8_t& present = present_[static_cast<std::size_t>(index)];
    count_ += present == 0 ? 1 : 0;
    present = 1;
}

ClipFrame FrameStore::frame(int index, const ColorMatrix& matrix) {
    return chunk(index).frame(index % layers, matrix);
}

std::size_t FrameStore::memory() const {
    std::size_t frames = 0;
    for (std::size_t i = 0; i < chunks_.size(); ++i)
        if (chunks_[i].made()) frames += std::min<std::size_t>(layers, present_.size() - i * layers);
    return frames * format_.bytes();
}

std::size_t FrameStore::memory_for(const PictureFormat& format, int frame_count, int first, int last) {
    const int begin = first / layers * layers, end = std::min((last / layers + 1) * layers, frame_count);
    return static_cast<std::size_t>(end - begin) * format.bytes();
}

void FrameStore::clear() {
    trim(0, -1);
}

void FrameStore::trim(int first, int last) {
    for (std::size_t i = 0; i < chunks_.size(); ++i) {
        const int begin = static_cast<int>(i) * layers,
                  end = std::min(begin + layers, static_cast<int>(present_.size()));
        if (last >= begin && first < end) continue;
        chunks_[i] = FrameTextures();
        std::fill(present_.begin() + begin, present_.begin() + end, std::uint8_t{0});
    }
    count_ = static_cast<int>(std::count_if(present_.begin(), present_.end(), [](std::uint8_t p) { return p != 0; }));
}

}  // namespace lapfx::media
