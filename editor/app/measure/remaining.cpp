#include "app/measure/remaining.h"

#include <algorithm>

namespace lapfx::app {

void Remaining::reached(double now, double share) {
    if (steps_.empty() || share > steps_.back().share) steps_.push_back({now, share});
    while (steps_.size() > 1 && steps_[1].time <= now - window) steps_.pop_front();
}

double Remaining::seconds(double now) const {
    if (steps_.empty()) return -1.0;
    const Step &first = steps_.front(), &last = steps_.back();
    const double gained = last.share - first.share;
    if (now - first.time < least || gained <= 0.0) return -1.0;
    return std::max(1.0 - last.share, 0.0) * (now - first.time) / gained;
}

}  // namespace lapfx::app
