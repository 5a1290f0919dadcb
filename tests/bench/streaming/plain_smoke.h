// Smoke drawn exactly as in the paper, for comparison with lapfx: one rectangle over the whole view for each clip. Its
// fragments take the colour from the frame and the opacity from its luma by two thresholds, vary that by a Perlin noise
// texture, and are blended by alpha.
#pragma once

#include "bench/streaming/host.h"

namespace lapfx::bench {

class PlainSmoke {
  public:
    /// Sends the first frame of each clip. Context current. Throws Error (runtime).
    PlainSmoke(const BenchClips& clips, int streams);
    ~PlainSmoke();
    PlainSmoke(const PlainSmoke&) = delete;
    PlainSmoke& operator=(const PlainSmoke&) = delete;

    /// ms for one frame until everything is drawn, with every clip directly over the host's frame.
    double over_frame_ms(const HostFrame& host) const;
    /// The same with the clips over each other at their own resolution, and the result once over the host's frame.
    double at_clip_resolution_ms(const HostFrame& host) const;

  private:
    void draw_clips() const;

    unsigned clip_program_ = 0, lay_program_ = 0, vertices_ = 0;
    unsigned noise_ = 0, smoke_ = 0, smoke_framebuffer_ = 0;
    std::vector<unsigned> frames_;
};

}  // namespace lapfx::bench
