#include "app/meter.h"

#include <unistd.h>

#include <cstdio>

namespace lapfx::app {

std::size_t resident_memory() {
    std::FILE* file = std::fopen("/proc/self/statm", "r");
    if (file == nullptr) return 0;
    std::size_t all = 0, resident = 0;
    const int read = std::fscanf(file, "%zu %zu", &all, &resident);
    std::fclose(file);
    return read == 2 ? resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) : 0;
}

void Meter::frame(double now, bool playing, bool drawn) {
    constexpr double weight = 0.1;  // of a new frame in the mean
    constexpr double look_every = 1;
    const double passed = now - last_;
    if (playing && played_ && drawn && passed > 0)
        rate_ = rate_ == 0 ? 1 / passed : rate_ + weight * (1 / passed - rate_);
    if (!playing) rate_ = 0;
    if (drawn || !playing || !played_) last_ = now;  // else one has seen nothing new yet
    played_ = playing;
    if (now - looked_ < look_every) return;
    looked_ = now;
    memory_ = resident_memory();
}

}  // namespace lapfx::app
