#include "render/frame.h"

#include <array>
#include <string>

#include "lapfx/error.h"

namespace lapfx::render {

namespace {

constexpr int samples = 4;
// The background beyond the tissue: an unlit cavity with a trace of red.
constexpr float cavity[4] = {0.004f, 0.0006f, 0.0006f, 1.0f};

void require_complete(const gl::Framebuffer& framebuffer, glm::ivec2 size) {
    if (glCheckNamedFramebufferStatus(framebuffer.name(), GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
    throw Error(Failure::runtime, Fault{.file = "",
                                        .place = "",
                                        .reason = "the driver cannot make a frame of " + std::to_string(size.x) + "x" +
                                                  std::to_string(size.y) + " pixels"});
}

}  // namespace

Frame::Frame() : post_("fullscreen.vert", "post.frag") {}

void Frame::resize(glm::ivec2 size) {
    if (size == size_) return;
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (size.x < 1 || size.y < 1 || size.x > most || size.y > most)
        throw Error(Failure::bad_input,
                    Fault{.file = "",
                          .place = "size",
                          .reason = std::to_string(size.x) + "x" + std::to_string(size.y) + " is outside 1x1 to " +
                                    std::to_string(most) + "x" + std::to_string(most) + " pixels"});
    size_ = glm::ivec2(0);  // counts as made only when everything is
    color_ = gl::Texture({.size = size, .format = GL_RGBA16F, .samples = samples});
    depth_ = gl::Texture({.size = size, .format = GL_DEPTH_COMPONENT32F, .samples = samples});
    resolved_color_ = gl::Texture({.size = size, .format = GL_RGBA16F, .filter = GL_NEAREST});
    resolved_depth_ = gl::Texture({.size = size, .format = GL_DEPTH_COMPONENT32F, .filter = GL_NEAREST});
    scene_ = gl::Framebuffer(color_, &depth_);
    resolve_ = gl::Framebuffer(resolved_color_, &resolved_depth_);
    smoke_ = gl::Framebuffer(resolved_color_, nullptr);  // its depth is read while the smoke is drawn
    require_complete(scene_, size);
    require_complete(resolve_, size);
    size_ = size;
}

std::size_t Frame::memory() const noexcept {
    constexpr std::size_t pixel = 8 + 4;  // colour, depth
    return static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) * pixel * (samples + 1);
}

void Frame::begin_scene() const noexcept {
    glBindFramebuffer(GL_FRAMEBUFFER, scene_.name());
    glViewport(0, 0, size_.x, size_.y);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_MULTISAMPLE);
    glDepthMask(GL_TRUE);
    constexpr float far = 1.0f;
    glClearNamedFramebufferfv(scene_.name(), GL_COLOR, 0, cavity);
    glClearNamedFramebufferfv(scene_.name(), GL_DEPTH, 0, &far);
}

void Frame::begin_smoke() const noexcept {
    glBlitNamedFramebuffer(scene_.name(), resolve_.name(), 0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y,
                           GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, smoke_.name());
}

void Frame::finish(GLuint framebuffer, const CameraResponse& response, const PlateShown& plate) const noexcept {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);  // post.frag encodes
    glBindTextureUnit(0, resolved_color_.name());
    glBindSampler(0, 0);  // the host's setting would blend pixels
    if (plate.picture != 0) {
        glBindTextureUnit(1, plate.picture);
        glBindSampler(1, 0);
    }
    glBindVertexArray(no_attributes_.name());
    std::array<glm::vec4, 4> camera = post_values(response, size_);
    if (plate.there && response.curve == ResponseCurve::shoulder) camera[1].w = 2.0f;
    post_.set("lapfx_camera", camera);
    post_.set("u_plate", plate.extent);
    post_.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace lapfx::render
