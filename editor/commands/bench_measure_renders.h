// Pictures whose amounts are known exactly: renders of scenes that a seed draws at random, as a camera and an encoder
// would leave them.
#pragma once

#include <cstdint>
#include <memory>

#include "commands/bench_measure_camera.h"

namespace lapfx::commands {

/// Context current; one thread.
class KnownRenders {
  public:
    explicit KnownRenders(std::uint32_t seed);
    ~KnownRenders();
    KnownRenders(const KnownRenders&) = delete;
    KnownRenders& operator=(const KnownRenders&) = delete;

    /// A view with one picture, whose camera stands where that of the baseline did or a little beside it; JPEG.
    KnownView still(int number);
    /// A view with `count` pictures up to 4 s after the baseline, whose camera wanders and whose instrument moves; they
    /// went through a video encoder. Each third is counted, after the first second.
    KnownView clip(int number, int count);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lapfx::commands
