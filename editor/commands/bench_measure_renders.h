// Pictures whose amounts are known exactly: renders of scenes that a seed draws at random, as a camera and an encoder
// would leave them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "lapfx/organ.h"

namespace lapfx::commands {

struct KnownFrame {
    Image picture;       ///< with noise and compression
    double blood = 0.0;  ///< share of the view, 0..1
    double veil = 0.0;   ///< mean over the view, 0..1
};

struct KnownView {
    Image baseline;  ///< before anything happened, with noise and compression
    std::vector<KnownFrame> frames;
};

/// Context current; one thread.
class KnownRenders {
  public:
    explicit KnownRenders(std::uint32_t seed);
    ~KnownRenders();
    KnownRenders(const KnownRenders&) = delete;
    KnownRenders& operator=(const KnownRenders&) = delete;

    /// Another view with one frame, compressed as JPEG.
    KnownView still();
    /// Another view with `count` frames over its whole scene, which went through a video encoder.
    KnownView clip(int count);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lapfx::commands
