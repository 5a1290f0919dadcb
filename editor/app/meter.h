// What the editor costs: for the status bar.
#pragma once

#include <cstddef>

#include "app/memory.h"
#include "app/preview/gpu_timer.h"

namespace lapfx::app {

class Meter {
  public:
    GpuTimer scene;  ///< the preview, on the GPU
    double ui = 0;   ///< s of the CPU for the last frame of the UI: built, laid out, drawn; the window tells
    /// Once a frame of the window, after it. `now`: s; `drawn`: it had another picture of the scene.
    void frame(double now, bool playing, bool drawn);
    /// Pictures of the scene per second while it plays, however often the window is drawn; 0: it does not play.
    double frames_per_second() const { return rate_; }
    ProcessMemory memory() const { return memory_; }  ///< at most a second old

  private:
    double last_ = -1, looked_ = -1e9, rate_ = 0;
    bool played_ = false;
    ProcessMemory memory_;
};

}  // namespace lapfx::app
