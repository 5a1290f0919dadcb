// Pictures whose amounts are known exactly: renders of scenes that a seed draws at random, as a camera and an encoder
// would leave them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "bench/measure/camera.h"

namespace lapfx::bench {

/// Context current; one thread.
class KnownRenders {
  public:
    /// `first_part`: of the random numbers (random.h); renders of other parts are others.
    explicit KnownRenders(std::uint32_t seed, std::uint32_t first_part = 0);
    ~KnownRenders();
    KnownRenders(const KnownRenders&) = delete;
    KnownRenders& operator=(const KnownRenders&) = delete;

    /// A view with one picture, whose camera stands where that of the baseline did or a little beside it; JPEG.
    KnownView still(int number);
    /// A view with `count` pictures up to 4 s after the baseline, whose camera wanders and whose instrument moves; they
    /// went through a video encoder. Each third is counted, after the first second.
    KnownView clip(int number, int count);
    /// A view with `count` pictures from the scene's begin to its end, whose camera stands still; they went through a
    /// video encoder.
    KnownView course(int number, int count);

    /// Writes a video of a view in which nothing happens but that camera and instrument move; 5 s.
    void write_clear(int number, const std::filesystem::path& file);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lapfx::bench
