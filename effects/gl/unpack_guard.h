// Replaces the host's settings for unpacking pixels while it lives, because frames are uploaded in the middle of the
// host's drawing.
#pragma once

#include "gl/gl.h"

namespace lapfx::gl {

class UnpackGuard {
  public:
    /// `from`: the buffer that pixels are read from; 0: main memory.
    explicit UnpackGuard(GLuint from = 0) noexcept {
        glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &buffer_);
        for (int i = 0; i < count; ++i) glGetIntegerv(names[i], &before_[i]);
        other_ = static_cast<GLuint>(buffer_) != from;
        if (other_) glBindBuffer(GL_PIXEL_UNPACK_BUFFER, from);
        for (int i = 0; i < count; ++i) glPixelStorei(names[i], packed[i]);
    }
    ~UnpackGuard() {
        for (int i = 0; i < count; ++i) glPixelStorei(names[i], before_[i]);
        if (other_) glBindBuffer(GL_PIXEL_UNPACK_BUFFER, static_cast<GLuint>(buffer_));
    }
    UnpackGuard(const UnpackGuard&) = delete;
    UnpackGuard& operator=(const UnpackGuard&) = delete;

  private:
    static constexpr int count = 6;
    static constexpr GLenum names[count] = {GL_UNPACK_ALIGNMENT,   GL_UNPACK_ROW_LENGTH,   GL_UNPACK_SKIP_ROWS,
                                            GL_UNPACK_SKIP_PIXELS, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES};
    static constexpr GLint packed[count] = {1, 0, 0, 0, 0, 0};
    GLint before_[count] = {};
    GLint buffer_ = 0;
    bool other_ = false;
};

}  // namespace lapfx::gl
