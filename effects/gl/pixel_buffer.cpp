#include "gl/pixel_buffer.h"

#include <cstring>

#include "gl/unpack_guard.h"

namespace lapfx::gl {

namespace {

GLuint make_buffer() {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    return name;
}

}  // namespace

PixelBuffer::PixelBuffer(std::size_t bytes) : name_(make_buffer()), size_(bytes) {
    glNamedBufferStorage(name_.get(), static_cast<GLsizeiptr>(bytes), nullptr, GL_MAP_WRITE_BIT);
}

bool PixelBuffer::write(std::span<const std::uint8_t> bytes) const noexcept {
    if (bytes.empty() || bytes.size() > size_) return false;
    void* mapped = glMapNamedBufferRange(name_.get(), 0, static_cast<GLsizeiptr>(bytes.size()),
                                         GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
    if (mapped == nullptr) return false;
    std::memcpy(mapped, bytes.data(), bytes.size());
    return glUnmapNamedBuffer(name_.get()) == GL_TRUE;
}

void PixelBuffer::upload(const Texture& to, GLenum format, std::size_t offset, int layer) const noexcept {
    const UnpackGuard guard(name_.get());
    glTextureSubImage3D(to.name(), 0, 0, 0, layer, to.size().x, to.size().y, 1, format, GL_UNSIGNED_BYTE,
                        reinterpret_cast<const void*>(offset));
}

}  // namespace lapfx::gl
