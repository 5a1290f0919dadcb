// A framebuffer to draw into, and its pixels as a picture that tests read, compare and write.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "ui/value/geometry.h"

namespace lapfx::ui::test {

/// RGBA8. Rows begin at the top, as in the UI. Read it with at().
using Picture = cv::Mat4b;

inline Color at(const Picture& picture, int x, int y) {
    const cv::Vec4b& p = picture(y, x);
    return {p[0], p[1], p[2], p[3]};
}

class Canvas {
  public:
    explicit Canvas(glm::ivec2 size);  ///< black, opaque
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    unsigned framebuffer() const { return framebuffer_; }
    unsigned texture() const { return texture_; }
    glm::ivec2 size() const { return size_; }
    void fill(Color color) const;
    Picture read() const;

  private:
    glm::ivec2 size_;
    unsigned framebuffer_ = 0, texture_ = 0;
};

/// Writes a PNG over any older file. Throws std::runtime_error when it cannot be written.
void write_png(const Picture& picture, const std::string& path);
/// Reads a PNG as RGBA; empty when there is no such file.
Picture read_png(const std::string& path);

}  // namespace lapfx::ui::test
