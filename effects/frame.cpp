#include "lapfx/frame.h"

#include "render/frame.h"

namespace lapfx {

struct Frame::State {
    render::Frame frame;
};

Frame::Frame() : state_(std::make_unique<State>()) {}
Frame::Frame(Frame&&) noexcept = default;
Frame& Frame::operator=(Frame&&) noexcept = default;
Frame::~Frame() = default;

void Frame::begin(glm::ivec2 size) {
    state_->frame.resize(size);
    state_->frame.begin_scene();
}
void Frame::begin_smoke() noexcept {
    state_->frame.begin_smoke();
}
unsigned Frame::depth() const noexcept {
    return state_->frame.scene_depth();
}
void Frame::finish(unsigned framebuffer, const CameraResponse& response) noexcept {
    state_->frame.finish(framebuffer, static_cast<float>(response.exposure), static_cast<float>(response.vignette));
}

}  // namespace lapfx
