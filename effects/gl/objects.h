// Owners of OpenGL objects: move-only, each knows its size and format. The context must be current when one is made,
// used or destroyed. GL can only fail here in the driver (out of memory), and reports that as GL errors.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <utility>

#include "gl/gl.h"

namespace lapfx::gl {

/// A GL name that is released once.
template <void (*Release)(GLuint)>
class Name {
  public:
    Name() = default;
    explicit Name(GLuint name) : name_(name) {}
    Name(Name&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Name& operator=(Name&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~Name() {
        if (name_ != 0) Release(name_);
    }
    GLuint get() const { return name_; }

  private:
    GLuint name_ = 0;
};

void release_buffer(GLuint name);
void release_texture(GLuint name);
void release_framebuffer(GLuint name);
void release_vertex_array(GLuint name);

/// Bytes on the GPU. Storage is fixed at creation; `update` writes a part of it.
class Buffer {
  public:
    Buffer() = default;
    explicit Buffer(std::size_t bytes) : Buffer(bytes, nullptr) {}
    template <typename T>
    explicit Buffer(std::span<const T> data) : Buffer(data.size_bytes(), data.data()) {}

    void update(std::size_t offset, std::size_t bytes, const void* data) const;
    /// Elements [begin, end) of the array that this buffer mirrors. Gives the bytes sent.
    template <typename T>
    std::size_t update(std::span<const T> all, std::size_t begin, std::size_t end) const {
        update(begin * sizeof(T), (end - begin) * sizeof(T), all.data() + begin);
        return (end - begin) * sizeof(T);
    }
    GLuint name() const { return name_.get(); }
    std::size_t size() const { return size_; }

  private:
    Buffer(std::size_t bytes, const void* data);
    Name<release_buffer> name_;
    std::size_t size_ = 0;
};

struct TextureDescription {
    glm::ivec2 size{1};
    GLenum format = GL_RGBA8;
    int levels = 1;
    int samples = 0;  ///< 0: an ordinary texture, otherwise multisample
    int layers = 0;   ///< 0: GL_TEXTURE_2D, otherwise the number of layers of a GL_TEXTURE_2D_ARRAY
    GLenum filter = GL_LINEAR;
    GLenum wrap_u = GL_CLAMP_TO_EDGE, wrap_v = GL_CLAMP_TO_EDGE;
};

/// Rows of a mip level, from the top.
struct LevelRows {
    int level = 0;
    int width = 1;  ///< of the level
    int begin = 0, count = 1;
};

class Texture {
  public:
    Texture() = default;
    explicit Texture(const TextureDescription& description);

    /// Level 0 (of a layer of an array), bytes, rows from the top, tightly packed. Leaves the host's unpacking state as
    /// it was.
    void upload(GLenum format, const void* pixels, int layer = 0) const;
    void upload_rows(GLenum format, const void* pixels, const LevelRows& rows) const;
    void generate_mipmaps() const;
    GLuint name() const { return name_.get(); }
    glm::ivec2 size() const { return size_; }
    int layers() const { return layers_; }  ///< 0: not an array

  private:
    Name<release_texture> name_;
    glm::ivec2 size_{0};
    int layers_ = 0;
};

/// Colour and depth textures to draw into; it does not own them.
class Framebuffer {
  public:
    Framebuffer() = default;
    Framebuffer(const Texture& color, const Texture* depth);
    GLuint name() const { return name_.get(); }

  private:
    Name<release_framebuffer> name_;
};

class VertexArray {
  public:
    VertexArray();
    /// Attribute `index`: `components` floats per vertex, tightly packed in `buffer`.
    void attribute(GLuint index, const Buffer& buffer, int components) const;
    void indices(const Buffer& buffer) const;
    GLuint name() const { return name_.get(); }

  private:
    Name<release_vertex_array> name_;
};

/// How many mip levels an image of this size has.
int level_count(glm::ivec2 size);

}  // namespace lapfx::gl
