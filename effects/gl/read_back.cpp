#include "gl/read_back.h"

#include <algorithm>
#include <cassert>

namespace lapfx::gl {

namespace {

constexpr GLenum names[6] = {GL_PACK_ALIGNMENT,   GL_PACK_ROW_LENGTH,   GL_PACK_SKIP_ROWS,
                             GL_PACK_SKIP_PIXELS, GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_IMAGES};
constexpr GLint packed[6] = {1, 0, 0, 0, 0, 0};

}  // namespace

PackGuard::PackGuard() noexcept {
    glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &buffer_);
    for (int i = 0; i < 6; ++i) glGetIntegerv(names[i], &before_[i]);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    for (int i = 0; i < 6; ++i) glPixelStorei(names[i], packed[i]);
}
PackGuard::~PackGuard() {
    for (int i = 0; i < 6; ++i) glPixelStorei(names[i], before_[i]);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(buffer_));
}

void read_rgba(GLuint texture, glm::ivec2 size, std::span<std::uint8_t> rgba) noexcept {
    const std::size_t row = static_cast<std::size_t>(size.x) * 4;
    assert(rgba.size() == row * static_cast<std::size_t>(size.y));
    const PackGuard guard;
    const std::size_t most = std::size_t{1} << 30;  // a call counts bytes in 32 bits
    const int band = static_cast<int>(std::max<std::size_t>(1, most / row));
    for (int y = 0; y < size.y; y += band) {
        const int rows = std::min(band, size.y - y);
        glGetTextureSubImage(texture, 0, 0, y, 0, size.x, rows, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                             static_cast<GLsizei>(row * static_cast<std::size_t>(rows)),
                             rgba.data() + row * static_cast<std::size_t>(y));
    }
    // It comes with its rows from the bottom.
    for (std::size_t low = 0, high = rgba.size() - row; low < high; low += row, high -= row)
        std::swap_ranges(rgba.data() + low, rgba.data() + low + row, rgba.data() + high);
}

}  // namespace lapfx::gl
