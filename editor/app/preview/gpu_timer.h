// How long the GPU works on something, without waiting for it. Context current.
#pragma once

#include <array>

namespace lapfx::app {

class GpuTimer {
  public:
    GpuTimer() = default;
    ~GpuTimer();
    GpuTimer(const GpuTimer&) = delete;
    GpuTimer& operator=(const GpuTimer&) = delete;

    /// Around what is timed; not nested, in any thread of the context.
    void begin();
    void end();
    /// s, a mean over the last few that are known; 0: none yet.
    double seconds();

  private:
    static constexpr std::size_t count = 4;  ///< measurements under way, at most
    std::array<unsigned, count> queries_{};
    std::array<bool, count> pending_{};
    std::size_t next_ = 0;
    bool running_ = false;
    double mean_ = 0;
};

}  // namespace lapfx::app
