#include "lapfx/frame.h"

#include "gl/context_hold.h"
#include "gl/read_back.h"
#include "gl/state_guard.h"
#include "lapfx/error.h"
#include "render/frame.h"

namespace lapfx {

struct Frame::State {
    ~State() { context.enter(); }

    gl::ContextHold context;
    render::Frame frame;
    glm::ivec2 size{0};
    gl::Texture picture;  ///< what read() gives; made when it is first called
    gl::Framebuffer into_picture;
};

Frame::Frame() : state_(std::make_unique<State>()) {}
Frame::Frame(Frame&&) noexcept = default;
Frame& Frame::operator=(Frame&&) noexcept = default;
Frame::~Frame() = default;

void Frame::begin(glm::ivec2 size) {
    state_->frame.resize(size);
    state_->size = size;
    state_->frame.begin_scene();
}
void Frame::begin_smoke() noexcept {
    state_->frame.begin_smoke();
}
unsigned Frame::depth() const noexcept {
    return state_->frame.scene_depth();
}
void Frame::finish(unsigned framebuffer, const CameraResponse& response) noexcept {
    state_->frame.finish(framebuffer, response);
}

void Frame::read(std::span<std::uint8_t> rgba, const CameraResponse& response) {
    State& s = *state_;
    const std::size_t bytes = static_cast<std::size_t>(s.size.x) * static_cast<std::size_t>(s.size.y) * 4;
    if (bytes == 0 || rgba.size() != bytes)
        throw Error(Failure::bad_input,
                    Fault{.file = "",
                          .place = "rgba",
                          .reason = bytes == 0 ? "begin() has not been called"
                                               : std::to_string(rgba.size()) + " bytes; a frame of " +
                                                     std::to_string(s.size.x) + "x" + std::to_string(s.size.y) +
                                                     " pixels has " + std::to_string(bytes)});
    if (s.picture.size() != s.size) {
        s.picture = gl::Texture({.size = s.size, .format = GL_RGBA8});
        s.into_picture = gl::Framebuffer(s.picture, nullptr);
        if (glCheckNamedFramebufferStatus(s.into_picture.name(), GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
            s.picture = {};
            throw Error(
                Failure::runtime,
                Fault{.file = "", .place = "", .reason = "the driver cannot make a picture of the frame's size"});
        }
    }
    finish(s.into_picture.name(), response);
    gl::read_rgba(s.picture.name(), s.size, rgba);
}

}  // namespace lapfx
