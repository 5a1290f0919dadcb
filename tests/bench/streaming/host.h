// A minimal host for the benchmarks: a frame under the smoke, and an organ to make smoke on.
#pragma once

#include <vector>

#include "bench/streaming/streaming.h"
#include "lapfx/organ.h"
#include "lapfx/tool.h"
#include "lapfx/view.h"

namespace lapfx {
struct Preset;
}

namespace lapfx::bench {

constexpr int screen_width = 1280, screen_height = 1024;  // the paper's

/// The frame of a host: colour to draw into, and the scene's depth. Context current.
class HostFrame {
  public:
    HostFrame();
    ~HostFrame();
    HostFrame(const HostFrame&) = delete;
    HostFrame& operator=(const HostFrame&) = delete;

    /// `share`: of the frame's width and height that is drawn.
    void bind(double share) const;
    unsigned framebuffer() const { return framebuffer_; }
    unsigned depth() const { return textures_[1]; }

  private:
    unsigned textures_[2] = {}, framebuffer_ = 0;
};

/// Waits until everything is drawn.
void finish_drawing();
/// The smallest possible organ.
Organ triangle();
/// The first `streams` clips over the whole view.
Preset smoke_of(int streams, const BenchClips& clips);
/// From 100 mm away.
View looking_on();
/// A tool that burns for ten minutes.
std::vector<ToolContact> burning();

}  // namespace lapfx::bench
