#include "gl/objects.h"

#include <bit>

#include "gl/unpack_guard.h"

namespace lapfx::gl {

void release_buffer(GLuint name) {
    glDeleteBuffers(1, &name);
}
void release_texture(GLuint name) {
    glDeleteTextures(1, &name);
}
void release_framebuffer(GLuint name) {
    glDeleteFramebuffers(1, &name);
}
void release_vertex_array(GLuint name) {
    glDeleteVertexArrays(1, &name);
}

namespace {

GLuint make(void (*create)(GLsizei, GLuint*)) {
    GLuint name = 0;
    create(1, &name);
    return name;
}

GLuint make_texture(GLenum target) {
    GLuint name = 0;
    glCreateTextures(target, 1, &name);
    return name;
}

}  // namespace

Buffer::Buffer(std::size_t bytes, const void* data) : name_(make(glCreateBuffers)), size_(bytes) {
    // GL has no empty storage, so it gets one byte.
    glNamedBufferStorage(name(), static_cast<GLsizeiptr>(bytes == 0 ? 1 : bytes), bytes == 0 ? nullptr : data,
                         GL_DYNAMIC_STORAGE_BIT);
}

void Buffer::update(std::size_t offset, std::size_t bytes, const void* data) const {
    glNamedBufferSubData(name(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
}

Texture::Texture(const TextureDescription& d) : size_(d.size), layers_(d.layers) {
    if (d.samples > 0) {
        name_ = Name<release_texture>(make_texture(GL_TEXTURE_2D_MULTISAMPLE));
        glTextureStorage2DMultisample(name(), d.samples, d.format, d.size.x, d.size.y, GL_TRUE);
        return;
    }
    name_ = Name<release_texture>(make_texture(d.layers > 0 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D));
    if (d.layers > 0)
        glTextureStorage3D(name(), d.levels, d.format, d.size.x, d.size.y, d.layers);
    else
        glTextureStorage2D(name(), d.levels, d.format, d.size.x, d.size.y);
    const bool mipmaps = d.levels > 1;
    const GLenum minify = d.filter == GL_NEAREST ? GL_NEAREST : mipmaps ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR;
    glTextureParameteri(name(), GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minify));
    glTextureParameteri(name(), GL_TEXTURE_MAG_FILTER, static_cast<GLint>(d.filter));
    glTextureParameteri(name(), GL_TEXTURE_WRAP_S, static_cast<GLint>(d.wrap_u));
    glTextureParameteri(name(), GL_TEXTURE_WRAP_T, static_cast<GLint>(d.wrap_v));
}

void Texture::upload(GLenum format, const void* pixels, int layer) const {
    const UnpackGuard guard;
    if (layers_ > 0)
        glTextureSubImage3D(name(), 0, 0, 0, layer, size_.x, size_.y, 1, format, GL_UNSIGNED_BYTE, pixels);
    else
        glTextureSubImage2D(name(), 0, 0, 0, size_.x, size_.y, format, GL_UNSIGNED_BYTE, pixels);
}

void Texture::upload_rows(GLenum format, const void* pixels, const LevelRows& rows) const {
    const UnpackGuard guard;
    glTextureSubImage2D(name(), rows.level, 0, rows.begin, rows.width, rows.count, format, GL_UNSIGNED_BYTE, pixels);
}

void Texture::generate_mipmaps() const {
    glGenerateTextureMipmap(name());
}

Framebuffer::Framebuffer(const Texture& color, const Texture* depth) : name_(make(glCreateFramebuffers)) {
    glNamedFramebufferTexture(name(), GL_COLOR_ATTACHMENT0, color.name(), 0);
    if (depth != nullptr) glNamedFramebufferTexture(name(), GL_DEPTH_ATTACHMENT, depth->name(), 0);
}

VertexArray::VertexArray() : name_(make(glCreateVertexArrays)) {}

void VertexArray::attribute(GLuint index, const Buffer& buffer, int components) const {
    const auto stride = static_cast<GLsizei>(components * static_cast<int>(sizeof(float)));
    glVertexArrayVertexBuffer(name(), index, buffer.name(), 0, stride);
    glVertexArrayAttribFormat(name(), index, components, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(name(), index, index);
    glEnableVertexArrayAttrib(name(), index);
}

void VertexArray::indices(const Buffer& buffer) const {
    glVertexArrayElementBuffer(name(), buffer.name());
}

int level_count(glm::ivec2 size) {
    return std::bit_width(static_cast<unsigned>(size.x > size.y ? size.x : size.y));
}

}  // namespace lapfx::gl
