// Pixels from the GPU into main memory, for pictures and tests: it waits until everything is drawn.
#pragma once

#include <cstdint>
#include <span>

#include "gl/objects.h"

namespace lapfx::gl {

/// Replaces the host's settings for packing pixels while it lives.
class PackGuard {
  public:
    PackGuard() noexcept;
    ~PackGuard();
    PackGuard(const PackGuard&) = delete;
    PackGuard& operator=(const PackGuard&) = delete;

  private:
    GLint before_[6] = {};
    GLint buffer_ = 0;
};

/// Level 0 of a texture of `size` as RGBA, four bytes a pixel, rows from the top: rgba.size() is 4 * x * y (assert).
void read_rgba(GLuint texture, glm::ivec2 size, std::span<std::uint8_t> rgba) noexcept;

}  // namespace lapfx::gl
