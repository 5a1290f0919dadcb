#include "app/timeline.h"

#include <algorithm>
#include <cmath>

namespace lapfx::app {

void Timeline::seek(double to) {
    time = std::clamp(to, 0.0, duration());
}

void Timeline::advance(double seconds, bool endless) {
    if (!playing()) return;
    double next = time + speed * seconds;
    const double begin = has_range ? range.low : 0;
    const double end = has_range ? range.high : duration();
    if (!endless && (next >= end || next < begin)) {
        if (loop && end > begin) {
            next = begin + std::fmod(std::fmod(next - begin, end - begin) + (end - begin), end - begin);
        } else {
            next = std::clamp(next, begin, end);
            speed = 0;
        }
    }
    time = next;
}

}  // namespace lapfx::app
