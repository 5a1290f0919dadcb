#include "app/meter.h"

namespace lapfx::app {

void Meter::frame(double now, bool playing, bool drawn) {
    constexpr double weight = 0.1;  // a new frame has this share in the mean
    constexpr double look_every = 1;
    const double passed = now - last_;
    if (playing && played_ && drawn && passed > 0)
        rate_ = rate_ == 0 ? 1 / passed : rate_ + weight * (1 / passed - rate_);
    if (!playing) rate_ = 0;
    if (drawn || !playing || !played_) last_ = now;  // while it plays, the time until the next picture counts
    played_ = playing;
    if (now - looked_ < look_every) return;
    looked_ = now;
    memory_ = ProcessMemory::now();
}

}  // namespace lapfx::app
