// The frame in which the editor shows a preset, for a host that has none of its own: linear light with four samples a
// pixel, smoke over the resolved picture, then the camera's response. A host that draws into it shows the pixels of the
// editor.
//
//     lapfx::Frame frame;
//     frame.begin({1280, 1024});                                     // bound and cleared
//     effects.draw_organ(view);                                      // and all else that is drawn, in linear light
//     frame.begin_smoke();
//     effects.draw_smoke(view, frame.depth());
//     frame.finish(0, {.exposure = 1.9});                            // into the window
//
// samples/host/host.cpp (below share/lapfx) is a whole program that does so. One thread: that of the context. It binds
// its own framebuffers, program, vertex array and texture (unit 0), sets the viewport, turns scissor test, blending,
// depth test and GL_FRAMEBUFFER_SRGB off and multisampling on, and leaves all that so.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>

#include "lapfx/api.h"
#include "lapfx/camera.h"

namespace lapfx {

class LAPFX_API Frame {
  public:
    /// In the context that is current. Throws Error: no_gl if none is, runtime when its shader does not compile.
    Frame();
    Frame(Frame&&) noexcept;
    Frame& operator=(Frame&&) noexcept;
    ~Frame();

    /// Begins a frame of `size` pixels, black and as deep as can be; memory for another size is freed. Throws Error:
    /// bad_input below 1x1 or beyond the driver's largest size, runtime when it cannot make the frame.
    void begin(glm::ivec2 size);
    /// Call this when all tissue and instruments are drawn. It binds their resolved picture, without a depth buffer:
    /// depth() has that as a texture.
    void begin_smoke() noexcept;
    /// The depth texture for Effects::draw_smoke(). Valid until a begin() of another size.
    unsigned depth() const noexcept;
    /// Writes the picture into `framebuffer` (0 = the window's), lower left corner first, sRGB-encoded.
    void finish(unsigned framebuffer, const CameraResponse& response = {}) noexcept;
    /// The same into main memory, for a host without a window: RGBA, four bytes a pixel, rows from the top. Waits for
    /// the GPU, and leaves the host's settings for packing pixels as they were. Throws Error (bad_input) before begin()
    /// and for another size than 4 bytes for each pixel; runtime when the driver has no memory for it.
    void read(std::span<std::uint8_t> rgba, const CameraResponse& response = {});

  private:
    struct LAPFX_HIDDEN State;
    std::unique_ptr<State> state_;
};

}  // namespace lapfx
