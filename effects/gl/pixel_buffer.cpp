#include "gl/pixel_buffer.h"

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

std::span<std::uint8_t> PixelBuffer::map() const noexcept {
    void* mapped = glMapNamedBufferRange(name_.get(), 0, static_cast<GLsizeiptr>(size_),
                                         GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
    if (mapped == nullptr) return {};
    return {static_cast<std::uint8_t*>(mapped), size_};
}

bool PixelBuffer::unmap() const noexcept {
    return glUnmapNamedBuffer(name_.get()) == GL_TRUE;
}

void PixelBuffer::upload(const Texture& to, GLenum format, std::size_t offset, int layer) const noexcept {
    const UnpackGuard guard(name_.get());
    glTextureSubImage3D(to.name(), 0, 0, 0, layer, to.size().x, to.size().y, 1, format, GL_UNSIGNED_BYTE,
                        reinterpret_cast<const void*>(offset));
}

}  // namespace lapfx::gl
