// Sums up the time that the GPU spends between begin() and end(). Results are read frames later, without waiting.
// Render thread, context current.
#pragma once

#include <array>
#include <cstdint>

#include "gl/objects.h"

namespace lapfx::gl {

void release_query(GLuint name);

class Timer {
  public:
    /// Measures nothing when it is off or the driver cannot count.
    explicit Timer(bool on);

    void begin() noexcept;
    void end() noexcept;

    double seconds() const { return seconds_; }     ///< sum of all spans that are known so far
    std::uint64_t spans() const { return spans_; }  ///< number of these spans

  private:
    void collect() noexcept;

    static constexpr std::size_t queries = 8;  // more than the frames that a driver keeps in flight
    std::array<Name<release_query>, queries> names_;
    std::uint64_t begun_ = 0, collected_ = 0;
    bool on_ = false, running_ = false;
    double seconds_ = 0.0;
    std::uint64_t spans_ = 0;
};

}  // namespace lapfx::gl
