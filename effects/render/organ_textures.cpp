#include "render/organ_textures.h"

#include <algorithm>
#include <limits>

namespace lapfx::render {

GLenum wrap_mode(Wrap wrap) {
    switch (wrap) {
        case Wrap::clamp:
            return GL_CLAMP_TO_EDGE;
        case Wrap::mirror:
            return GL_MIRRORED_REPEAT;
        case Wrap::repeat:
            break;
    }
    return GL_REPEAT;
}

/// One after the other, so that no more than one is kept in main memory.
OrganTextures::OrganTextures(const Organ& organ, const organ::PixelList& pixels) {
    constexpr std::size_t whole = std::numeric_limits<std::size_t>::max();
    std::shared_ptr<const Image> last;  // an image that is used as both is decoded once
    for (const organ::TextureUse& use : organ::texture_uses(organ)) {
        const organ::TextureLevels levels = organ::texture_levels(organ, pixels, use);
        last = levels.whole;
        send({&levels, 1}, whole);
        next_ = 0;
    }
}

bool OrganTextures::send(std::span<const organ::TextureLevels> all, std::size_t bytes) noexcept {
    while (next_ < all.size()) {
        if (bytes == 0) return true;
        const organ::TextureLevels& levels = all[next_];
        if (levels.whole != nullptr) {
            if (!made_) {
                bytes -= std::min(bytes, make(levels));  // a driver may fill its memory
                continue;
            }
            bytes -= std::min(bytes, send_rows(levels, bytes));
            if (level_ < levels.count()) continue;
        }
        ++next_, level_ = 0, row_ = 0, made_ = false;
    }
    return false;
}

/// The storage of one; the bytes of its largest level.
std::size_t OrganTextures::make(const organ::TextureLevels& levels) {
    const glm::ivec2 size(levels.whole->width, levels.whole->height);
    sent_.push_back(
        {.use = levels.use,
         .texture = gl::Texture({.size = size,
                                 .format = static_cast<GLenum>(levels.use.color ? GL_SRGB8_ALPHA8 : GL_RGBA8),
                                 .levels = static_cast<int>(levels.count()),
                                 .wrap_u = wrap_mode(levels.wrap_u),
                                 .wrap_v = wrap_mode(levels.wrap_v)})});
    made_ = true;
    return levels.whole->pixels.size();
}

/// The next rows of one level, one at least; the bytes sent.
std::size_t OrganTextures::send_rows(const organ::TextureLevels& levels, std::size_t bytes) noexcept {
    const Image& from = levels.level(level_);
    const std::size_t row_bytes = 4 * static_cast<std::size_t>(from.width);
    const auto left = static_cast<std::size_t>(from.height - row_);
    const std::size_t rows = std::clamp<std::size_t>(bytes / row_bytes, 1, left);
    sent_.back().texture.upload_rows(
        GL_RGBA, from.pixels.data() + static_cast<std::size_t>(row_) * row_bytes,
        {.level = static_cast<int>(level_), .width = from.width, .begin = row_, .count = static_cast<int>(rows)});
    row_ += static_cast<int>(rows);
    if (row_ == from.height) ++level_, row_ = 0;
    return rows * row_bytes;
}

bool OrganTextures::free_one() noexcept {
    if (!sent_.empty()) sent_.pop_back();
    return !sent_.empty();
}

GLuint OrganTextures::find(int image, bool color) const noexcept {
    for (const Sent& one : sent_)
        if (static_cast<int>(one.use.image) == image && one.use.color == color) return one.texture.name();
    return 0;
}

std::size_t OrganTextures::memory() const noexcept {
    std::size_t bytes = 0;
    for (const Sent& one : sent_)
        bytes +=
            static_cast<std::size_t>(one.texture.size().x) * static_cast<std::size_t>(one.texture.size().y) * 4 / 3 * 4;
    return bytes;
}

}  // namespace lapfx::render
