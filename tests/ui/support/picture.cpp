#include "ui/support/picture.h"

#include <glad/gl.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace lapfx::ui::test {

Canvas::Canvas(glm::ivec2 size) : size_(size) {
    glCreateTextures(GL_TEXTURE_2D, 1, &texture_);
    glTextureStorage2D(texture_, 1, GL_RGBA8, size.x, size.y);
    glCreateFramebuffers(1, &framebuffer_);
    glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, texture_, 0);
    fill({0, 0, 0, 255});
}

Canvas::~Canvas() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteTextures(1, &texture_);
}

void Canvas::fill(Color color) const {
    const std::uint8_t bytes[] = {color.r, color.g, color.b, color.a};
    glClearTexImage(texture_, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
}

Picture Canvas::read() const {
    Picture bottom_up(size_.y, size_.x), picture;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_UNSIGNED_BYTE, bottom_up.data);
    cv::flip(bottom_up, picture, 0);
    return picture;
}

void write_png(const Picture& picture, const std::string& path) {
    cv::Mat bgra;
    cv::cvtColor(picture, bgra, cv::COLOR_RGBA2BGRA);
    if (!cv::imwrite(path, bgra)) throw std::runtime_error(path + " cannot be written");
}

Picture read_png(const std::string& path) {
    const cv::Mat stored = cv::imread(path, cv::IMREAD_UNCHANGED);
    cv::Mat rgba;
    if (stored.channels() == 4)
        cv::cvtColor(stored, rgba, cv::COLOR_BGRA2RGBA);
    else if (stored.channels() == 3)
        cv::cvtColor(stored, rgba, cv::COLOR_BGR2RGBA);
    return rgba;
}

}  // namespace lapfx::ui::test
