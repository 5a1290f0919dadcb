// Time that the GPU spends between begin() and end(), summed up. Results are taken frames later, never waited for.
// Render thread, context current.
#pragma once

#include <array>
#include <cstdint>

#include "gl/objects.h"

namespace lapfx::gl {

void release_query(GLuint name);

class Timer {
  public:
    /// Off, or where the driver cannot count: measures nothing.
    explicit Timer(bool on);

    void begin() noexcept;
    void end() noexcept;

    double seconds() const { return seconds_; }     ///< of all spans that are known by now
    std::uint64_t spans() const { return spans_; }  ///< how many those are

  private:
    void collect() noexcept;

    static constexpr std::size_t queries = 8;  // more than a driver keeps frames in flight
    std::array<Name<release_query>, queries> names_;
    std::uint64_t begun_ = 0, collected_ = 0;
    bool on_ = false, running_ = false;
    double seconds_ = 0.0;
    std::uint64_t spans_ = 0;
};

}  // namespace lapfx::gl
