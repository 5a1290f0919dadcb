// Processor time, for the few tests that bound a cost: other programs on the machine do not count.
#pragma once

#include <ctime>

namespace lapfx::test {

/// Processor time of the calling thread, s.
inline double thread_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace lapfx::test
